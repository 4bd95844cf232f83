#include "io/commands/compare_command.hpp"

#include <fmt/format.h>

#include <cstdio>

#include "io/compare/compare.hpp"

namespace thaw {

CLI::App* addCompareCommand(CLI::App& app, CompareArguments& arguments) {
  CLI::App* command = app.add_subcommand("compare", "Compares two frames, checkpoints or runs (then their last checkpoints), particle by particle, bit by bit");
  command->add_option("A", arguments.a, "a frame, a checkpoint or the folder of a run")->required();
  command->add_option("B", arguments.b, "what to compare it with")->required();
  command->add_option("--tolerance", arguments.tolerance, "allowed difference, relative to the largest magnitude in each field; without it, bits count")
      ->check(CLI::NonNegativeNumber);
  command->footer("Exit code: 0 equal, 1 different, 3 a file cannot be read.");
  return command;
}

int compareCommand(const CompareArguments& arguments) {
  try {
    const Snapshot a = openSnapshot(arguments.a), b = openSnapshot(arguments.b);
    const Comparison result = compareSnapshots(a, b, {arguments.tolerance});
    fmt::print("A: {}\nB: {}\n", a.file.path(), b.file.path());
    for (const std::string& line : describe(result)) fmt::print("{}\n", line);
    return result.equal() ? 0 : 1;
  } catch (const IoError& e) {
    fmt::print(stderr, "thaw compare: {}\n", e.what());
  } catch (const std::bad_alloc&) {
    fmt::print(stderr, "thaw compare: out of memory\n");
  }
  return exitInputOutput;
}

}  // namespace thaw
