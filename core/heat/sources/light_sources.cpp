// SPDX-License-Identifier: Apache-2.0
#include "core/heat/sources/light_sources.hpp"

#include <array>
#include <cmath>

#include "core/geometry/shapes/pose.hpp"
#include "core/scene/source_times.hpp"

namespace thaw {
namespace {

constexpr std::size_t areaPoints = 16;  ///< four along each edge

/// Returns the axes normal to the direction of an area lamp. The first one, along `width`, is horizontal.
std::array<Vec3d, 2> edgesOf(const Vec3d& direction) {
  const Vec3d flat = cross({0, 0, 1}, direction);
  const Vec3d side = length(flat) > 1e-9 ? normalized(flat) : Vec3d{1, 0, 0};
  return {side, cross(direction, side)};
}

/// Moves the light to point k of an area lamp. Successive points are far apart.
void placeInArea(const Lamp& lamp, const Pose& pose, std::size_t k, LightSource& light) {
  const std::array<Vec3d, 2> edges = edgesOf(normalized(lamp.direction));
  const auto at = [](std::size_t high, std::size_t low) {
    return (2 * static_cast<double>(high & 1) + static_cast<double>(low & 1) + 0.5) / 4 - 0.5;
  };
  light.profile = LightProfile::Cosine;
  light.position = fromRest(pose, lamp.position + edges[0] * (at(k, k >> 2) * lamp.width) +
                                      edges[1] * (at(k >> 1, k >> 3) * lamp.depth));
}

}  // namespace

std::vector<LightSource> lightSources(const Scene& s, double begin, double end, std::int64_t step) {
  std::vector<LightSource> list;
  const double middle = 0.5 * (begin + end);
  std::size_t number = 0;
  for (const Lamp& lamp : s.lamps) {
    const std::size_t source = static_cast<std::size_t>(&lamp - s.lamps.data()), first = number;
    number += lamp.kind == LampKind::Area ? areaPoints : 1;
    const double share = shareOn(lamp.start, lamp.end, begin, end);
    if (share == 0) continue;
    const Pose pose = poseAt(lamp.motion, middle);
    LightSource one;
    one.source = source;
    one.number = first;
    one.position = fromRest(pose, lamp.position);
    one.direction = normalized(directionFromRest(pose, lamp.direction));
    one.power = share * (lamp.kind == LampKind::Direction ? lamp.irradiance : lamp.power);
    if (lamp.kind == LampKind::Direction) one.profile = LightProfile::Uniform;
    if (lamp.kind == LampKind::Point) one.direction = {0, 0, 1};
    if (lamp.kind == LampKind::Area) {
      const std::size_t k = static_cast<std::size_t>(step) % areaPoints;
      placeInArea(lamp, pose, k, one);
      one.number += k;
    }
    list.push_back(one);
  }
  for (const Laser& laser : s.lasers) {
    const std::size_t first = number++;
    const double share = shareOn(laser.start, laser.end, begin, end);
    if (share == 0) continue;
    const Pose pose = poseAt(laser.motion, middle);
    LightSource one;
    one.source = s.lamps.size() + static_cast<std::size_t>(&laser - s.lasers.data());
    one.number = first;
    one.profile = LightProfile::Gaussian;
    one.power = share * laser.power;
    one.radius = laser.radius;
    one.depth = laser.absorptionDepth;
    one.position = fromRest(pose, laser.position);
    one.direction = normalized(directionFromRest(pose, laser.direction));
    one.laser = true;
    list.push_back(one);
  }
  return list;
}

double givenPower(const LightSource& s, const Domain& d) {
  if (s.profile != LightProfile::Uniform) return s.power;
  const Vec3d size = d.max - d.min;
  return s.power * (std::abs(s.direction.x) * size.y * size.z + std::abs(s.direction.y) * size.z * size.x +
                    std::abs(s.direction.z) * size.x * size.y);
}

}  // namespace thaw
