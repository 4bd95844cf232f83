// SPDX-License-Identifier: Apache-2.0
#include "core/heat/sources/heat_sources.hpp"

#include <algorithm>
#include <cmath>

#include "core/geometry/shapes/pose.hpp"
#include "core/heat/sources/add_light.hpp"
#include "core/scene/source_times.hpp"

namespace thaw {
namespace {

/// Adds heat to a particle.
void give(const HeatView& w, std::size_t i, double flow, double dt, ExactSum& absorbed) {
  w.particles.heatFlow[i] += flow;
  w.particles.absorbed[i] += static_cast<float>(flow);
  w.ledger.heatIn.add(flow * dt);
  absorbed.add(flow * dt);
}

/// Creates an entry for each source of the scene. After a change of sources, the energy absorbed from each
/// one is unknown. If a type of source has heated anything, all sources of the type count as used.
void listSources(const Scene& s, Ledger& ledger) {
  if (ledger.sourceUse.size() == s.lamps.size() + s.lasers.size() + s.heatedRegions.size()) return;
  ledger.sourceUse.clear();
  const auto add = [&](std::size_t count, const SourceSums& sums) {
    ledger.sourceUse.resize(ledger.sourceUse.size() + count, {0, sums.absorbed.value() > 0});
  };
  add(s.lamps.size(), ledger.lamps);
  add(s.lasers.size(), ledger.lasers);
  add(s.heatedRegions.size(), ledger.regions);
}

/// Adds the absorbed part of the received light (W, by owned row), and records it with the reflected part.
void absorb(const HeatView& w, const std::vector<double>& received, double dt, SourceSums& sums) {
  for (std::size_t i = 0; i < received.size(); i++) {
    if (received[i] == 0) continue;
    const double flow = w.scene.materials[w.particles.material[i]].absorptivity * received[i];
    give(w, i, flow, dt, sums.absorbed);
    sums.reflected.add((received[i] - flow) * dt);
  }
}

/// Returns the largest step (s) in which a source with the rest position x (m) moves at most `most` (m). The
/// source may begin to move within the step.
template<class Source> double limitOf(const Source& source, const Vec3d& x, double time, double most) {
  double at = time, left = most;
  for (const Keyframe& next : source.motion) {
    const double until = std::min(next.time, source.end);
    if (!(until > at)) continue;
    const Pose pose = poseAt(source.motion, at);
    const double speed = length(velocityAt(pose, fromRest(pose, x)));
    if (speed * (until - at) > left) return at - time + left / speed;
    left -= speed * (until - at);
    at = until;
  }
  return never;
}

}  // namespace

double lightStepLimit(const Scene& s, double time) {
  const double half = 0.5 * s.spacing;
  double limit = never;
  for (const Lamp& l : s.lamps) limit = std::min(limit, limitOf(l, l.position, time, half));
  for (const Laser& l : s.lasers)
    limit = std::min(limit, limitOf(l, l.position, time, std::max(0.5 * l.radius, half)));
  return limit;
}

double regionStepLimit(const Scene& s, double time) {
  double limit = never;
  for (const HeatedRegion& r : s.heatedRegions)
    limit = std::min(limit, limitOf(r, r.shape.move, time, 0.5 * s.spacing));
  return limit;
}

void addLight(const LightTarget& to, double dt, Reducer& all) {
  const HeatView& w = to.heat;
  listSources(w.scene, w.ledger);
  const LightReceived light = receiveLight(to, dt, all);
  absorb(w, light.lamps, dt, w.ledger.lamps);
  absorb(w, light.lasers, dt, w.ledger.lasers);
}

// Particles receive heat in proportion to their mass. Sums of mass are exact.
void addRegionHeat(const HeatView& w, const std::vector<std::shared_ptr<const SignedDistance>>& shapes,
                   double dt, Reducer& all) {
  const Scene& s = w.scene;
  listSources(s, w.ledger);
  std::vector<std::vector<std::uint32_t>> rows(s.heatedRegions.size());
  std::vector<std::int64_t> digits;
  const double begin = w.clock.time, end = begin + dt;
  for (std::size_t k = 0; k < rows.size(); k++) {
    const HeatedRegion& region = s.heatedRegions[k];
    ExactSum mass;
    if (shareOn(region.start, region.end, begin, end) > 0) {
      rows[k] = rowsInRegion(region, *shapes[k], poseAt(region.motion, 0.5 * (begin + end)), w.particles);
      for (const std::uint32_t i : rows[k]) mass.add(w.particles.mass[i]);
    }
    mass.carry();
    digits.insert(digits.end(), mass.digit.begin(), mass.digit.end());
  }
  all.sum(digits);
  for (std::size_t k = 0; k < rows.size(); k++) {
    const HeatedRegion& region = s.heatedRegions[k];
    const double power = region.power * shareOn(region.start, region.end, begin, end);
    SourceUse& use = w.ledger.sourceUse[s.lamps.size() + s.lasers.size() + k];
    use.given += power * dt;
    if (power * dt > 0 && !rows[k].empty()) use.absorbed = 1;
    if (all.rank() == 0) w.ledger.regions.given.add(power * dt);
    ExactSum mass;
    std::copy_n(digits.data() + k * ExactSum::digits, ExactSum::digits, mass.digit.data());
    const double total = mass.value();
    for (const std::uint32_t i : rows[k])
      give(w, i, power * (w.particles.mass[i] / total), dt, w.ledger.regions.absorbed);
  }
}

std::vector<std::uint32_t> rowsInRegion(const HeatedRegion& region, const SignedDistance& shape,
                                        const Pose& pose, const Continuum& p) {
  std::vector<std::uint32_t> rows;
  const Bounds bounds = shape.bounds();
  for (std::size_t i = 0; i < p.owned; i++) {
    if (region.material >= 0 && p.material[i] != region.material) continue;
    const Vec3d x = toRest(pose, p.position[i]);
    if (nearBounds(bounds, x, 0) && shape.inside(x)) rows.push_back(static_cast<std::uint32_t>(i));
  }
  return rows;
}

}  // namespace thaw
