// SPDX-License-Identifier: Apache-2.0
#include "core/sheet/forces/brush_pressure.hpp"

#include <algorithm>
#include <cmath>

#include "core/geometry/shapes/pose.hpp"

namespace thaw {
namespace {

constexpr double finest = 0.125;  // brush radii between samples
constexpr double most = 4096;     // maximum number of samples per piece of the path

/// Falls from 1 at r2 = 0 to 0 at the radius, with zero slope at both ends. r2: m^2, squared distance.
double falloff(double r2, double radius) {
  const double u2 = r2 / (radius * radius);
  return u2 < 1 ? (1 - u2) * (1 - u2) : 0;
}

}  // namespace

std::vector<PressureSample> pressureSamples(const PressureBrush& b, double time, double dt) {
  const double from = time - 0.5 * dt, to = time + 0.5 * dt;
  std::vector<double> ends{from};  // pieces of constant velocity and factor slope
  for (const Keyframe& k : b.motion)
    if (k.time > from && k.time < to) ends.push_back(k.time);
  for (const auto& [when, factor] : b.inTime.points)
    if (when > from && when < to) ends.push_back(when);
  std::sort(ends.begin(), ends.end());
  ends.push_back(to);
  const auto centreAt = [&](double t) {
    return b.motion.empty() ? b.centre : fromRest(poseAt(b.motion, t), b.centre);
  };
  if (!(dt > 0) || (ends.size() == 2 && length(centreAt(to) - centreAt(from)) == 0)) {
    const double factor = b.inTime.at(time);
    return factor != 0 ? std::vector<PressureSample>{{centreAt(time), factor}}
                       : std::vector<PressureSample>{};
  }
  std::vector<PressureSample> samples;
  for (std::size_t k = 0; k + 1 < ends.size(); k++) {
    const double over = ends[k + 1] - ends[k];
    if (!(over > 0)) continue;
    // just inside the piece, because of keyframes with equal times the last one counts
    const double way = length(centreAt(ends[k] + 0.999999 * over) - centreAt(ends[k]));
    const auto touches = static_cast<int>(std::clamp(std::ceil(way / (finest * b.radius)), 1.0, most));
    for (int q = 0; q < touches; q++) {
      const double t = ends[k] + over * ((q + 0.5) / touches), share = b.inTime.at(t) * over / (dt * touches);
      if (share != 0) samples.push_back({centreAt(t), share});
    }
  }
  return samples;
}

Vec3d brushPressure(const PressureBrush& b, const std::vector<PressureSample>& samples, const Vec3d& place) {
  double share = 0;
  for (const PressureSample& t : samples) {
    const Vec3d d = place - t.centre;
    if (const double f = falloff(dot(d, d), b.radius); f > 0) share += t.share * f;
  }
  return share * b.pressure;
}

}  // namespace thaw
