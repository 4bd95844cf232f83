#include "core/solid/slot_state.hpp"

#include "core/solid/laws/response.hpp"

namespace thaw {

ReferenceBond referenceBond(const ElasticWork& work, const Solids& solids, const Bonds& bonds, std::size_t slot, int k) {
  const std::size_t b = bonds.at(slot, k);
  if (bonds.vectors) return {{bonds.x[b], bonds.y[b], bonds.z[b]}, bonds.weight[b]};
  const Vec3d x = minimumImage(solids.reference[bonds.neighbour[b]] - solids.reference[slot], work.periods);
  return {x, bondWeight(x, work.support)};
}

BondVectors bondVectors(const ElasticWork& work, const Solids& solids, const Bonds& bonds, std::size_t slot, int k) {
  const std::size_t b = bonds.at(slot, k);
  const ReferenceBond r = referenceBond(work, solids, bonds, slot, k);
  return {minimumImage(solids.position[bonds.neighbour[b]] - solids.position[slot], work.periods), r.vector,
          bonds.twoFrames ? Vec3d{bonds.rx[b], bonds.ry[b], bonds.rz[b]} : -r.vector, r.weight};
}

void refreshSlot(ElasticWork& work, Solids& solids, const Bonds& bonds, std::size_t slot) {
  Sym3d a{};
  double weights = 0;
  int last = 0;
  for (int k = 0; k < bonds.capacity; k++) {
    if (!bonds.there(slot, k)) continue;
    last = k + 1;
    const ReferenceBond b = referenceBond(work, solids, bonds, slot, k);
    a = a + b.weight * symmetric(outer(b.vector, b.vector));
    weights += b.weight;
  }
  const MomentInverse m = invertMoment(a);
  const std::size_t g = slot / lanes;
  solids.momentInverse[slot] = m.inverse;
  work.rank[slot] = static_cast<std::uint8_t>(m.rank);
  const auto bit = static_cast<std::uint8_t>(1u << slot % lanes);
  work.singularLanes[g] = static_cast<std::uint8_t>(m.rank < 3 ? work.singularLanes[g] | bit : work.singularLanes[g] & ~bit);
  work.bondCount[g] = std::max(work.bondCount[g], static_cast<std::uint16_t>(last));
  work.perTrace[slot] = trace(a) > 0 ? 1 / trace(a) : 0;
  work.perWeight[slot] = weights > 0 ? 1 / weights : 0;
  Vec3d all{};
  double lengths = 0;
  for (int k = 0; k < last; k++) {
    if (!bonds.there(slot, k)) continue;
    const ReferenceBond b = referenceBond(work, solids, bonds, slot, k);
    const Vec3d lever = b.weight * (full(m.inverse) * b.vector);
    all += lever;
    lengths += length(lever);
  }
  work.grip[slot] = (m.rank < 3 ? flatGrip : 1) * (lengths + length(all));
  solids.changed[slot] = 0;
}

Mat3d slotGradient(const ElasticWork& work, const Solids& solids, const Bonds& bonds, std::size_t slot) {
  Mat3d sum{};
  for (int k = 0; k < bonds.capacity; k++) {
    if (!bonds.there(slot, k)) continue;
    const BondVectors v = bondVectors(work, solids, bonds, slot, k);
    sum = sum + outer(v.current - v.reference, v.weight * v.reference);
  }
  const Mat3d gradU = sum * full(solids.momentInverse[slot]);
  return work.rank[slot] < 3 ? completeGradient(gradU, solids.momentInverse[slot], work.rank[slot]) : gradU;
}

ElasticConstants slotConstants(const ElasticWork& work, const Solids& solids, std::size_t slot) {
  const std::size_t m = solids.material[slot];
  const double liquid = solids.liquid.active ? static_cast<double>(solids.liquid[slot]) : 0;
  return liquid > 0 ? elasticConstants(work.materials[m], liquid) : work.solidConstants[m];
}

double slotEnergy(const ElasticWork& work, const Solids& solids, const Bonds& bonds, std::size_t slot) {
  return slotEnergy(work, solids, bonds, slot, slotGradient(work, solids, bonds, slot));
}

double slotEnergy(const ElasticWork& work, const Solids& solids, const Bonds& bonds, std::size_t slot, const Mat3d& gradU) {
  const ElasticConstants c = slotConstants(work, solids, slot);
  const Sym3d plastic = solids.plasticStrain.active ? solids.plasticStrain[slot] : Sym3d{};
  double errors = 0;
  for (int k = 0; k < bonds.capacity; k++) {
    if (!bonds.there(slot, k)) continue;
    const BondVectors v = bondVectors(work, solids, bonds, slot, k);
    const Vec3d e = v.current - v.reference - gradU * v.reference;
    errors += v.weight * dot(e, e);
  }
  const double volume = solids.volume[slot];
  return volume * (elasticResponse(c, gradU, plastic).energy + 0.5 * c.hourglass * work.perTrace[slot] * errors);
}

}  // namespace thaw
