#include "core/solid/rereference.hpp"

#include "core/solid/laws/neo_hookean.hpp"
#include "core/solid/plasticity.hpp"
#include "core/solid/slot_state.hpp"

namespace thaw {

namespace {

/// Is F far enough from singular? The push-forward multiplies the elastic strain by F^-T and F^-1: of a neighbourhood that a blow has
/// pressed flat it would make energy without bound. |F^-1|^2 is 3 at rest; 6 is half the length along one axis, or .71 along all.
bool canFollow(const Mat3d& f) {
  const double j = determinant(f);
  const Mat3d c = cofactor(f);
  return j > 0 && dot(c.row[0], c.row[0]) + dot(c.row[1], c.row[1]) + dot(c.row[2], c.row[2]) < 6 * j * j;
}

void takeReference(ElasticWork& work, Solids& solids, Bonds& bonds, std::size_t slot) {
  const Mat3d gradU = slotGradient(work, solids, bonds, slot);
  solids.plasticStrain[slot] = pushForward(gradU, solids.plasticStrain[slot]);
  solids.volume[slot] *= determinant(identity3<double>() + gradU);
  for (int k = 0; k < bonds.capacity; k++) {
    if (!bonds.there(slot, k)) continue;
    const std::size_t b = bonds.at(slot, k);
    const Vec3d x = bondVectors(work, solids, bonds, slot, k).current;
    bonds.x.set(b, x.x);
    bonds.y.set(b, x.y);
    bonds.z.set(b, x.z);
  }
  work.ownFrames[slot / lanes] = 1;
  refreshSlot(work, solids, bonds, slot);
}

}  // namespace

std::int64_t rereference(ElasticWork& work, Solids& solids, Bonds& bonds, const ElasticStep& step, ExactSum& phaseJump) {
  if (!solids.rereferenced.active) return 0;
  std::int64_t count = 0;
  std::vector<std::uint32_t> groups;
  for (std::size_t s = 0; s < solids.owned; s++) {
    const bool now = norm(solids.plasticStrain[s]) > work.rereference && work.rank[s] > 0 && canFollow(solids.deformation[s]);
    solids.rereferenced[s] = now;
    if (!now) continue;
    const double before = slotEnergy(work, solids, bonds, s);
    takeReference(work, solids, bonds, s);
    phaseJump.add(before - slotEnergy(work, solids, bonds, s));
    count++;
    const auto g = static_cast<std::uint32_t>(s / lanes);
    if (groups.empty() || groups.back() != g) groups.push_back(g);
  }
  if (count == 0) return 0;
  followReferences(work, solids, bonds, work.inner, {0, solids.owned});
  followReferences(work, solids, bonds, work.boundary, {0, solids.owned});
  repeatDeformation(work, solids, bonds, step, groups);
  return count;
}

}  // namespace thaw
