#include "core/fluid/carried_density.hpp"

#include <algorithm>

#include "core/fluid/particle_pressure.hpp"

namespace thaw {
namespace {

/// A wall takes part as the liquid's pressure sees it (wall_forces.cpp): the same slope, so that the two are adjoint.
void addWalls(World& w, const StepTools& t) {
  Continuum& p = w.particles;
  const double h = w.grid.support;
  for (const WallContact& c : t.wallContacts.list) {
    const double push = t.perLatticeSum * t.wallTables(c.distance / h).push * c.share;
    if (p.crowding.active) p.crowding[c.row] += c.normal * -push;
    if (p.densityRate.active) p.densityRate[c.row] -= push / h * dot(p.velocity[c.row] - wallVelocity(w.walls.list[c.wall], p.position[c.row]), c.normal);
  }
}

/// Inside, from crowded to empty places (Lind 2012; Adami 2013 eq. 13 has .04 here). Not at a free surface, where the gradient is its normal.
void shift(World& w, const StepTools& t) {
  Continuum& p = w.particles;
  for (std::size_t i = 0; i < p.owned; i++) {
    Vec3d u{};
    if (liquidFraction(p, i) == 1 && static_cast<double>(p.filling[i]) > 0.9)
      u = p.crowding[i] * (-w.scene.numerics.shifting * t.liquids[p.material[i]].soundSpeed);
    p.smoothing[i] = u;
  }
}

/// What corrects gradients inside the liquid, less 1; 0 at surfaces and walls, whose part in the moment is not known. With it the rate becomes
/// that of the middle of the step of dt (s) that led here: the velocity is the one of that time, the places are those of its end. Left so, the
/// gradients are half a step ahead, their change is d/dt (grad.v) = -grad v : grad v at a velocity that stays, and what comes of it (the
/// Laplacian of the pressure is -rho grad v : grad v) gives the flow a power of dt/2 int |grad p|^2 / rho.
void correct(World& w, const StepTools& t, double dt) {
  Continuum& p = w.particles;
  std::vector<std::uint8_t> atWall(p.owned, 0);
  for (const WallContact& c : t.wallContacts.list) atWall[c.row] = 1;
  for (std::size_t i = 0; i < p.owned; i++) {
    const double weight = std::min(1.0, (static_cast<double>(p.filling[i]) - 0.9) / 0.05);
    Mat3d d{};
    if (weight > 0 && !atWall[i] && determinant(p.moment[i]) > 0.2) {
      d = inverse(p.moment[i]);
      const Mat3d gradient = d * p.flow[i];
      double turning = 0;
      for (int k = 0; k < 3; k++)
        for (int l = 0; l < 3; l++) turning += gradient.row[k][l] * gradient.row[l][k];
      p.densityRate[i] -= 0.5 * dt * weight * turning;
      for (int a = 0; a < 3; a++) d.row[a][a] -= 1;
      for (int a = 0; a < 3; a++)
        for (int b = 0; b < 3; b++) {
          d.row[a][b] *= weight;
          p.densityRate[i] += d.row[a][b] * p.flow[i].row[a][b];
        }
    }
    p.moment[i] = d;
  }
}

}  // namespace

void carryDensity(World& w, const StepTools& t, double dt) {
  Continuum& p = w.particles;
  const Numerics& n = w.scene.numerics;
  addWalls(w, t);
  if (w.modules.shifting) shift(w, t);
  if (!w.modules.continuity) return;
  if (w.modules.corrected) correct(w, t, dt);
  for (std::size_t i = 0; i < p.owned; i++) {
    const double f = liquidFraction(p, i);
    if (f == 0) {  // whether its cell has liquid beside it, and so any sums, depends on ranks
      p.compression[i] = 0;
      p.filling[i] = 1;
      continue;
    }
    const double flow = p.compression[i] + p.densityRate[i] * dt, spread = p.spreading[i] * dt;
    if (spread != 0) {
      const Material& m = w.scene.materials[p.material[i]];
      const auto energy = [&](double x) { return compressionEnergy(n.eos, t.liquids[p.material[i]].stiffness, 1 + x, n.tensileLimit); };
      p.dissipated[i] -= f * p.mass[i] / m.density * (energy(flow + spread) - energy(flow));
    }
    p.compression[i] = flow + spread;
    p.filling[i] = static_cast<float>(1 + p.compression[i]);
  }
}

}  // namespace thaw
