// SPDX-License-Identifier: Apache-2.0
#include "core/heat/evaporation.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/fluid/laws/particle_pressure.hpp"
#include "core/fluid/laws/surface_energy.hpp"
#include "core/heat/heat.hpp"
#include "core/heat/rest_densities.hpp"
#include "core/kernels/lattice.hpp"
#include "core/kernels/with_kernel.hpp"
#include "core/materials/enthalpy.hpp"
#include "core/materials/rest_density.hpp"
#include "core/materials/state_equation.hpp"
#include "core/scene/temperature_table.hpp"
#include "core/walls/tables.hpp"

namespace thaw {
namespace {

// Fractions of the gradient at a flat surface. Inside a liquid, disorder gives up to 0.4, but less than 0.1
// on average over neighbours.
constexpr double leastExposure = 0.05, noise[2] = {0.4, 0.7}, meanNoise[2] = {0.06, 0.12};

/// Free-surface indicator of the outermost particles of a flat lattice surface.
double flatLatticeIndicator(const Numerics& n) {
  return 2 / n.support * wallIntegrals(n, 0.5 / n.support).push;
}

/// Largest fraction of its absolute temperature that a particle may lose in a step. It matters for rates that
/// are above 0 at all temperatures.
constexpr double mostCooling = 0.1;

/// Evaporation does not lower a carried relative density below this. Vapour leaves at the surface, where the
/// pressure is that of the gas.
constexpr double leastThinned = 0.99;

double ramp(double x, const double (&between)[2]) {
  return std::clamp((x - between[0]) / (between[1] - between[0]), 0.0, 1.0);
}

bool evaporates(const Scene& s, const Continuum& p, std::size_t i) {
  return p.phase[i] == Liquid && !s.materials[p.material[i]].evaporation.empty();
}

double volumeOf(const Scene& s, const Continuum& p, std::size_t i) { return restVolumeOf(p, s.materials, i); }

/// Calls row(i, neighbours) for the selected owned rows. neighbours(pair) calls pair(j, (x_i - x_j) / h, q^2)
/// for each neighbour j within the support radius, in list order.
template<class Select, class Row> void eachRow(const EvaporationView& v, Select&& select, Row&& row) {
  const Continuum& p = v.heat.particles;
  const NeighbourLists& lists = v.neighbours;
  const double perSupport = 1 / v.records.grid.support;
  for (std::size_t g = 0; g < lists.groups; g++)
    for (std::size_t l = 0; l < 8; l++) {
      const std::uint32_t i = lists.self[8 * g + l];
      if (i == lists.dummy || !select(i)) continue;
      row(i, [&](auto&& pair) {
        for (std::uint32_t k = 0; k < lists.count[g]; k++) {
          const std::uint32_t j = lists.row(g, k, l);
          if (j == lists.dummy) continue;
          const Vec3d d = (p.position[i] - p.position[j]) * perSupport;
          if (const double q2 = dot(d, d); q2 < 1) pair(j, d, q2);
        }
      });
    }
}

/// Walls near a particle, as planes that mirror the liquid. Walls with similar normals count once.
struct Mirrors {
  static constexpr std::size_t most = 3;
  std::array<Vec3d, most> normal;
  std::array<double, most> distance;  ///< support radii
  std::size_t count = 0;
};

Mirrors mirrorsOf(const EvaporationView& v, std::uint32_t i) {
  constexpr double sameDirection = 0.7;
  Mirrors m;
  for (const WallContact& c : contactsOf(v.contacts, i)) {
    bool known = m.count == Mirrors::most;
    for (std::size_t k = 0; k < m.count && !known; k++) known = dot(c.normal, m.normal[k]) > sameDirection;
    if (known) continue;
    m.normal[m.count] = c.normal;
    m.distance[m.count++] = c.distance / v.records.grid.support;
  }
  return m;
}

/// Calls image(d, q^2) for the mirror images, in one or more walls, of a neighbour at `separation` (support
/// radii). d lacks the components normal to these walls, because wallGradient replaces them.
template<class Image> void eachImage(const Mirrors& m, const Vec3d& separation, Image&& image) {
  for (unsigned walls = 1; walls < (1u << m.count); walls++) {
    Vec3d d = separation;
    for (std::size_t k = 0; k < m.count; k++)
      if (walls >> k & 1) d += m.normal[k] * (2 * (m.distance[k] - dot(d, m.normal[k])));
    const double q2 = dot(d, d);
    if (q2 >= 1) continue;
    for (std::size_t k = 0; k < m.count; k++)
      if (walls >> k & 1) d -= m.normal[k] * dot(d, m.normal[k]);
    image(d, q2);
  }
}

/// Returns the derivative of a wall's part of the density at a distance (support radii). The pressure force
/// uses another gradient (tables.hpp).
double wallGradient(const WallTables& tables, double distance) {
  const double step = (1 - tables.lowest) / WallTables::points, at = std::max(distance, tables.lowest + step);
  return (tables(at - step).space - tables(at + step).space) / (2 * step);
}

/// Returns the direction of the mean volume gradient around a particle. Its length is 0 inside and 1 at a
/// surface.
template<class Neighbours>
Vec3d surfaceDirection(const EvaporationView& v, std::uint32_t i, double flat, Neighbours&& neighbours) {
  const Scene& s = v.heat.scene;
  const Continuum& p = v.heat.particles;
  const double h = v.records.grid.support, perH3 = 1 / (h * h * h);
  const auto weight = [&](std::uint32_t j, double q2) {
    return volumeOf(s, p, j) * perH3 *
           withKernel(s.numerics.kernel, [&](auto kernel) { return kernel.w(q2); });
  };
  Vec3d mean{};
  neighbours(
      [&](std::uint32_t j, const Vec3d&, double q2) { mean += wide(p.volumeGradient[j]) * weight(j, q2); });
  const Vec3d own = wide(p.volumeGradient[i]);
  const double alone = ramp(length(own) / flat, noise),
               gate = std::max(alone, ramp(length(mean) / flat, meanNoise));
  const Vec3d direction = mean + own * (alone * weight(i, 0));
  const double size = length(direction);
  return size > 0 ? direction * (gate / size) : own * (gate / std::max(length(own), 1e-300));
}

/// Returns the free surface area (m^2) of a particle, times spacing and latticeGradient. V g.n may be
/// negative. It is redistributed among the particles along a line through the surface, in proportion to
/// sqrt(V) g.n where that is positive. Small particles then evaporate in a finite time.
template<class Neighbours>
double areaOf(const EvaporationView& v, std::uint32_t i, double flat, Neighbours&& neighbours) {
  const Scene& s = v.heat.scene;
  const Continuum& p = v.heat.particles;
  const Vec3d direction = surfaceDirection(v, i, flat, neighbours);
  const double gate = length(direction);
  if (gate == 0) return 0;
  const Vec3d n = direction * (1 / gate);
  double all = 0, shares = 0;
  const auto add = [&](std::uint32_t j, const Vec3d& d) {
    const Vec3d aside = d - n * dot(d, n);
    const double near = 1 - dot(aside, aside), V = volumeOf(s, p, j),
                 part = near * near * dot(wide(p.volumeGradient[j]), n);
    all += V * part;
    shares += std::sqrt(V) * std::max(part, 0.0);
  };
  add(i, {});
  neighbours([&](std::uint32_t j, const Vec3d& d, double) { add(j, d); });
  const double own = std::sqrt(volumeOf(s, p, i)) * dot(wide(p.volumeGradient[i]), n);
  if (!(own > 0 && all > 0)) return 0;
  return gate * own * (all / shares);
}

/// Returns the energy (J) of a particle's springs on walls. It is proportional to the particle's mass.
double springEnergy(const EvaporationView& v, const WallContext& walls, std::uint32_t i) {
  const std::span<const WallContact> contacts = contactsOf(v.contacts, i);
  if (contacts.empty()) return 0;
  const WallSpring spring = wallSpring(walls, i);
  double sum = 0;
  for (const WallContact& c : contacts) sum += spring.energy(c.distance);
  return sum;
}

/// Returns the derivative of the stored energy with respect to the particle's volume (J/m^3): pairs,
/// compression and surface, without contacts. stored: J, compression and tension of the particle. A carried
/// density does not contribute, because it changes with the mass (removeVapour).
template<class Neighbours>
double energyPerVolume(const EvaporationView& v, std::uint32_t i, double stored, Neighbours&& neighbours) {
  const Scene& s = v.heat.scene;
  const Continuum& p = v.heat.particles;
  const Modules& m = v.heat.modules;
  const Numerics& n = s.numerics;
  const double compression = compressionOf(v.records, p, i, liquidFraction(p, i)),
               tension = stored - compression;
  const bool summed = !m.continuity && !m.incompressible;
  // The derivative of the compression energy of j by its relative density.
  const auto byDensity = [&](std::uint32_t j) {
    const double delta = summed ? static_cast<double>(p.relativeDensity[j]) : 0;
    if (delta <= 0) return 0.0;
    return volumeOf(s, p, j) * liquidFraction(p, j) *
           pressureOf(n.eos, v.records.liquids[p.material[j]].stiffness, delta, n.tensileLimit) /
           (delta * delta);
  };
  const auto weight = [&](double q2) {
    return v.inverseLatticeSum * withKernel(n.kernel, [&](auto kernel) { return kernel.w(q2); });
  };
  double sum = byDensity(i) * (weight(0) - v.selfExcess);
  neighbours([&](std::uint32_t j, const Vec3d& d, double q2) {
    sum += byDensity(j) * weight(q2);
    if (!m.surfaceEnergy) return;
    const SurfaceKernelValue k = surfaceKernelAt(-1.0 * d);  // the part of i in the sums of j
    sum += volumeOf(s, p, j) *
           (dot(p.surfaceEnergyByGradient[j], k.gradient) + p.surfaceEnergyByColour[j] * k.colour);
  });
  const double h = v.records.grid.support,
               own = (summed ? compression : 0) + (m.surfaceEnergy || !m.tension ? 1 : 2) * tension;
  return own / volumeOf(s, p, i) + sum / (h * h * h);
}

/// Records mass dm (kg) of a particle as vapour, with its fraction of the particle's energies.
void recordVapour(const HeatView& v, std::size_t i, double dm, double dt) {
  const Continuum& p = v.particles;
  const Vec3d &x = p.position[i], &u = p.velocity[i], L = cross(x, u);
  const Vec3d kick = p.acceleration[i] * (0.5 * dt);  // the second half kick, as for particles that remain
  ExactBalance& left = v.ledger.left;
  left.mass.add(dm);
  for (int a = 0; a < 3; a++) {
    left.momentum[a].add(dm * u[a]);
    left.angularMomentum[a].add(dm * L[a]);
  }
  left.kinetic.add(dm * (0.5 * dot(u, u) + dot(u, kick) + 0.5 * dot(kick, kick)));
  left.potential.add(-dm * dot(v.scene.domain.gravity, x));
  left.internal.add(dm * p.enthalpy[i]);
}

}  // namespace

double meanRate(const TemperatureTable& t, double T, double cooling, double dt) {
  const double now = valueAt(t, T, Interpolation::Linear);
  if (!(cooling * now * dt > 0)) return now;
  double left = dt, fall = 0;  // s, K
  for (std::size_t k = t.size(); k-- > 0 && left > 0;) {
    const auto [low, rateLow] = t[k];
    if (!(T > low)) continue;
    // Cools from T to the lower end of this interval of the table.
    const double rate = valueAt(t, T, Interpolation::Linear), slope = (rate - rateLow) / (T - low);
    const double decay = slope * cooling;  // 1/s
    const double needed = slope == 0    ? (T - low) / (cooling * rate)
                          : rateLow > 0 ? std::log(rate / rateLow) / decay
                                        : never,
                 span = std::min(left, needed);
    fall += span < needed ? (slope == 0 ? cooling * rate * span : -rate * std::expm1(-decay * span) / slope)
                          : T - low;
    left -= span;
    T = low;
  }
  if (left > 0) fall += cooling * t.front().second * left;
  return fall / (cooling * dt);
}

void findExposure(const EvaporationView& v) {
  const Scene& s = v.heat.scene;
  Continuum& p = v.heat.particles;
  const double h = v.records.grid.support, flat = flatLatticeIndicator(s.numerics),
               scale = 2 * s.spacing / (h * h * h * h);
  std::fill_n(p.volumeGradient.data(), p.owned, Vec3f{});
  const auto select = [&](std::uint32_t i) {
    return evaporates(s, p, i) && static_cast<double>(p.freeSurfaceIndicator[i]) > leastExposure * flat;
  };
  eachRow(v, select, [&](std::uint32_t i, auto&& neighbours) {
    const Mirrors walls = mirrorsOf(v, i);
    Vec3d sum{};
    neighbours([&](std::uint32_t j, const Vec3d& d, double q2) {
      const double V = volumeOf(s, p, j);
      const auto add = [&](const Vec3d& to, double at) {
        sum += to * (V * withKernel(s.numerics.kernel, [&](auto k) { return k.slope(at); }));
      };
      add(d, q2);
      if (walls.count > 0) eachImage(walls, d, add);
    });
    Vec3d gradient = sum * scale;
    for (std::size_t k = 0; k < walls.count; k++)
      gradient -= walls.normal[k] * (2 * s.spacing / h * wallGradient(v.tables, walls.distance[k]));
    p.volumeGradient[i] = single(gradient);
  });
}

void findVapour(const EvaporationView& v, const WallContext& walls, std::span<const double> pairEnergy,
                double dt) {
  const Scene& s = v.heat.scene;
  Continuum& p = v.heat.particles;
  const double flat = flatLatticeIndicator(s.numerics), depth = s.spacing * latticeGradient(s.numerics);
  std::fill_n(p.vapour.data(), p.owned, 0.0);
  std::fill_n(p.vapourEnergy.data(), p.owned, 0.0);
  const auto select = [&](std::uint32_t i) {
    const Vec3f& e = p.volumeGradient[i];
    return e.x != 0 || e.y != 0 || e.z != 0;
  };
  eachRow(v, select, [&](std::uint32_t i, auto&& neighbours) {
    const Material& m = s.materials[p.material[i]];
    const double T = p.temperature[i];
    if (!(valueAt(m.evaporation, T, Interpolation::Linear) > 0)) return;
    const double area = areaOf(v, i, flat, neighbours) / depth;
    if (area == 0) return;
    const double capacity = p.mass[i] * heatCapacityOf(s.numerics.heat, m, liquidFraction(p, i)),
                 most = mostCooling * capacity * T / (m.evaporationHeat * dt),
                 rate = std::min(area * meanRate(m.evaporation, T, area * m.evaporationHeat / capacity, dt),
                                 m.evaporationHeat > 0 && dt > 0 ? most : never),
                 heat = rate * m.evaporationHeat;
    p.heatFlow[i] -= heat;
    v.heat.ledger.heatIn.add(-heat * dt);
    v.heat.ledger.vapourHeat.add(heat * dt);
    // The remaining mass leaves when the particle is removed. Its latent heat is subtracted here.
    const double mass = std::min((1 - leastVapourFraction) * rate * dt, p.mass[i]);
    p.vapour[i] = mass;
    p.vapourEnergy[i] = mass / restDensityOf(p, s.materials, i) *
                            energyPerVolume(v, i, pairEnergy[i], neighbours) +
                        mass / p.mass[i] * springEnergy(v, walls, i);
  });
}

std::vector<std::uint32_t> removeVapour(const HeatView& v, const RecordContext& records, double dt) {
  const Scene& s = v.scene;
  Continuum& p = v.particles;
  const double cube = s.spacing * s.spacing * s.spacing;
  std::vector<std::uint32_t> gone;
  for (std::size_t i = 0; i < p.owned; i++) {
    const double loss = p.vapour[i];
    if (loss == 0) continue;
    p.vapour[i] = 0;
    if (p.phase[i] != Liquid) continue;
    const double left = p.mass[i] - loss;
    if (left < leastVapourFraction * s.materials[p.material[i]].density * cube) {
      gone.push_back(static_cast<std::uint32_t>(i));
      v.ledger.evaporated.add(p.mass[i]);
      continue;
    }
    recordVapour(v, i, loss, dt);
    v.ledger.evaporated.add(loss);
    double energy = p.vapourEnergy[i];
    const double before = v.modules.continuity ? compressionOf(records, p, i, 1) : 0;
    const double thinned = left / p.mass[i];
    p.mass[i] = left;
    if (v.modules.continuity) {
      const double compression = p.compression[i], density = 1 + compression;
      p.compression[i] = std::max(density * thinned, std::min(density, leastThinned)) - 1;
      energy += before - compressionOf(records, p, i, 1) - workOfLateKick(records, p, i, compression, dt);
    }
    v.ledger.left.potential.add(energy);
  }
  return gone;
}

}  // namespace thaw
