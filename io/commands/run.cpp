// SPDX-License-Identifier: Apache-2.0
#include "io/commands/run.hpp"

#include <sys/ioctl.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <memory>
#include <optional>

#include "io/run/signals.hpp"
#include "io/scene/scene_for_all.hpp"
#include "io/simulation/simulation.hpp"
#include "io/text/number_options.hpp"

namespace thaw {
namespace {

/// Accepts finite numbers of at least 0. The message of CLI11 names the largest double.
CLI::Validator notBelowZero() {
  return {[](std::string& text) {
            char* end = nullptr;
            const double v = std::strtod(text.c_str(), &end);
            return *end == 0 && v >= 0 && v < never ? std::string()
                                                    : "must be a number of at least 0, got " + text;
          },
          "", ""};
}

/// Writes to a terminal: lines scroll, and a status line stays below them.
class TerminalLog {
 public:
  void say(const std::string& line) {
    std::printf("\r\033[K%s\n", line.c_str());
    draw();
  }
  void status(const std::string& line) {
    status_ = line;
    draw();
    if (line.find('>') == line.npos) end();  // the bar is full: no line follows it
  }
  ~TerminalLog() { end(); }

 private:
  void end() {
    if (!status_.empty()) std::printf("\n"), std::fflush(stdout);
    status_.clear();
  }
  /// Draws the status line, cut to the terminal's width: a wrapped line could not be redrawn.
  void draw() const {
    winsize size{};
    const bool known = ::ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 1;
    const std::size_t columns = known ? size.ws_col - 1u : 79;
    if (!status_.empty()) std::printf("\r%s\033[K", status_.substr(0, columns).c_str());
    std::fflush(stdout);
  }
  std::string status_;
};

/// Returns whether a launcher such as mpirun started this process. Reads the initial environment, since MPI
/// later adds variables of its own.
bool launched() {
  std::ifstream file("/proc/self/environ", std::ios::binary);
  for (std::string entry; std::getline(file, entry, '\0');)
    for (const char* name :
         {"OMPI_COMM_WORLD_SIZE=", "PMIX_RANK=", "PMI_RANK=", "PMI_SIZE=", "SLURM_PROCID="})
      if (entry.rfind(name, 0) == 0) return true;
  return false;
}

/// Returns whether lines may be redrawn. Under a launcher, isatty is true on every rank even if the output
/// goes to a file.
bool drawsInPlace() {
  const char* term = std::getenv("TERM");
  return ::isatty(STDOUT_FILENO) == 1 && term && std::string(term) != "dumb" && !launched();
}

/// Sends lines of the run to standard output.
void setOutput(RunOptions& o) {
  if (!drawsInPlace()) {
    o.log = [](const std::string& line) { std::printf("%s\n", line.c_str()), std::fflush(stdout); };
    return;
  }
  const auto terminal = std::make_shared<TerminalLog>();
  o.log = [terminal](const std::string& line) { terminal->say(line); };
  o.status = [terminal](const std::string& line) { terminal->status(line); };
}

void addForce(CLI::App& c, RunOptions& o) {
  c.add_flag(
      "--force", o.force,
      "take over --out although a run on another host left its lock there; only if that run has ended");
}

}  // namespace

void addRunOptions(CLI::App& c, RunOptions& o) {
  c.add_option("scene", o.scene, "scene file (TOML)")->required();
  c.add_option("--out", o.out, "folder for frames, checkpoints and the summary (default: out/<scene>)");
  c.add_option("--set", o.overrides, "override a key of the scene: key=value; may be repeated")
      ->allow_extra_args(false);
  c.add_option("--steps", o.steps, "stop when the run has this many steps, restarts included")
      ->check(notBelowZero());
  c.add_option("--time-limit", o.timeLimit,
               "stop, with a checkpoint, after this many seconds of wall-clock time")
      ->check(aboveZero());
  c.add_option("--progress", o.reportEvery, "seconds between progress lines")->check(notBelowZero());
  auto* profile = c.add_flag("--profile", o.profile,
                             "print the time of each phase on all ranks, and write a trace of the last steps "
                             "to trace.json in --out");
  c.add_option("--trace-steps", o.traceSteps, "number of last steps in the trace")
      ->check(CLI::Range(1, 10000))
      ->needs(profile)
      ->capture_default_str();
  auto* restart = c.add_flag("--restart", o.restart, "continue from the last checkpoint in --out");
  c.add_flag("--resume", o.resume, "continue if there is a checkpoint in --out, else start")
      ->excludes(restart);
  addForce(c, o);
}

void addRelaxOptions(CLI::App& c, RunOptions& o) {
  c.add_option("scene", o.scene, "scene file (TOML) with oriented bodies")->required();
  c.add_option("--out", o.out,
               "folder for the frame and a checkpoint from which `thaw run --restart` continues (default: "
               "out/<scene>)");
  c.add_option("--set", o.overrides, "override a key of the scene: key=value; may be repeated")
      ->allow_extra_args(false);
  c.add_option("--iterations", o.relax, "largest number of iterations")->check(aboveZero());
  c.add_option("--time-limit", o.timeLimit,
               "stop, with a frame and a checkpoint, after this many seconds of wall-clock time")
      ->check(aboveZero());
  c.add_option("--progress", o.reportEvery, "seconds between progress lines")->check(notBelowZero());
  addForce(c, o);
}

int runCommand(const RunOptions& given) {
  RunOptions options = given;
  if (options.out.empty()) options.out = "out/" + std::filesystem::path(options.scene).stem().string();
  setOutput(options);
  catchSignals();
  int rank = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  const auto failed = [rank](const std::string& message, int code) {
    if (rank == 0) std::fprintf(stderr, "%s\n", message.c_str());
    return code;
  };
  std::optional<Simulation> sim;
  try {
    sim.emplace(options);
    try {
      sim->run();
    } catch (const BlewUp& e) {
      failed(std::string("error: ") + e.what() +
                 (sim->scene().numerics.fixedStep > 0 ? "; `numerics.fixed_step` may be too long" : ""),
             exitBlewUp);
    }
    return sim->finish();
  } catch (const std::exception& e) {
    if (const auto refusal = refusalOf(e)) return failed(refusal->message, refusal->code);
    // Set-up fails alike on all ranks. Later, other ranks may be in a collective call.
    if (!sim && dynamic_cast<const std::runtime_error*>(&e))
      return failed(options.scene + ": error: " + e.what(), exitUsage);
    std::fprintf(stderr, "error: rank %d: %s\n", rank, e.what());
    MPI_Abort(MPI_COMM_WORLD, 1);
    return 1;
  }
}

}  // namespace thaw
