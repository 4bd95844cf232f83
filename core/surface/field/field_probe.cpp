// SPDX-License-Identifier: Apache-2.0
#include "core/surface/field/field_probe.hpp"

#include <algorithm>
#include <cstring>

#include "core/surface/work/surface_tools.hpp"

namespace thaw {

ForceSums particleSumsOf(const Scene& scene, const Surface& s, const SurfaceTools& t) {
  ForceSums in;
  in.particle = t.relax.particle.data();
  in.particleColour = t.relax.particleColour.data();
  const double h = s.particleSupport / s.grid.support, narrow = nearSupport * scene.spacing / s.grid.support;
  in.perParticleSupport2 = static_cast<float>(1 / (h * h));
  in.perNearSupport2 = static_cast<float>(1 / (narrow * narrow));
  return in;
}

FieldProbe::FieldProbe(const Scene& scene, const Surface& s, const SurfaceTools& t)
    : scene_(scene),
      surface_(s),
      tools_(t),
      sums_(particleSumsOf(scene, s, t)),
      slope_(6 * s.grid.support / (s.particleSupport * s.particleSupport)) {}

void FieldProbe::around(const PlaceBox& box, std::uint64_t component, const Vec3d& ownPosition) {
  const Bins& bins = tools_.relax.particleBins;
  const std::uint64_t* of = surface_.particles.component.data();
  const double h = surface_.particleSupport, h2 = (1 + 1e-9) * h * h;
  const Vec3d& edges = surface_.grid.edge;
  const double edge = std::min({edges.x, edges.y, edges.z}), edge2 = edge * edge;
  block_.find(bins, box, h);
  if (listed_.size() < block_.count) listed_.resize(2 * block_.count);
  std::size_t n = 0;
  for (std::size_t k = 0; k < block_.count; k++) {
    const Vec3d& at = block_.at[k];
    listed_[n] = block_.row[k];
    n += (box.distance2(at) <= h2) & (dot(at - ownPosition, at - ownPosition) <= edge2) &
         (of[block_.row[k]] == component);
  }
  selectRows(listed_.data(), n, component);
}

void FieldProbe::selectRows(const std::uint32_t* rows, std::size_t count, std::uint64_t component) {
  rows_ = rows, count_ = count;
  tight_ = levelRiseOf(isoOffsetOf(tools_.relax.isoOffset, component) / scene_.spacing);
}

void FieldProbe::at(const Vec3d* x, std::size_t n, FieldSample* found) {
  static constexpr std::uint32_t self[most] = {0, 1, 2, 3, 4, 5, 6, 7}, group[1] = {0};
  const CellGrid& grid = surface_.grid;
  for (std::size_t k = 0; k < n; k++)
    for (int a = 0; a < 3; a++) {
      const std::uint32_t bits = fixedPoint(grid, x[k][a], a);
      std::memcpy(&place_[4 * k + static_cast<std::size_t>(a)], &bits, 4);
    }
  const std::uint64_t range[2] = {0, count_};
  ForceSums in = sums_;
  in.place = place_.data();
  in.self = self;
  in.firstParticle = range;
  in.particleRow = rows_;
  in.groups = group;
  in.groupCount = 1;
  in.overParticles = over_.data();
  tools_.relax.kernels->overParticles(in);
  for (std::size_t k = 0; k < n; k++) {
    const SurfelSums s{nullptr, over_.data(), static_cast<int>(k)};
    FieldSample& c = found[k] = {};
    c.value = s.particle(Colour);
    c.gradient = -slope_ * Vec3d{s.particle(Gradient), s.particle(Gradient + 1), s.particle(Gradient + 2)};
    if (!(c.value > 0)) continue;
    const double near = s.particle(Near);
    c.tight = near < tight_.densityMeasure ? 0.5 : 1;
    c.level = raisedLevel(tools_.relax.level.level(s.particle(SmoothColour) / c.value), near, tight_) *
              scene_.surface.isoLevel / 0.5;
  }
}

void forFieldAtSurfels(const Scene& scene, const Surface& s, SurfaceTools& t,
                       const std::vector<std::uint8_t>& probed,
                       const std::function<void(std::size_t, const FieldSample&)>& found) {
  GroupLists& l = t.relax.lists;
  listGroups(s, probed, t.relax.particleBins, t.relax.particleBins, {0, s.particleSupport}, l);
  FieldProbe probe(scene, s, t);
  std::array<Vec3d, FieldProbe::most> x;
  std::array<FieldSample, FieldProbe::most> field;
  for (std::size_t g = 0; g < l.groups(); g++) {
    const std::uint32_t* rows = &l.self[8 * g];
    for (std::size_t k = 0; k < l.lanes[g]; k++) x[k] = s.surfels.position[rows[k]];
    probe.selectRows(l.particle.data() + l.firstParticle[g], l.firstParticle[g + 1] - l.firstParticle[g],
                     s.surfels.component[rows[0]]);
    probe.at(x.data(), l.lanes[g], field.data());
    for (std::size_t k = 0; k < l.lanes[g]; k++) found(rows[k], field[k]);
  }
}

}  // namespace thaw
