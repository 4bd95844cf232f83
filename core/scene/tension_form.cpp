// SPDX-License-Identifier: Apache-2.0
#include "core/scene/tension_form.hpp"

#include <algorithm>
#include <cstdio>
#include <numbers>

namespace thaw {
namespace {

bool hasOwnAngle(const Obstacle& o) { return o.contactAngle < never; }

/// Returns true if there is a wall without a contact angle of its own.
bool hasPlainWalls(const Scene& s) {
  for (const auto& axis : s.domain.side)
    if (axis[0] == Side::Wall || axis[1] == Side::Wall) return true;
  return !std::all_of(s.obstacles.begin(), s.obstacles.end(), hasOwnAngle);
}

std::string inDegrees(double angle) {
  char degrees[32];
  std::snprintf(degrees, sizeof degrees, "%.4g", angle * (180 / std::numbers::pi));
  return std::string(degrees) + " degrees";
}

}  // namespace

std::vector<std::string> contactAnglesOf(const Scene& s, const Material& liquid) {
  std::vector<std::string> places;
  if (wettingOf(liquid.contactAngle) != 0 && hasPlainWalls(s))
    places.push_back("material '" + liquid.name + "' meets walls at " + inDegrees(liquid.contactAngle));
  for (const Obstacle& o : s.obstacles)
    if (hasOwnAngle(o) && wettingOf(o.contactAngle) != 0)
      places.push_back("liquids meet obstacle '" + o.name + "' at " + inDegrees(o.contactAngle));
  return places;
}

}  // namespace thaw
