// SPDX-License-Identifier: Apache-2.0
#include "core/solid/elasticity/rereference.hpp"

#include <algorithm>

#include "core/solid/elasticity/solid_state.hpp"
#include "core/solid/laws/green.hpp"
#include "core/solid/laws/neo_hookean.hpp"
#include "core/solid/laws/plasticity.hpp"

namespace thaw {

namespace {

/// Returns true if F is far enough from singular to be inverted. |F^-1|^2 is 3 at rest. It is 6 if the length
/// along one axis is halved, or the length along all axes is 0.71.
bool canFollow(const Mat3d& f) {
  const double j = determinant(f);
  const Mat3d c = cofactor(f);
  return j > 0 && dot(c.row[0], c.row[0]) + dot(c.row[1], c.row[1]) + dot(c.row[2], c.row[2]) < 6 * j * j;
}

/// Returns true if the bonds of a solid would still span the directions that they span now.
bool keepsRank(const ElasticWork& work, const Solids& solids, const Bonds& bonds, std::size_t solidIndex) {
  Sym3d a{};
  for (int k = 0; k < bonds.capacity; k++) {
    if (!bonds.hasBond(solidIndex, k)) continue;
    const BondVectors v = bondVectors(work, solids, bonds, solidIndex, k);
    a = a + v.weight * symmetric(outer(v.current, v.current));
  }
  return invertMoment(a).rank >= work.rank[solidIndex];
}

bool takesReference(const ElasticWork& work, const Solids& solids, const Bonds& bonds,
                    std::size_t solidIndex) {
  if (!work.flows[solidIndex] || work.rank[solidIndex] == 0) return false;
  const Mat3d gradU = solids.deformation[solidIndex] - identity3<double>();
  // After a recent update Fp^-1 is the elastic stretch, which may be large.
  const bool far = norm(plasticMetric(solids.plasticInverse[solidIndex])) > work.rereference &&
                   norm(greenStrain(gradU)) > 0.5 * work.rereference;
  return far && canFollow(solids.deformation[solidIndex]) && keepsRank(work, solids, bonds, solidIndex);
}

void takeReference(ElasticWork& work, Solids& solids, Bonds& bonds, std::size_t solidIndex) {
  const Mat3d gradU = solidGradient(work, solids, bonds, solidIndex);
  solids.plasticInverse[solidIndex] = pushForward(gradU, solids.plasticInverse[solidIndex]);
  solids.referenceGradient[solidIndex] = compose(gradU, solids.referenceGradient[solidIndex]);
  for (int k = 0; k < bonds.capacity; k++) {
    if (!bonds.hasBond(solidIndex, k)) continue;
    const std::size_t b = bonds.at(solidIndex, k);
    const Vec3d x = bondVectors(work, solids, bonds, solidIndex, k).current;
    bonds.x.set(b, x.x);
    bonds.y.set(b, x.y);
    bonds.z.set(b, x.z);
  }
  work.ownFrames[solidIndex / lanes] = 1;
  refreshSolid(work, solids, bonds, solidIndex);
}

}  // namespace

std::int64_t rereference(ElasticWork& work, Solids& solids, Bonds& bonds, const ElasticStep& step,
                         ExactSum& phaseJump) {
  if (!solids.rereferenced.active) return 0;
  std::int64_t count = 0;
  std::vector<std::uint32_t> groups;
  std::fill_n(solids.rereferenced.data(), solids.owned, std::uint8_t{0});
  forEachAwake(work, solids, [&](std::size_t first, std::size_t last) {
    for (std::size_t s = first; s < last; s++) {
      if (!takesReference(work, solids, bonds, s)) continue;
      solids.rereferenced[s] = 1;
      const DriftEnergy before = driftEnergy(work, solids, bonds, s, step.dt);
      takeReference(work, solids, bonds, s);
      recordJump(before, driftEnergy(work, solids, bonds, s, step.dt), phaseJump);
      count++;
      const auto g = static_cast<std::uint32_t>(s / lanes);
      if (groups.empty() || groups.back() != g) groups.push_back(g);
    }
  });
  if (count == 0) return 0;
  copyReferences(work, solids, bonds, work.inner, {0, solids.owned});
  copyReferences(work, solids, bonds, work.boundary, {0, solids.owned});
  repeatDeformation(work, solids, bonds, step, groups);
  return count;
}

}  // namespace thaw
