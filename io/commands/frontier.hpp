// What the accuracy suite taught, for `thaw check`: settings on the frontier of error against time, of cases that a scene resembles.
#pragma once
#include <span>
#include <string>
#include <vector>

#include "core/scene/modules.hpp"

namespace thaw {

/// One setting of a case, at one spacing. settings: as `--set` takes it, with * for the name of a material; empty: the defaults. error < 0: it
/// blew up, or its books do not close. cost: core-seconds over those of the defaults. best: no other one beats it in both.
struct FrontierPoint {
  const char *cases, *norm, *settings;
  double error, cost;
  bool best;
};

/// Those of the cases that stand for a part of the model. Written by benchmarks/accuracy/frontier.py.
std::span<const FrontierPoint> frontierPoints();

/// Lines for the cases whose physics the scene has, and what of it all goes together; empty where the suite has none. Keys are those of
/// the scene: of its own materials, and without what it cannot use.
std::vector<std::string> frontierLines(const Scene& scene, const Modules& modules);

}  // namespace thaw
