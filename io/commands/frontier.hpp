// What the accuracy suite taught, for `thaw check`: settings on the frontier of error against time, of cases that a scene resembles.
#pragma once
#include <span>
#include <string>
#include <vector>

#include "core/scene/modules.hpp"

namespace thaw {

/// One setting of a case, at one spacing. cost: core-seconds over those of the defaults at that spacing.
struct FrontierPoint { const char *cases, *norm, *settings; double error, cost; };

/// Those of all cases that no other setting beats in both error and time, and the defaults. Written by benchmarks/accuracy/frontier.py.
std::span<const FrontierPoint> frontierPoints();

/// Lines for the cases whose physics the scene has; empty where the suite has none.
std::vector<std::string> frontierLines(const Scene& scene, const Modules& modules);

}  // namespace thaw
