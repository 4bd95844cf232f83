// Written by benchmarks/accuracy/frontier.py from docs/accuracy/accuracy.csv; not by hand.
#include "io/commands/frontier.hpp"

namespace thaw {
namespace {

constexpr FrontierPoint points[] = {
    {"slabs", "L2(T)", "defaults", 9.89e-05, 1},
    {"slabs", "Linf(T)", "defaults", 0.00026, 1},
    {"sphere_bath", "mean T", "defaults", 0.0326, 1},
    {"sphere_bath", "mean T", "kernel=cubic", 0.0319, 1.5},
    {"sphere_bath", "mean T", "support=3", 0.0232, 1.8},
    {"sphere_bath", "mean T", "support=2.5", 0.0166, 2.1},
    {"sphere_bath", "centre T", "defaults", 0.0301, 1},
    {"sphere_bath", "centre T", "kernel=mcg03", 0.0284, 1.2},
    {"sphere_bath", "centre T", "support=2.5", 0.0273, 2.1},
    {"sphere_bath", "centre T", "support=1.5", 0.00198, 3.4},
};

}  // namespace

std::span<const FrontierPoint> frontierPoints() { return points; }

}  // namespace thaw
