// SPDX-License-Identifier: Apache-2.0
#include "core/scene/expected_speeds.hpp"

#include <cstdio>

#include "core/scene/buoyancy.hpp"

namespace thaw {
namespace {

std::string numberText(const char* format, double value) {
  char digits[64];
  std::snprintf(digits, sizeof digits, format, value);
  return digits;
}

/// Returns the largest height of fall (m), at most the height of the domain.
double largestFall(const Scene& s) {
  const double g = length(s.domain.gravity);
  if (!(g > 0)) return 0;
  double height = 0;
  for (int a = 0; a < 3; a++)
    height += std::abs(s.domain.gravity[a]) / g * (s.domain.max[a] - s.domain.min[a]);
  return std::min(height, s.fallHeight + s.expected.lift);
}

}  // namespace

FlowSpeed expectedFlow(const Scene& s) {
  const ExpectedMotion& e = s.expected;
  const double g = length(s.domain.gravity), fall = largestFall(s);
  double given = 0;
  std::string by;
  const auto see = [&](double v, const std::string& who) {
    if (v > given) given = v, by = who;
  };
  if (e.start == 0)  // before set-up
    for (const Body& b : s.bodies) see(length(b.velocity), "the start of body '" + b.name + "'");
  if (e.emitted == 0)
    for (const Emitter& m : s.emitters) see(m.speed, "emitter '" + m.name + "'");
  see(e.start, "the start of " + e.startBy);
  see(e.emitted, e.emittedBy);
  see(e.driven, e.drivenBy);
  const double buoyant = buoyantSpeed(s);
  const double flow = std::sqrt(given * given + 2 * g * fall + buoyant * buoyant),
               column = std::sqrt(g * e.column);
  if (column > flow)
    return {column, "from the pressure of a column of " + numberText("%.3g m", e.column) +
                        " that an emitter can fill"};
  if (buoyant > 0 && buoyant * buoyant > given * given + 2 * g * fall)
    return {flow, "from buoyancy" + numberText(" (%.3g m/s)", buoyant)};
  const std::string falls = "a fall through " + numberText("%.3g m", fall);
  if (!(given > 0)) return {flow, flow > 0 ? "from " + falls : "nothing moves"};
  by += numberText(" (%.3g m/s)", given);
  return {flow, "from " + by + (fall > 0 ? " and " + falls : "")};
}

}  // namespace thaw
