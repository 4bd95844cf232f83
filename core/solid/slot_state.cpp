#include "core/solid/slot_state.hpp"

#include "core/solid/laws/response.hpp"

namespace thaw {

BondVectors bondVectors(const ElasticWork& work, const Solids& solids, const Bonds& bonds, std::size_t slot, int k) {
  const std::size_t b = bonds.at(slot, k);
  BondVectors v;
  v.current = minimumImage(solids.position[bonds.neighbour[b]] - solids.position[slot], work.periods);
  v.reference = {bonds.x[b], bonds.y[b], bonds.z[b]};
  v.reverse = bonds.twoFrames ? Vec3d{bonds.rx[b], bonds.ry[b], bonds.rz[b]} : -v.reference;
  return v;
}

void refreshSlot(ElasticWork& work, Solids& solids, const Bonds& bonds, std::size_t slot) {
  Sym3d a{};
  double weights = 0;
  int last = 0;
  const bool single = work.precision == Precision::Single;
  for (int k = 0; k < bonds.capacity; k++) {
    const std::size_t b = bonds.at(slot, k);
    const double w = bonds.weight[b];
    if (single) {
      work.x[b] = static_cast<float>(bonds.x[b]);
      work.y[b] = static_cast<float>(bonds.y[b]);
      work.z[b] = static_cast<float>(bonds.z[b]);
      work.weight[b] = static_cast<float>(w);
      if (bonds.twoFrames) {
        work.rx[b] = static_cast<float>(bonds.rx[b]);
        work.ry[b] = static_cast<float>(bonds.ry[b]);
        work.rz[b] = static_cast<float>(bonds.rz[b]);
      }
    }
    if (!(w > 0)) continue;
    last = k + 1;
    const Vec3d x{bonds.x[b], bonds.y[b], bonds.z[b]};
    a = a + w * symmetric(outer(x, x));
    weights += w;
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
    const std::size_t b = bonds.at(slot, k);
    const Vec3d lever = bonds.weight[b] * (full(m.inverse) * Vec3d{bonds.x[b], bonds.y[b], bonds.z[b]});
    all += lever;
    lengths += length(lever);
  }
  work.grip[slot] = (m.rank < 3 ? flatGrip : 1) * (lengths + length(all));
  solids.changed[slot] = 0;
}

Mat3d slotGradient(const ElasticWork& work, const Solids& solids, const Bonds& bonds, std::size_t slot) {
  Mat3d sum{};
  for (int k = 0; k < bonds.capacity; k++) {
    const double w = bonds.weight[bonds.at(slot, k)];
    if (!(w > 0)) continue;
    const BondVectors v = bondVectors(work, solids, bonds, slot, k);
    sum = sum + outer(v.current - v.reference, w * v.reference);
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
  const Mat3d gradU = slotGradient(work, solids, bonds, slot);
  const ElasticConstants c = slotConstants(work, solids, slot);
  const Sym3d plastic = solids.plasticStrain.active ? solids.plasticStrain[slot] : Sym3d{};
  double errors = 0;
  for (int k = 0; k < bonds.capacity; k++) {
    const double w = bonds.weight[bonds.at(slot, k)];
    if (!(w > 0)) continue;
    const BondVectors v = bondVectors(work, solids, bonds, slot, k);
    const Vec3d e = v.current - v.reference - gradU * v.reference;
    errors += w * dot(e, e);
  }
  const double volume = solids.volume[slot];
  return volume * (elasticResponse(c, gradU, plastic).energy + 0.5 * c.hourglass * work.perTrace[slot] * errors);
}

}  // namespace thaw
