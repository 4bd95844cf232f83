// SPDX-License-Identifier: Apache-2.0
#include "core/solid/elasticity/solid_state.hpp"

#include <span>
#include <utility>
#include <vector>

#include "core/solid/elasticity/reference_kernels.hpp"
#include "core/solid/laws/plasticity.hpp"
#include "core/solid/laws/response.hpp"

namespace thaw {

namespace {

/// Reference X_ij (m) and weight of bond k of a solid, for both storage forms (Bonds::vectors). It is inlined
/// in loops over solids, since it takes most of their time.
inline ReferenceBond lookAtReference(const ElasticWork& work, const Solids& solids, const Bonds& bonds,
                                     std::size_t solidIndex, int k) {
  const std::size_t b = bonds.at(solidIndex, k);
  if (bonds.vectors) return {{bonds.x[b], bonds.y[b], bonds.z[b]}, bonds.weight[b]};
  const Vec3d x = minimumImage(solids.reference[bonds.neighbour[b]] - solids.reference[solidIndex],
                               work.periods);
  return {x, bondWeight(x, work.support)};
}

}  // namespace

BondVectors bondVectors(const ElasticWork& work, const Solids& solids, const Bonds& bonds,
                        std::size_t solidIndex, int k) {
  const std::size_t b = bonds.at(solidIndex, k);
  const ReferenceBond r = lookAtReference(work, solids, bonds, solidIndex, k);
  return {minimumImage(solids.position[bonds.neighbour[b]] - solids.position[solidIndex], work.periods),
          r.vector, bonds.twoFrames ? Vec3d{bonds.rx[b], bonds.ry[b], bonds.rz[b]} : -r.vector, r.weight};
}

namespace {

/// Gathers a solid's bonds in order, so that several sums look up each bond only once.
template<class Bond, class Look>
std::span<const Bond> gatherBonds(const Bonds& bonds, std::size_t solidIndex, Look&& look) {
  thread_local std::vector<Bond> there;
  if (there.size() < static_cast<std::size_t>(bonds.capacity))
    there.resize(static_cast<std::size_t>(bonds.capacity));
  Bond* const first = there.data();
  std::size_t n = 0;
  for (int k = 0; k < bonds.capacity; k++)
    if (bonds.hasBond(solidIndex, k)) first[n++] = look(k);
  return {first, n};
}

std::span<const BondVectors> vectorsOf(const ElasticWork& work, const Solids& solids, const Bonds& bonds,
                                       std::size_t solidIndex) {
  return gatherBonds<BondVectors>(bonds, solidIndex,
                                  [&](int k) { return bondVectors(work, solids, bonds, solidIndex, k); });
}

Mat3d gradientOf(const ElasticWork& work, const Solids& solids, std::size_t solidIndex,
                 std::span<const BondVectors> bonds) {
  Mat3d sum{};
  for (const BondVectors& v : bonds) sum = sum + outer(v.current - v.reference, v.weight * v.reference);
  const Mat3d gradU = sum * full(solids.momentInverse[solidIndex]);
  return work.rank[solidIndex] < 3
             ? completeGradient(gradU, solids.momentInverse[solidIndex], work.rank[solidIndex])
             : gradU;
}

}  // namespace

namespace {

/// Stores A^-1 and the data derived from A and the sum of weights of a solid.
void setMoment(ElasticWork& work, Solids& solids, std::size_t solidIndex, const Sym3d& a, double weights,
               const MomentInverse& m) {
  const std::size_t g = solidIndex / lanes;
  solids.momentInverse[solidIndex] = m.inverse;
  work.rank[solidIndex] = static_cast<std::uint8_t>(m.rank);
  const auto bit = static_cast<std::uint8_t>(1u << solidIndex % lanes);
  work.singularLanes[g] = static_cast<std::uint8_t>(m.rank < 3 ? work.singularLanes[g] | bit
                                                               : work.singularLanes[g] & ~bit);
  // Neighbours off the line of a rank-1 solid do not measure rotation about it. A bent row therefore has no
  // hourglass control, which would resist that rotation.
  const bool bent = m.rank == 1 && trace(a) - 1 / trace(m.inverse) > 1e-9 * trace(a);
  work.perTrace[solidIndex] = trace(a) > 0 && !bent ? 1 / trace(a) : 0;
  work.perWeight[solidIndex] = weights > 0 ? 1 / weights : 0;
  solids.changed[solidIndex] = 0;
}

double strainBoundOf(int rank, double lengths, const Vec3d& levers) {
  return (rank < 3 ? flatStrainFactor : 1) * (lengths + length(levers));
}

}  // namespace

void refreshGroup(ElasticWork& work, Solids& solids, const Bonds& bonds, std::size_t group) {
  const std::size_t first = group * lanes;
  thread_local AlignedVector<double> gathered;
  thread_local GroupMoments sums;
  if (!work.referenceKernels) work.referenceKernels = referenceKernels();
  const std::size_t room = 4 * lanes * static_cast<std::size_t>(bonds.capacity);
  if (gathered.size() < room) gathered.resize(room);
  ReferenceArrays a{bonds.neighbour.data(),
                    static_cast<std::size_t>(bonds.capacity),
                    solids.reference.data(),
                    work.support,
                    {},
                    gathered.data()};
  for (int k = 0; k < 3; k++) a.period[k] = work.periods.length[k];
  work.referenceKernels->moments(a, group, sums);
  const auto& s = sums.moment;
  for (std::size_t l = 0; l < lanes; l++) {
    const Sym3d moment{s[0][l], s[1][l], s[2][l], s[3][l], s[4][l], s[5][l]};
    const MomentInverse m = invertMoment(moment);
    setMoment(work, solids, first + l, moment, sums.weights[l], m);
    const double* const parts[6] = {&m.inverse.xx, &m.inverse.yy, &m.inverse.zz,
                                    &m.inverse.xy, &m.inverse.yz, &m.inverse.xz};
    for (int c = 0; c < 6; c++) sums.inverse[c][l] = *parts[c];
  }
  work.referenceKernels->levers(a, group, sums);
  for (std::size_t l = 0; l < lanes; l++)
    work.strainBound[first + l] = strainBoundOf(work.rank[first + l], sums.lengths[l],
                                                {sums.sum[0][l], sums.sum[1][l], sums.sum[2][l]});
}

void refreshSolid(ElasticWork& work, Solids& solids, const Bonds& bonds, std::size_t solidIndex) {
  Sym3d a{};
  double weights = 0;
  int last = 0;
  const auto look = [&](int k) {
    last = k + 1;
    return lookAtReference(work, solids, bonds, solidIndex, k);
  };
  const std::span<const ReferenceBond> there = gatherBonds<ReferenceBond>(bonds, solidIndex, look);
  for (const ReferenceBond& b : there) {
    a = a + b.weight * symmetric(outer(b.vector, b.vector));
    weights += b.weight;
  }
  const MomentInverse m = invertMoment(a);
  setMoment(work, solids, solidIndex, a, weights, m);
  std::uint16_t& count = work.bondCount[solidIndex / lanes];
  count = std::max(count, static_cast<std::uint16_t>(last));
  Vec3d all{};
  double lengths = 0;
  const Mat3d inverse = full(m.inverse);
  for (const ReferenceBond& b : there) {
    const Vec3d lever = b.weight * (inverse * b.vector);
    all += lever;
    lengths += length(lever);
  }
  work.strainBound[solidIndex] = strainBoundOf(m.rank, lengths, all);
}

Mat3d solidGradient(const ElasticWork& work, const Solids& solids, const Bonds& bonds,
                    std::size_t solidIndex) {
  return gradientOf(work, solids, solidIndex, vectorsOf(work, solids, bonds, solidIndex));
}

ElasticConstants constantsOfSolid(const ElasticWork& work, const Solids& solids, std::size_t solidIndex) {
  const std::size_t m = solids.material[solidIndex];
  const double liquid = solids.liquid.active ? static_cast<double>(solids.liquid[solidIndex]) : 0;
  const ElasticConstants& solid = work.solidConstants[m];
  return liquid > 0 ? elasticConstants(work.materials[m], liquid, *solid.law) : solid;
}

double solidEnergy(const ElasticWork& work, const Solids& solids, const Bonds& bonds,
                   std::size_t solidIndex) {
  return solidStrain(work, solids, bonds, solidIndex).energy;
}

namespace {

SolidStrain strainWith(const ElasticWork& work, const Solids& solids, std::size_t solidIndex,
                       const Mat3d& gradU, double errors) {
  const ElasticConstants c = constantsOfSolid(work, solids, solidIndex);
  const Mat3d elastic = work.plastic ? elasticGradient(gradU, solids.plasticInverse[solidIndex]) : gradU;
  return {gradU, solids.volume[solidIndex] * (elasticResponse(c, elastic).energy +
                                              hourglassEnergy(c, work.perTrace[solidIndex] * errors))};
}

}  // namespace

SolidStrain solidStrain(const ElasticWork& work, const Solids& solids, const Bonds& bonds,
                        std::size_t solidIndex) {
  const std::span<const BondVectors> there = vectorsOf(work, solids, bonds, solidIndex);
  const Mat3d gradU = gradientOf(work, solids, solidIndex, there);
  double errors = 0;
  for (const BondVectors& v : there) {
    const Vec3d e = v.current - v.reference - gradU * v.reference;
    errors += v.weight * dot(e, e);
  }
  return strainWith(work, solids, solidIndex, gradU, errors);
}

DriftEnergy driftEnergy(const ElasticWork& work, Solids& solids, const Bonds& bonds, std::size_t solidIndex,
                        double dt) {
  const double now = solidEnergy(work, solids, bonds, solidIndex);
  std::vector<std::pair<std::uint32_t, Vec3d>> places{
      {static_cast<std::uint32_t>(solidIndex), solids.position[solidIndex]}};
  for (int k = 0; k < bonds.capacity; k++)
    if (const std::uint32_t other = bonds.neighbour[bonds.at(solidIndex, k)]; bonds.hasBond(solidIndex, k))
      places.emplace_back(other, solids.position[other]);
  for (const auto& [row, place] : places) solids.position[row] = place - solids.velocity[row] * dt;
  const double before = solidEnergy(work, solids, bonds, solidIndex);
  for (const auto& [row, place] : places) solids.position[row] = place;
  return {now, before};
}

SolidStrain solidStrainAtReference(const ElasticWork& work, const Solids& solids, const Bonds& bonds,
                                   std::size_t solidIndex) {
  // The completed gradient has rounding errors, so it is computed from the bonds.
  if (work.rank[solidIndex] < 3) return solidStrain(work, solids, bonds, solidIndex);
  return strainWith(work, solids, solidIndex, Mat3d{} * full(solids.momentInverse[solidIndex]), 0);
}

bool atReference(const Solids& solids) {
  if (!solids.reference.active) return false;
  for (std::size_t s = 0; s < solids.size(); s++)
    if (solids.position[s] != solids.reference[s]) return false;
  return true;
}

}  // namespace thaw
