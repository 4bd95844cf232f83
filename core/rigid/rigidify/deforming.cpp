// SPDX-License-Identifier: Apache-2.0
#include "core/rigid/rigidify/deforming.hpp"

#include <algorithm>
#include <span>
#include <vector>

#include "core/neighbours/mixed_cells.hpp"
#include "core/solid/elasticity/active_solids.hpp"

namespace thaw {
namespace {

/// Steps between comparisons of strain rates of rigid particles. A pressure wave travels less than a spacing
/// in this time, so a piece becomes elastic ahead of the wave.
constexpr std::int64_t rateEvery = 2;
/// Steps between comparisons of strain rates of elastic particles. Their rest time spans many more steps.
constexpr std::int64_t elasticRateEvery = 16;
/// Steps between searches for particles that may become rigid.
constexpr std::int64_t restEvery = 32;
/// Temperature difference (K) to the solidus. Particles closer to it become elastic together with softening
/// particles, so a melting front changes whole layers.
constexpr double soonMelts = 0.5;

/// Particles closer than this (spacings) to another body stay elastic. It exceeds the contact distance, so
/// contacts act on elastic particles.
constexpr double nearBody = 1.5;

bool isSoft(const Scene& scene, const Continuum& p, std::size_t i, double margin) {
  if (!p.liquid.active) return false;
  return p.liquid[i] > 0 || p.temperature[i] > scene.materials[p.material[i]].solidus - margin;
}

/// Sums over the bonds of a solid particle. e: unit vector along a bond. u: velocity difference over length.
struct BondRates {
  Mat3d moment{}, product{};  ///< sums of e e^T and u e^T
  double squares = 0;         ///< 1/s^2, sum of (e . u)^2, the squared rates of relative length
  int count = 0;
  void add(const Vec3d& e, const Vec3d& u) {
    for (int a = 0; a < 3; a++) {
      moment.row[a] += e[a] * e;
      product.row[a] += u[a] * e;
    }
    squares += dot(e, u) * dot(e, u);
    count++;
  }
};

/// Returns the squared rate of strain (1/s^2), |D|^2. D is the symmetric part of the velocity gradient that
/// fits the bonds best. In flat and thin neighbourhoods, returns the mean squared rate of relative length.
/// Both are 0 in any rigid motion, up to rounding.
double strainRate2(const BondRates& bonds) {
  constexpr double leastVolume = 0.1;  // determinant of the moment over that of isotropic directions
  if (bonds.count == 0) return 0;
  const double even = bonds.count / 3.0;
  if (determinant(bonds.moment) < leastVolume * even * even * even) return bonds.squares / bonds.count;
  const Mat3d gradient = bonds.product * inverse(bonds.moment);
  double sum = 0;
  for (int a = 0; a < 3; a++)
    for (int b = 0; b < 3; b++) {
      const double d = 0.5 * (gradient.row[a][b] + gradient.row[b][a]);
      sum += d * d;
    }
  return sum;
}

BondRates bondRates(const RigidifyView& v, std::size_t solidIndex) {
  const Solids& s = v.solids;
  BondRates rates;
  for (int k = 0; k < v.elastic.bondCount[solidIndex / lanes]; k++) {
    if (!v.bonds.hasBond(solidIndex, k)) continue;
    const std::uint32_t end = v.bonds.neighbour[v.bonds.at(solidIndex, k)];
    const Vec3d d = minimumImage(s.position[end] - s.position[solidIndex], v.elastic.periods);
    const double perLength = 1 / length(d);
    rates.add(d * perLength, (s.velocity[end] - s.velocity[solidIndex]) * perLength);
  }
  return rates;
}

/// Sets the rest time of particles in contact, or soon in contact, to 0.
void wakeTouching(const RigidifyView& v) {
  Continuum& p = v.rigid.particles;
  for (const WallContact& c : v.wallContacts.list) p.restTime[c.row] = 0;
  for (const ClosePair& pair : v.closePairs.list)
    if (p.piece[pair.own] == notRigid || p.piece[pair.own] != p.piece[pair.other]) {
      bool bonded = false;
      const std::uint32_t solidIndex = p.solidIndex[pair.own];
      if (solidIndex == noSolid) continue;
      for (int k = 0; k < v.elastic.bondCount[solidIndex / lanes] && !bonded; k++)
        bonded = v.bonds.hasBond(solidIndex, k) &&
                 v.solids.id[v.bonds.neighbour[v.bonds.at(solidIndex, k)]] == p.id[pair.other];
      if (!bonded) p.restTime[pair.own] = 0;
    }
}

/// Sets the rest time of solids near another body to 0.
void wakeNearBodies(const RigidifyView& v) {
  Continuum& p = v.rigid.particles;
  const CellTable& cells = v.rigid.cells;
  const double near = nearBody * v.rigid.scene.spacing;
  MixedCells mixed;
  rangesOfCells(cells, p, p.body, mixed.ranges);
  anyMixedCell(cells, p.owned, mixed, [&](std::size_t c, std::span<const RowSpan> rows) {
    for (std::size_t i = cells.first[c]; i < cells.first[c] + cells.count[c]; i++)
      for (const RowSpan& r : rows)
        for (std::uint32_t j = r.begin; j < r.end && p.restTime[i] > 0; j++) {
          const Vec3d d = p.position[j] - p.position[i];
          if (p.phase[j] == Solid && p.body[j] != p.body[i] && dot(d, d) < near * near) p.restTime[i] = 0;
        }
    return false;
  });
}

void wakeStretching(const RigidifyView& v, std::int64_t step) {
  Continuum& p = v.rigid.particles;
  const double limit = v.rigid.scene.numerics.rigidify;
  for (std::size_t s = 0; s < v.solids.owned; s++) {
    if (isPassive(v.elastic, s)) continue;
    const std::uint32_t i = v.solids.particle[s];
    if (p.piece[i] == notRigid && step % elasticRateEvery != 0) continue;
    float& rest = p.restTime[i];
    if (rest > 0 && strainRate2(bondRates(v, s)) > limit * limit) rest = 0;
  }
}

}  // namespace

bool isToBeRigid(const Scene& scene, const Continuum& p, std::size_t i) {
  if (p.phase[i] != Solid || p.solidIndex[i] == noSolid || (p.clamped.active && p.clamped[i] != 0))
    return false;
  return p.restTime[i] > 0 &&
         (p.piece[i] != notRigid || static_cast<double>(p.restTime[i]) >= scene.numerics.sleepAfter);
}

void restAtStart(const Scene& scene, Continuum& p) {
  std::fill_n(p.restTime.data(), p.owned, static_cast<float>(scene.numerics.sleepAfter));
}

void wakeSoftening(const RigidifyView& v) {
  Continuum& p = v.rigid.particles;
  for (std::size_t i = 0; i < p.owned; i++)
    if (isSoft(v.rigid.scene, p, i, soonMelts)) p.restTime[i] = 0;
}

bool findDeforming(const RigidifyView& v, double dt) {
  const Scene& scene = v.rigid.scene;
  Continuum& p = v.rigid.particles;
  for (std::size_t i = 0; i < p.owned; i++)
    if (p.phase[i] != Solid || p.solidIndex[i] == noSolid || isSoft(scene, p, i, 0)) p.restTime[i] = 0;
    // For a rigid particle, a rest time of 0 means that its load changed in this evaluation.
    else if (p.restTime[i] > 0 || p.piece[i] == notRigid)
      p.restTime[i] = static_cast<float>(static_cast<double>(p.restTime[i]) + dt);
  wakeTouching(v);
  wakeNearBodies(v);
  const std::int64_t step = v.clock.step + 1;
  if (step % rateEvery == 0) wakeStretching(v, step);
  bool wakes = false, rests = false;
  for (std::size_t i = 0; i < p.owned; i++) {
    const bool rigid = isToBeRigid(scene, p, i);
    wakes = wakes || (p.piece[i] != notRigid && !rigid);
    rests = rests || (p.piece[i] == notRigid && rigid);
  }
  return wakes || (rests && step % restEvery == 0);
}

bool nothingDeforms(const RigidifyView& v) {
  const RigidView& r = v.rigid;
  if (r.work.changedHere || anyActiveSolid(v.elastic, v.solids)) return false;
  MixedCells mixed;
  rangesOfCells(r.cells, r.particles, r.particles.piece, mixed.ranges);
  return !anyMixedCell(r.cells, r.particles.owned, mixed,
                       [](std::size_t, std::span<const RowSpan>) { return true; });
}

}  // namespace thaw
