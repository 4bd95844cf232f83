// What the accuracy suite taught, for `thaw check`: settings on the frontier of error against time, of cases
// that a scene resembles.
#pragma once
#include <span>
#include <string>
#include <vector>

#include "core/scene/modules.hpp"

namespace thaw {

/// One setting of a case, at one spacing. settings: as `--set` takes it, with * for the name of a material;
/// empty: the defaults. error < 0: it blew up, or its books do not close. cost: core-seconds over those of
/// the defaults. best: no other one beats it in both.
struct FrontierPoint {
  const char *cases, *norm, *settings;
  double error, cost;
  bool best;
};

/// Those of the cases that stand for a part of the model. Written by benchmarks/accuracy/frontier.py.
std::span<const FrontierPoint> frontierPoints();

/// A line for each case whose physics the scene has, with all settings on its frontier; empty where the suite
/// has none. Keys are those of the scene: of its own materials, and without what it cannot use.
std::vector<std::string> frontierLines(const Scene& scene, const Modules& modules);

/// Settings ("key=value") on one line, as a shell takes them, each behind `before`.
std::string settingList(const std::vector<std::string>& settings, const char* before);

/// Settings ("key=value") and the line that recommends them.
struct Suggestion {
  std::vector<std::string> settings;
  std::string line;
};

/// One for each setting that gains accuracy or time in one of these cases and loses in none, measured one at
/// a time; without keys that the scene has chosen itself. What of it excludes each other is left out.
std::vector<Suggestion> frontierAdvice(const Scene& scene, const Modules& modules);

}  // namespace thaw
