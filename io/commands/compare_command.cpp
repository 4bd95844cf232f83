// SPDX-License-Identifier: Apache-2.0
#include "io/commands/compare_command.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <set>

#include "io/checkpoint/damaged_rows.hpp"
#include "io/compare/compare.hpp"
#include "io/text/command_error.hpp"
#include "io/text/number_options.hpp"

namespace thaw {
namespace {

bool compareFiles(const std::string& pathA, const std::string& pathB, const CompareArguments& how,
                  bool alwaysReport) {
  const Snapshot a = openSnapshot(pathA), b = openSnapshot(pathB);
  const Comparison result = compareSnapshots(a, b, {how.tolerance});
  if (!alwaysReport && result.equal()) return true;
  if (!result.equal())
    for (const Snapshot* s : {&a, &b})
      if (const std::vector<std::string> damaged = damagedRows(s->file); !damaged.empty())
        throw IoError(s->file.path(), damageText(damaged));
  fmt::print("A: {}\nB: {}\n", a.file.path(), b.file.path());
  for (const std::string& line : describe(result, how.all)) fmt::print("{}\n", line);
  return result.equal();
}

/// Returns the names of all frame files of a run. Throws IoError without a folder of frames.
std::set<std::string> framesOf(const std::string& run) {
  const std::filesystem::path folder = std::filesystem::path(run) / "frames";
  if (!std::filesystem::is_directory(folder)) throw IoError("'" + run + "' has no folder frames/ to compare");
  std::set<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    if (entry.path().extension() == ".hdf") names.insert(entry.path().filename().string());
  return names;
}

bool compareFrames(const CompareArguments& how) {
  const std::string &runA = how.a, &runB = how.b;
  const std::set<std::string> a = framesOf(runA), b = framesOf(runB);
  if (std::none_of(a.begin(), a.end(), [&](const std::string& name) { return b.count(name) > 0; })) {
    const auto first = [](const std::set<std::string>& names) {
      return names.empty() ? std::string("none") : *names.begin();
    };
    fmt::print("frames: no name is in both runs, so none are compared (first of A: {}, of B: {})\n", first(a),
               first(b));
    return a.empty() && b.empty();
  }
  bool equal = true;
  std::size_t both = 0, alone = 0;
  const auto missing = [&](const std::string& name, const std::string& run) {
    fmt::print("frame {} is not in {}\n", name, run);
    alone++;
  };
  for (const std::string& name : b)
    if (!a.count(name)) missing(name, runA);
  for (const std::string& name : a) {
    if (!b.count(name)) {
      missing(name, runB);
      continue;
    }
    both++;
    const bool same = compareFiles(runA + "/frames/" + name, runB + "/frames/" + name, how, false);
    equal = equal && same;
  }
  fmt::print("frames: {} in both, {}{}\n", both, equal ? "equal" : "different",
             alone > 0 ? fmt::format("; {} in only one", alone) : "");
  return equal && alone == 0;
}

}  // namespace

CLI::App* addCompareCommand(CLI::App& app, CompareArguments& arguments) {
  CLI::App* command = app.add_subcommand("compare",
                                         "compare two frames, checkpoints or runs (by their last "
                                         "checkpoints), particle by particle and bit by bit");
  command->add_option("A", arguments.a, "a frame, a checkpoint or a run folder")->required();
  command->add_option("B", arguments.b, "the frame, checkpoint or run folder to compare with")->required();
  command
      ->add_option("--tolerance", arguments.tolerance,
                   "allowed difference, relative to the largest magnitude in each field; without it, values "
                   "must match bit for bit")
      ->check(finiteNumber())
      ->check(CLI::NonNegativeNumber);
  command->add_flag("--frames", arguments.frames, "compare all frames of two runs as well");
  command->add_flag("--all", arguments.all, "list all general differences, not only a few of each kind");
  command->footer("Exit code: 0 equal, 1 different, 3 unreadable or damaged file.");
  return command;
}

int compareCommand(const CompareArguments& arguments) {
  try {
    const bool equal = compareFiles(arguments.a, arguments.b, arguments, true);
    const bool equalFrames = !arguments.frames || compareFrames(arguments);
    return equal && equalFrames ? 0 : 1;
  } catch (const IoError& e) { printCommandError("compare", e.what()); } catch (const std::bad_alloc&) {
    printCommandError("compare", "out of memory");
  }
  return exitInputOutput;
}

}  // namespace thaw
