// SPDX-License-Identifier: Apache-2.0
#include "core/flow/rheology/apparent_viscosity.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/flow/rheology/shear_sums.hpp"
#include "core/fluid/flow_laws/flow_law.hpp"
#include "core/fluid/laws/particle_pressure.hpp"
#include "core/fluid/laws/sticking_viscosity.hpp"

namespace thaw {
namespace {

struct Search {
  const WallContext& walls;
  const WallContacts& contacts;
  std::vector<double> leastRate;  ///< 1/s, by material; 0 without a flow law
};

/// Adds a wall to the sums of a particle.
void addWall(const Search& x, const WallContact& c, ShearMoments& s) {
  const WallView& w = x.walls.world;
  const Wall& wall = w.walls.list[c.wall];
  if (wall.properties.slip) return;
  const double h = w.grid.support, d = std::max(c.distance / h, x.walls.tables.nearest);
  const double moment = s.liquid * x.walls.tables(c.distance / h).momentShare * c.share;
  const Vec3d n = c.normal, u = w.particles.velocity[c.row] - wallVelocity(wall, w.particles.position[c.row]);
  const Vec3d m = moment * n;
  const double second[6] = {m.x * n.x, m.y * n.y, m.z * n.z, m.x * n.y, m.y * n.z, m.x * n.z};
  for (int k = 0; k < 6; k++) s.moment[k] += second[k];
  for (int k = 0; k < 3; k++)
    for (int l = 0; l < 3; l++) s.velocity[3 * k + l] += u[k] * m[l] / d;
}

void finishRow(void* context, std::uint32_t row, const ShearMoments& sums) {
  const Search& x = *static_cast<const Search*>(context);
  const WallView& w = x.walls.world;
  Continuum& p = w.particles;
  const std::uint16_t k = p.material[row];
  if (!(x.leastRate[k] > 0) || x.walls.sleeps(row)) return;
  ShearMoments all = sums;
  if (sums.liquid > 0)
    for (const WallContact& c : contactsOf(x.contacts, row)) addWall(x, c, all);
  if (sums.liquid == 0 && !(all.moment[0] + all.moment[1] + all.moment[2] > 0)) return;  // no liquid nearby
  const double rate = shearRateOf(all) / w.grid.support;
  const FlowCoefficients law = flowCoefficients(w.scene.materials[k].flowLaw, x.leastRate[k],
                                                p.temperature.active ? p.temperature[row] : 0);
  double viscosity = apparentViscosity(law, rate);
  // In steady shear, each step multiplies an error of the viscosity by 1 - n.
  const double old = static_cast<double>(p.apparentViscosity[row]), steepness = steepnessOf(*law.settings);
  if (steepness > 1 && old > 0) viscosity = old * std::pow(viscosity / old, 1 / steepness);
  p.apparentViscosity[row] = static_cast<float>(viscosity);
}

}  // namespace

void findApparentViscosity(const WallContext& walls, const WallContacts& contacts, const PairSums& sums) {
  const Scene& s = walls.world.scene;
  Continuum& p = walls.world.particles;
  Search search{walls, contacts, {}};
  for (const Material& m : s.materials) search.leastRate.push_back(hasFlowLaw(m) ? leastRateOf(s, m) : 0);
  // The set of solids that the sums visit depends on the groups, and thus on the number of ranks.
  for (std::size_t i = 0; walls.world.modules.solid && i < p.owned; i++)
    if (liquidFraction(p, i) == 0 && !walls.sleeps(i)) p.apparentViscosity[i] = 0;
  shearKernels()->sum(sums, {&search, finishRow}, {0, sums.lists->groups});
}

void packApparentViscosity(const RecordContext& x, const Continuum& p, std::size_t begin, std::size_t end,
                           PairRecords& r) {
  const bool pairwise = x.scene.numerics.viscosity == ViscosityForm::Pairwise;
  const auto pack = [&](auto real) {
    using Real = decltype(real);
    Real* const fourth = reinterpret_cast<Real*>(r.velocityViscosity.data()) + 3;
    for (std::size_t i = begin; i < end; i++) {
      if (!hasFlowLaw(x.scene.materials[p.material[i]])) continue;
      const double factor = p.viscosityCorrection.active ? 1 + static_cast<double>(p.viscosityCorrection[i])
                                                         : 1;
      const double viscosity = static_cast<double>(p.apparentViscosity[i]) * factor;
      fourth[4 * i] = static_cast<Real>(pairwise ? stickingViscosity(viscosity, liquidFraction(p, i))
                                                 : viscosity);
    }
  };
  x.scene.numerics.precision == Precision::Double ? pack(double{}) : pack(float{});
}

}  // namespace thaw
