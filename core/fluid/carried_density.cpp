#include "core/fluid/carried_density.hpp"

#include <algorithm>

#include "core/fluid/free_surface.hpp"
#include "core/fluid/particle_pressure.hpp"

namespace thaw {
namespace {

/// A wall takes part as the liquid's pressure sees it (wall_forces.cpp): the same slope, so that the two are adjoint. dt: of the step that led here; the
/// rate is the mean of both its ends, as between particles.
void addWalls(World& w, const StepTools& t, double dt) {
  Continuum& p = w.particles;
  const double h = w.grid.support;
  for (const WallContact& c : t.wallContacts.list) {
    const double push = t.perLatticeSum * t.wallTables(c.distance / h).push * c.share;
    if (p.crowding.active) p.crowding[c.row] += c.normal * (-0.5 * push);  // the pressure's slope is twice that of the wall's own filling
    if (!p.densityRate.active) continue;
    const double off = dot(p.velocity[c.row] - wallVelocity(w.walls.list[c.wall], p.position[c.row]), c.normal);
    const double before = t.perLatticeSum * t.wallTables((c.distance - dt * off) / h).push * c.share;
    p.densityRate[c.row] -= 0.5 * (before + push) / h * off;
  }
}

/// Shifting with a summed density: inside, from crowded to empty places. Not at a free surface, where the gradient is its normal.
void shiftInside(World& w, const StepTools& t) {
  Continuum& p = w.particles;
  for (std::size_t i = 0; i < p.owned; i++) {
    const bool inside = liquidFraction(p, i) == 1 && static_cast<double>(p.filling[i]) > 0.9;
    p.smoothing[i] = inside ? p.crowding[i] * (-w.scene.numerics.shifting * t.liquids[p.material[i]].soundSpeed) : Vec3d{};
  }
}

/// Density correction of a step beyond the tolerated disorder: particles that are denser by their places than the density that they carry, since
/// shifting and splashing change places without a flow.
double overdense(double summed, double compression, double stepsOfSound) {
  constexpr double tolerated = 0.03, perStep = 0.05;
  return std::min(1.0, perStep * stepsOfSound) * std::max(0.0, summed - 1 - compression - tolerated);
}

/// What corrects gradients inside the liquid, less 1; 0 at surfaces and walls, whose part in the moment is not known. Adds the half of the rate that has
/// the gradients of the end of the step; that of its beginning is there.
void correct(World& w, const StepTools& t) {
  Continuum& p = w.particles;
  for (const WallContact& c : t.wallContacts.list) p.moment[c.row] = {};
  for (std::size_t i = 0; i < p.owned; i++) {
    if (liquidFraction(p, i) == 0) {  // whether its cell has liquid beside it, and so any sums, depends on ranks
      p.correction[i] = {};
      continue;
    }
    const double weight = std::min(1.0, (static_cast<double>(p.filling[i]) - 0.9) / 0.05);
    Mat3d d{};
    if (weight > 0 && eigenvaluesAbove(p.moment[i], 0.4)) {  // corrections of more than 2.5 would be stiffer than the step allows
      d = inverse(p.moment[i]);
      for (int a = 0; a < 3; a++) d.row[a][a] -= 1;
    }
    double divergence = 0;
    for (int a = 0; a < 3; a++)
      for (int b = 0; b < 3; b++) {
        d.row[a][b] *= weight;
        divergence += ((a == b ? 1 : 0) + d.row[a][b]) * p.flow[i].row[a][b];
      }
    p.densityRate[i] += 0.5 * divergence;
    p.correction[i] = d;
  }
}

}  // namespace

void carryDensity(World& w, const StepTools& t, double dt) {
  Continuum& p = w.particles;
  const Numerics& n = w.scene.numerics;
  addWalls(w, t, dt);
  if (p.atSurface.active) {
    findFreeSurface(w, t);
    shiftParticles(w, t);
  } else if (w.modules.shifting) {
    shiftInside(w, t);
  }
  if (!w.modules.continuity) return;
  if (w.modules.corrected) correct(w, t);
  constexpr double tooCrowded = 1.3;
  w.counters.crowded = 0;
  for (std::size_t i = 0; i < p.owned; i++) {
    const double f = liquidFraction(p, i);
    if (f == 0) {  // as above
      p.compression[i] = 0;
      p.filling[i] = 1;
      continue;
    }
    w.counters.crowded += static_cast<double>(p.filling[i]) > tooCrowded * (1 + p.compression[i]);
    const double flow = p.compression[i] + p.densityRate[i] * dt;
    double spread = p.spreading[i] * dt;
    if (p.atSurface.active)
      spread += overdense(static_cast<double>(p.filling[i]), flow + spread, t.liquids[p.material[i]].soundSpeed * dt / w.grid.support);
    if (spread != 0) {
      const Material& m = w.scene.materials[p.material[i]];
      const auto energy = [&](double x) { return compressionEnergy(n.eos, t.liquids[p.material[i]].stiffness, 1 + x, n.tensileLimit); };
      const double before = p.compression[i];  // half of it at either end of the step: its pressure is half of what the flow works against
      p.dissipated[i] -= 0.5 * f * p.mass[i] / m.density * (energy(flow + spread) - energy(flow) + energy(before + spread) - energy(before));
    }
    p.compression[i] = flow + spread;
    p.filling[i] = static_cast<float>(1 + p.compression[i]);
  }
}

}  // namespace thaw
