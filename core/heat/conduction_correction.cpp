// SPDX-License-Identifier: Apache-2.0
#include "core/heat/conduction_correction.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>

#include "core/simd/choose.hpp"

namespace thaw {

THAW_CHOOSE(FreeSurfaceKernels, freeSurfaceKernelSet, freeSurfaceKernels)

namespace {

double largestEigenvalue(const Sym3d& s) {
  Eigen::Matrix3d m;
  m << s.xx, s.xy, s.xz, s.xy, s.yy, s.yz, s.xz, s.yz, s.zz;
  return Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(m, Eigen::EigenvaluesOnly).eigenvalues()[2];
}

}  // namespace

bool correctsConduction(const Scene& s, const Modules& m) {
  const auto conducts = [](const Material& x) {
    return x.conductivity.solid > 0 || x.conductivity.liquid > 0;
  };
  return m.heat && m.neighbours && !m.uniform && conductionScale(s.numerics) != 1 &&
         std::any_of(s.materials.begin(), s.materials.end(), conducts);
}

double conductionFactor(const LatticeConduction& lattice, const ConductionSums& sums) {
  constexpr double inside = 0.96;  // fraction of the lattice's trace from which the factor is 1. Disorder
                                   // lowers the trace
  constexpr double most = 2;       // largest factor
  const Sym3d moment = wide(sums.moment);
  const double sum = trace(moment);
  if (!(sum < inside * 3 * lattice.moment)) return 1;
  const double largest = largestEigenvalue(moment), least = lattice.moment / most,
               weight = std::max(static_cast<double>(sums.weight), lattice.weight / most);
  return std::max(1.0, std::min(lattice.moment / std::max(largest, least), lattice.weight / weight));
}

void correctConduction(const PairSums& sums, const WallContext& walls, const WallContacts& contacts,
                       ConductionWork& work) {
  Continuum& p = walls.world.particles;
  const Numerics& n = walls.world.scene.numerics;
  work.sums.assign(p.owned, {});
  freeSurfaceKernels()->conduction(sums, work.sums.data(), {0, sums.lists->groups});
  const LatticeConduction lattice = latticeConduction(n);
  for (std::size_t i = 0; i < p.owned; i++)
    if (work.sums[i].weight >= 0 && !walls.sleeps(i))
      p.conductionCorrection[i] = static_cast<float>(conductionFactor(lattice, work.sums[i]) - 1);
  for (const WallContact& c : contacts.list)
    if (c.distance * n.support < sums.support && !walls.sleeps(c.row)) p.conductionCorrection[c.row] = 0;
}

}  // namespace thaw
