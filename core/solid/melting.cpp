// SPDX-License-Identifier: Apache-2.0
#include "core/solid/melting.hpp"

#include "core/solid/elasticity/solid_state.hpp"

namespace thaw {

namespace {

bool dropBonds(Solids& solids, Bonds& bonds, std::size_t solidIndex, int most) {
  bool any = false;
  for (int k = 0; k < most; k++) {
    if (!bonds.hasBond(solidIndex, k) ||
        !(solids.melted[solidIndex] || solids.melted[bonds.neighbour[bonds.at(solidIndex, k)]]))
      continue;
    bonds.cut(solidIndex, k);
    any = true;
  }
  if (any) solids.markExposed(solidIndex);
  return any;
}

}  // namespace

namespace {

/// Returns true if all energy of a solid is proportional to Young's modulus at any liquid fraction.
bool scalesWithYoung(const Material& m, const ElasticConstants& c) {
  return c.law->law->builtIn >= 0 && m.volumeStiffness == 0 && m.poisson.solid == m.poisson.liquid &&
         (m.yieldStrain.solid == m.yieldStrain.liquid || !(m.yieldStrain.solid < never));
}

}  // namespace

void recordSoftening(const ElasticWork& work, const Continuum& p, Solids& solids, const Bonds& bonds,
                     ExactSum& phaseJump) {
  for (std::size_t s = 0; s < solids.owned; s++) {
    const float was = solids.liquid[s], is = p.liquid[solids.particle[s]];
    if (is == was) continue;
    const Material& m = work.materials[solids.material[s]];
    const double young = m.young.at(static_cast<double>(was)), before = solids.energy[s];
    double after = before;
    if (scalesWithYoung(m, work.solidConstants[solids.material[s]]) && young > 0) {
      after *= m.young.at(static_cast<double>(is)) / young;
      solids.liquid[s] = is;
    } else {
      after -= solidEnergy(work, solids, bonds, s);
      solids.liquid[s] = is;
      after += solidEnergy(work, solids, bonds, s);
    }
    phaseJump.add(before - after);
    solids.energy[s] = after;
  }
}

void markMelted(const Continuum& p, Solids& solids) {
  for (std::size_t s = 0; s < solids.owned; s++) solids.melted[s] = p.phase[solids.particle[s]] == Liquid;
}

std::int64_t dropMeltedBonds(ElasticWork& work, const Continuum& p, Solids& solids, Bonds& bonds,
                             ExactSum& phaseJump) {
  std::int64_t count = 0;
  for (std::size_t s = 0; s < solids.owned; s++) {
    if (!dropBonds(solids, bonds, s, work.bondCount[s / lanes])) continue;
    refreshSolid(work, solids, bonds, s);
    if (solids.liquid.active) solids.liquid[s] = p.liquid[solids.particle[s]];
    if (solids.lastGradient.active) solids.lastGradient[s] = solidGradient(work, solids, bonds, s);
    const double after = solids.melted[s] ? 0 : solidEnergy(work, solids, bonds, s);
    phaseJump.add(solids.energy[s] - after);
    solids.energy[s] = after;
    count++;
  }
  return count;
}

}  // namespace thaw
