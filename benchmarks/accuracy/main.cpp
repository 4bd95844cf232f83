// SPDX-License-Identifier: Apache-2.0
// accuracy CASE [--spacing X] [--set key=value]... [--csv FILE] [--points FILE] [--label TEXT] [--strict]
//          [--limit NORM=ERROR]...
// Runs one case of the accuracy suite on any number of ranks and prints its error norms with their targets.
// --strict exits with 1 if a target is missed, --limit if that norm is larger; the tests use both
// (tests/CMakeLists.txt). accuracy --list names the cases. scripts/bench accuracy runs the whole matrix and
// draws its charts.
#include <sys/utsname.h>

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <thread>

#include "benchmarks/accuracy/gathered.hpp"
#include "io/hdf5/parallel_file.hpp"
#include "io/scene/read_scene.hpp"
#include "io/scene/scene_for_all.hpp"
#include "io/text/version.hpp"

namespace {

using namespace thaw;
using namespace thaw::accuracy;

/// Replaces characters that end a field of the CSV file.
std::string field(std::string text) {
  for (char& c : text)
    if (c == ',' || c == '"') c = ' ';
  return text;
}

/// The processor's name and the number of cores, without commas.
std::string machineName() {
  std::string name = "unknown";
  std::ifstream info("/proc/cpuinfo");
  for (std::string line; std::getline(info, line);)
    if (line.rfind("model name", 0) == 0) {
      name = line.substr(line.find(':') + 2);
      break;
    }
  return field(name) + " x" + std::to_string(std::thread::hardware_concurrency());
}

void print(const Trial& r, const Case& c, const std::vector<Figure>& figures, double particles) {
  std::printf("%s: %s\n  spacing %g m, %.0f particles, %lld steps, %.3g core-seconds, %d ranks\n", c.name,
              c.about, r.world.scene.spacing, particles, static_cast<long long>(r.world.clock.step),
              r.coreSeconds, r.comm.size());
  for (const Figure& f : figures) {
    std::printf("  %-28s %.6g", f.norm.c_str(), f.error);
    if (f.target < never)
      std::printf("   target %g   %s", f.target, f.error <= f.target ? "reached" : "MISSED");
    std::printf("\n");
  }
}

/// Message about the first norm above its target (strict) or its limit, or about a missing limited norm.
/// Empty if there is none.
std::string missed(const std::vector<Figure>& figures, bool strict, const std::vector<std::string>& limits) {
  if (strict)
    for (const Figure& f : figures)
      if (f.target < never && !(f.error <= f.target))
        return fmt::format("{} is {:g}, above its target {:g}", f.norm, f.error, f.target);
  for (const std::string& limit : limits) {
    const std::size_t sign = limit.rfind('=');
    const std::string norm = limit.substr(0, sign);
    const auto at = std::find_if(figures.begin(), figures.end(),
                                 [&](const Figure& f) { return f.norm == norm; });
    if (sign == std::string::npos || at == figures.end()) return fmt::format("there is no norm '{}'", norm);
    const double most = std::strtod(limit.c_str() + sign + 1, nullptr);
    if (!(at->error <= most)) return fmt::format("{} is {:g}, above {:g}", norm, at->error, most);
  }
  return {};
}

/// Appends a line per figure. matrix.py writes the header.
bool append(const std::string& path, const Trial& r, const Case& c, const std::string& label,
            const std::vector<Figure>& figures, double particles) {
  FILE* out = std::fopen(path.c_str(), "a");
  if (!out) return false;
  for (const Figure& f : figures)
    std::fprintf(
        out, "%s,%s,%s,%.9g,%s,,%.4g,%lld,%.0f,%s,%s\n", c.name, field(label).c_str(), field(f.norm).c_str(),
        f.error, f.target < never ? fmt::format("{:g}", f.target).c_str() : "", r.coreSeconds,
        static_cast<long long>(r.world.clock.step), particles, versionCommit(), machineName().c_str());
  return std::fclose(out) == 0;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("One case of the accuracy suite: error norms against exact solutions.");
  std::string name, spacing, csv, points, label;
  std::vector<std::string> overrides, limits;
  bool list = false, strict = false;
  app.add_option("case", name, "name of the case");
  app.add_option("--spacing", spacing, "particle spacing, with its unit");
  app.add_option("--set", overrides, "key=value, replaces a key of the case's scene")
      ->allow_extra_args(false);
  app.add_option("--csv", csv, "append the figures to this file");
  app.add_option("--points", points, "write the middle layer of particles at the end to this file");
  app.add_option("--label", label, "name of the settings in that file");
  app.add_flag("--strict", strict, "exit with 1 if a target is missed");
  app.add_option("--limit", limits, "NORM=ERROR: exit with 1 if that norm is larger")
      ->allow_extra_args(false);
  app.add_flag("--list", list, "print the names of all cases");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& e) {
    return e.get_exit_code() == 0 ? app.exit(e) : (app.exit(e), exitUsage);
  }
  useRomio();
  const MpiSession mpi(&argc, &argv);
  const Communicator comm;
  const std::vector<Case> cases = allCases();
  if (list) {
    if (comm.rank() == 0)
      for (const Case& c : cases) std::printf("%-24s %s\n", c.name, c.about);
    return 0;
  }
  const auto at = std::find_if(cases.begin(), cases.end(), [&](const Case& c) { return name == c.name; });
  if (at == cases.end()) {
    if (comm.rank() == 0)
      std::fprintf(stderr, "accuracy: there is no case '%s'; --list names them\n", name.c_str());
    return exitUsage;
  }
  if (label.empty()) {
    label = overrides.empty() ? "default" : "";
    if (!spacing.empty()) label += (label.empty() ? "spacing=" : " spacing=") + spacing;
    for (const std::string& o : overrides) label += (label.empty() ? "" : " ") + o;
  }
  if (!spacing.empty()) overrides.push_back("spacing=" + spacing);
  Trial trial(comm);
  try {
    run(*at, trial, overrides);
    const std::vector<Figure> figures = trial.finite
                                            ? at->measure(trial)
                                            : std::vector<Figure>{{"blew up at (s)", trial.world.clock.time}};
    const double particles = sum(trial, [](const World&, std::size_t) { return 1.0; });
    if (!points.empty() && !writeMiddleLayer(trial, points))
      return std::fprintf(stderr, "accuracy: cannot write %s\n", points.c_str()), 3;
    if (comm.rank() != 0) return 0;
    print(trial, *at, figures, particles);
    if (!csv.empty() && !append(csv, trial, *at, label, figures, particles))
      return std::fprintf(stderr, "accuracy: cannot write %s\n", csv.c_str()), 3;
    if (!trial.finite) return exitBlewUp;
    const std::string miss = missed(figures, strict, limits);
    if (!miss.empty()) std::fprintf(stderr, "accuracy: %s: %s\n", name.c_str(), miss.c_str());
    return miss.empty() ? 0 : 1;
  } catch (const std::runtime_error& e) {
    if (comm.rank() == 0) std::fprintf(stderr, "%s\n", e.what());
    return exitUsage;
  }
}
