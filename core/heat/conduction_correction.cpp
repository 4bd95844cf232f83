// SPDX-License-Identifier: Apache-2.0
#include "core/heat/conduction_correction.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>

#include "core/kernels/lattice.hpp"
#include "core/kernels/with_kernel.hpp"
#include "core/simd/choose.hpp"

namespace thaw {

THAW_CHOOSE(FreeSurfaceKernels, freeSurfaceKernelSet, freeSurfaceKernels)

namespace {

/// Moment along a wall of its layers (tables.hpp), for a particle at a distance; support radii.
double wallMoment(const Numerics& n, double distance) {
  constexpr std::array<double, 3> node{-0.7745966692414834, 0, 0.7745966692414834},
      weight{0.5555555555555556, 0.8888888888888889, 0.5555555555555556};
  return withKernel(n.kernel, [&](auto kernel) {
    const double spacing = 1 / n.support;
    double sum = 0;
    for (double z = std::max(distance, 0.0) + 0.5 * spacing; z < 1; z += spacing) {
      const double half = 0.5 * (1 - z);
      for (std::size_t k = 0; k < node.size(); k++) {
        const double r = z + half * (1 + node[k]);
        sum += spacing * isa_base::pi * r * half * weight[k] * kernel.laplace(r * r) * (r * r - z * z);
      }
    }
    return sum;
  });
}

/// Adds a moment in all directions along a wall.
void addAlong(const Vec3d& normal, double moment, Sym3f& to) {
  const auto along = [&](double a, double b, double same) {
    return static_cast<float>(moment * (same - a * b));
  };
  const Vec3d& n = normal;
  to = to + Sym3f{along(n.x, n.x, 1), along(n.y, n.y, 1), along(n.z, n.z, 1),
                  along(n.x, n.y, 0), along(n.y, n.z, 0), along(n.x, n.z, 0)};
}

double largestEigenvalue(const Sym3d& s) {
  Eigen::Matrix3d m;
  m << s.xx, s.xy, s.xz, s.xy, s.yy, s.yz, s.xz, s.yz, s.zz;
  return Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(m, Eigen::EigenvaluesOnly).eigenvalues()[2];
}

}  // namespace

LatticeConduction latticeConduction(const Numerics& n) {
  return withKernel(n.kernel, [&](auto kernel) {
    LatticeConduction sum;
    const int steps = static_cast<int>(n.support);
    const double spacing = 1 / n.support, volume = spacing * spacing * spacing;
    for (int x = -steps; x <= steps; x++)
      for (int y = -steps; y <= steps; y++)
        for (int z = -steps; z <= steps; z++) {
          const double q2 = (x * x + y * y + z * z) * spacing * spacing;
          if (q2 == 0 || q2 >= 1) continue;
          const double w = volume * kernel.laplace(q2), along = w * x * x * spacing * spacing;
          sum.weight += w;
          sum.moment += along;
          if (z > 0) sum.missing += along;
        }
    return sum;
  });
}

bool correctsConduction(const Scene& s, const Modules& m) {
  const auto conducts = [](const Material& x) {
    return x.conductivity.solid > 0 || x.conductivity.liquid > 0;
  };
  return m.heat && m.neighbours && !m.uniform && conductionScale(s.numerics) != 1 &&
         std::any_of(s.materials.begin(), s.materials.end(), conducts);
}

double conductionFactor(const LatticeConduction& lattice, const ConductionSums& sums) {
  constexpr double inside = 0.96, most = 2;  // inside: of the trace on the lattice, since disorder varies it
  const Sym3d moment = wide(sums.moment);
  const double sum = trace(moment);
  if (!(sum < inside * 3 * lattice.moment)) return 1;
  const double largest = largestEigenvalue(moment), least = lattice.moment / most,
               weight = std::max(static_cast<double>(sums.weight), lattice.weight / most);
  return std::max(1.0, std::min(lattice.moment / std::max(largest, least), lattice.weight / weight));
}

void correctConduction(const PairSums& sums, const Numerics& n, const WallContacts& contacts, Continuum& p,
                       ConductionWork& work) {
  work.sums.assign(p.owned, {});
  freeSurfaceKernels()->conduction(sums, work.sums.data(), {0, sums.lists->groups});
  const LatticeConduction lattice = latticeConduction(n);
  const double scale = lattice.missing / wallMoment(n, 0.5 / n.support);
  for (const WallContact& c : contacts.list)
    addAlong(c.normal, c.share * scale * wallMoment(n, c.distance / sums.support), work.sums[c.row].moment);
  for (std::size_t i = 0; i < p.owned; i++)
    if (work.sums[i].weight >= 0)
      p.conductionCorrection[i] = static_cast<float>(conductionFactor(lattice, work.sums[i]) - 1);
}

}  // namespace thaw
