// SPDX-License-Identifier: Apache-2.0
#include "core/simulation/ledger/energy_left.hpp"

#include <algorithm>
#include <bit>

#include "core/fluid/laws/cohesion.hpp"
#include "core/fluid/laws/particle_pressure.hpp"
#include "core/kernels/with_kernel.hpp"
#include "core/materials/rest_density.hpp"
#include "core/neighbours/rows_around.hpp"
#include "core/simulation/sums/particle_sums.hpp"
#include "core/simulation/views/views.hpp"
#include "core/simulation/workspace/step_tools.hpp"
#include "core/simulation/world/world.hpp"
#include "core/walls/wall_surface_energy.hpp"

namespace thaw {
namespace {

/// Number of words per leaver in a message.
std::size_t wordsOf(const std::vector<PairForceWork>& pairForces) { return 6 + 4 * pairForces.size(); }

double volumeOf(const CellGrid& grid, const Continuum& particles, const Scene& scene, std::size_t i) {
  const double h = grid.support;
  return particles.mass[i] / (restDensityOf(particles, scene.materials, i) * h * h * h);
}

/// Positions of a leaver and of its periodic images within a support radius of the domain.
std::vector<Vec3d> imagesOf(const Scene& scene, const CellGrid& grid, const Vec3d& x) {
  const Domain& d = scene.domain;
  std::vector<Vec3d> images{x};
  for (int a = 0; a < 3; a++) {
    if (!grid.periodic[a]) continue;
    const std::size_t had = images.size();
    for (std::size_t k = 0; k < had; k++)
      for (const double shift : {-grid.period[a], grid.period[a]}) {
        Vec3d image = images[k];
        image[a] += shift;
        const bool near = image[a] > d.min[a] - grid.support && image[a] < d.max[a] + grid.support;
        if (near) images.push_back(image);
      }
  }
  return images;
}

/// Calls pair(row, leaver, (position - leaver's position) / h) for remaining liquid particles near each
/// leaver, in ascending order of leavers.
template<class Pair> void eachNearLeaver(const World& w, const std::vector<Leaver>& leavers, Pair&& pair) {
  const Continuum& p = w.particles;
  std::vector<RowSpan> ranges;
  for (const Leaver& l : leavers)
    for (const Vec3d& x : imagesOf(w.scene, w.grid, l.position)) {
      rowsAround(w.cells, cellKey(cellOf(w.grid, x)), ranges);
      for (const RowSpan& r : ranges)
        for (std::uint32_t j = r.begin; j < r.end && j < p.owned; j++) {
          const Vec3d d = (p.position[j] - x) / w.grid.support;
          if (dot(d, d) < 1 && liquidFraction(p, j) > 0) pair(j, l, d);
        }
    }
}

/// Records the energy of pairwise tension. Each particle of a pair stores half of the pair's energy
/// (terms/tension.hpp).
void recordCohesion(World& w, const std::vector<Leaver>& leavers,
                    const std::vector<LiquidMaterial>& liquids) {
  using isa_base::Cohesion;
  const double h = w.grid.support;
  eachNearLeaver(w, leavers, [&](std::uint32_t j, const Leaver& l, const Vec3d& d) {
    const double pair = l.volume * l.rootTension * volumeOf(w.grid, w.particles, w.scene, j) *
                        rootTensionOf(w.particles, liquids, j) * h * h;
    w.ledger.left.potential.add(0.5 * Cohesion::scale * pair * Cohesion::potential(length(d)));
  });
}

/// Records the loss of remaining particles, which is half of the energy of their pairs with leavers. The
/// other half leaves with the leavers.
void recordPairForces(World& w, const std::vector<Leaver>& leavers,
                      const std::vector<PairForceWork>& pairForces) {
  for (std::size_t k = 0; k < pairForces.size(); k++) {
    const PairForceWork& work = pairForces[k];
    const PairConstants constants = constantsOf(w.scene, w.grid.support, work);
    eachNearLeaver(w, leavers, [&](std::uint32_t j, const Leaver& l, const Vec3d& d) {
      const std::array<double, 4> record = pairRecordOf(w.scene, w.particles, j, work);
      const double pair = work.force->kernels.energy(
          constants, {d * w.grid.support, record.data(), l.records.data() + 4 * k});
      w.ledger.left.potential.add(0.5 * pair);
    });
  }
}

/// Changes of a neighbour's sums by removed particles.
struct Lost {
  std::uint32_t row = 0;
  SurfaceKernelValue surface{};
  double relativeDensity = 0;
};

/// Losses of all neighbours of leavers, ascending by row.
std::vector<Lost> lostSums(const World& w, const std::vector<Leaver>& leavers, double inverseLatticeSum) {
  std::vector<Lost> pairs, sums;
  const Numerics& n = w.scene.numerics;
  eachNearLeaver(w, leavers, [&](std::uint32_t j, const Leaver& l, const Vec3d& d) {
    const SurfaceKernelValue s = surfaceKernelAt(d);
    const double relativeDensity = inverseLatticeSum * l.volume *
                                   withKernel(n.kernel,
                                              [q = length(d)](auto kernel) { return kernel.w(q, q * q); });
    pairs.push_back({j, {s.gradient * l.volume, s.colour * l.volume}, relativeDensity});
  });
  std::stable_sort(pairs.begin(), pairs.end(), [](const Lost& a, const Lost& b) { return a.row < b.row; });
  for (const Lost& one : pairs) {
    if (sums.empty() || sums.back().row != one.row) sums.push_back({one.row});
    sums.back().surface.gradient += one.surface.gradient;
    sums.back().surface.colour += one.surface.colour;
    sums.back().relativeDensity += one.relativeDensity;
  }
  return sums;
}

/// Loss of surface energy (J/m^3 of liquid).
double surfaceLost(World& w, const SurfaceMeasure& measure, const WallContacts& contacts, const Lost& lost) {
  const SurfaceContext context{wallView(w), measure};
  if (!w.modules.surfaceEnergy) return 0;
  SurfaceParticle particle{lost.row,
                           tensionOfParticle(context.world, lost.row),
                           {w.particles.surfaceGradient[lost.row], w.particles.surfaceColour[lost.row]},
                           {}};
  if (!(particle.tension > 0)) return 0;
  if (w.modules.contactAngle) particle.contacts = contactsOf(contacts, lost.row);
  const double now = surfaceEnergyOf(context, particle);
  particle.sums.gradient += lost.surface.gradient;
  particle.sums.colour += lost.surface.colour;
  return surfaceEnergyOf(context, particle) - now;
}

/// Loss of compression energy (J/m^3 of liquid); 0 with a carried density.
double compressionLost(const Scene& scene, const Modules& modules, const Continuum& particles,
                       const std::vector<LiquidMaterial>& liquids, const Lost& lost) {
  if (modules.continuity || modules.incompressible) return 0;
  const Numerics& n = scene.numerics;
  const double stiffness = liquids[particles.material[lost.row]].stiffness;
  const auto relativeDensity = static_cast<double>(particles.relativeDensity[lost.row]);
  const auto energy = [&](double f) { return compressionEnergy(n.eos, stiffness, f, n.tensileLimit); };
  return energy(relativeDensity + lost.relativeDensity) - energy(relativeDensity);
}

void recordNeighbourhoods(World& w, const StepTools& t) {
  const Continuum& p = w.particles;
  for (const Lost& lost : lostSums(w, t.redistribution.leavers, t.sums.scales.inverseLatticeSum)) {
    const double V = restVolumeOf(p, w.scene.materials, lost.row);
    const double density = surfaceLost(w, t.surface, t.walls.contacts, lost) +
                           compressionLost(w.scene, w.modules, p, t.liquids, lost);
    w.ledger.left.potential.add(liquidFraction(p, lost.row) * V * density);
  }
}

}  // namespace

std::vector<Leaver> leaversOfAll(const World& w, const StepTools& t, Reducer& all) {
  std::int64_t leaving = static_cast<std::int64_t>(t.redistribution.leaving.size());
  all.sum({&leaving, 1});
  if (leaving == 0) return {};  // most steps: nothing is allocated
  const auto rank = static_cast<std::size_t>(all.rank());
  std::vector<std::int64_t> counts(static_cast<std::size_t>(all.size()));
  counts[rank] = static_cast<std::int64_t>(t.redistribution.leaving.size());
  all.sum(counts);
  std::int64_t before = 0, total = 0;
  for (std::size_t r = 0; r < counts.size(); r++) {
    if (r == rank) before = total;
    total += counts[r];
  }
  const std::size_t words = wordsOf(t.terms.pairForces);
  std::vector<std::int64_t> packed(static_cast<std::size_t>(total) * words);
  std::int64_t* to = packed.data() + static_cast<std::size_t>(before) * words;
  for (const std::uint32_t i : t.redistribution.leaving) {
    *to++ = std::bit_cast<std::int64_t>(w.particles.id[i]);
    const Vec3d& x = w.particles.position[i];
    for (const double value :
         {x.x, x.y, x.z, volumeOf(w.grid, w.particles, w.scene, i), rootTensionOf(w.particles, t.liquids, i)})
      *to++ = std::bit_cast<std::int64_t>(value);
    for (const PairForceWork& work : t.terms.pairForces)
      for (const double value : pairRecordOf(w.scene, w.particles, i, work))
        *to++ = std::bit_cast<std::int64_t>(value);
  }
  all.sum(packed);
  std::vector<Leaver> leavers;
  for (std::size_t k = 0; k < packed.size(); k += words) {
    const auto number = [&](std::size_t n) { return std::bit_cast<double>(packed[k + n]); };
    const Vec3d place{number(1), number(2), number(3)};
    leavers.push_back({std::bit_cast<std::uint64_t>(packed[k]), place, number(4), number(5), {}});
    for (std::size_t n = 6; n < words; n++) leavers.back().records.push_back(number(n));
  }
  std::sort(leavers.begin(), leavers.end(), [](const Leaver& a, const Leaver& b) { return a.id < b.id; });
  return leavers;
}

void recordEnergyLeft(World& w, const StepTools& t) {
  const std::vector<Leaver>& leavers = t.redistribution.leavers;
  if (leavers.empty()) return;
  recordPairForces(w, leavers, t.terms.pairForces);
  if (!w.modules.tension) return;
  recordNeighbourhoods(w, t);
  if (w.scene.numerics.tension == TensionForm::Pairwise) recordCohesion(w, leavers, t.liquids);
}

}  // namespace thaw
