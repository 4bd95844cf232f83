// SPDX-License-Identifier: Apache-2.0
// Advice of `thaw check`: settings on the frontier of error against time, from cases of the accuracy suite
// that resemble the scene.
#pragma once
#include <span>
#include <string>
#include <vector>

#include "core/scene/modules.hpp"

namespace thaw {

/// A setting of a case at one spacing. settings: as for `--set`, with * for the name of a material; empty:
/// the defaults. error < 0: the run failed, or its ledger does not close. cost: core seconds, divided
/// by those of the defaults. best: no other point has both less error and less cost.
struct FrontierPoint {
  std::string cases, norm, settings;
  double error = 0, cost = 0;
  bool best = false;
};

/// Points of the reference cases (frontier_file.hpp).
using FrontierPoints = std::span<const FrontierPoint>;

/// Returns a line for each case whose physics the scene has, with all settings on its frontier. Keys name the
/// materials of the scene; keys without use in the scene are left out.
std::vector<std::string> frontierLines(FrontierPoints points, const Scene& scene, const Modules& modules);

/// Returns settings ("key=value") on one line, quoted for a shell, each preceded by `before`.
std::string settingList(const std::vector<std::string>& settings, const char* before);

/// Settings ("key=value") and the line that recommends them.
struct Suggestion {
  std::vector<std::string> settings;
  std::string line;
};

/// Returns a suggestion for each setting that gains accuracy or time in one of these cases and loses in none.
/// The cases vary one setting at a time. Leaves out keys that the scene sets, and settings that exclude a
/// better one.
std::vector<Suggestion> frontierAdvice(FrontierPoints points, const Scene& scene, const Modules& modules);

}  // namespace thaw
