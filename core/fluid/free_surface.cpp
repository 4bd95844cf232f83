#include "core/fluid/free_surface.hpp"

#include <algorithm>
#include <cmath>

#include "core/fluid/particle_pressure.hpp"

namespace thaw {
namespace {

/// Asymmetry |sum V grad W| / sum V |grad W| above which a particle is at the free surface: 0.25 in the outermost layer of a lattice.
constexpr double surfaceAsymmetry = 0.19;
/// Spacings from a wall within which its normal is left out.
constexpr double wallLayer = 1.2;
/// Shifting velocity over h times the rate of strain, and over sqrt(|p| / rho) under tension, each per gradient of concentration.
constexpr double perStrain = 20, perTension = 40;

/// Calls action(row, contacts of the row) for each row that has contacts with walls.
template<class Action> void eachWallRow(const std::vector<WallContact>& list, Action action) {
  for (std::size_t begin = 0, end; begin < list.size(); begin = end) {
    for (end = begin; end < list.size() && list[end].row == list[begin].row;) end++;
    action(list[begin].row, std::span(list).subspan(begin, end - begin));
  }
}

Vec3d alongWalls(Vec3d v, std::span<const WallContact> contacts, double spacing) {
  for (const WallContact& c : contacts)
    if (c.distance < wallLayer * spacing) v -= c.normal * dot(v, c.normal);
  return v;
}

/// 1/s, norm of the rate of strain.
double strainRate(const Mat3d& flow) {
  double sum = 0;
  for (int a = 0; a < 3; a++)
    for (int b = 0; b < 3; b++) {
      const double e = 0.5 * (flow.row[a][b] + flow.row[b][a]);
      sum += e * e;
    }
  return std::sqrt(2 * sum);
}

}  // namespace

bool eigenvaluesAbove(const Mat3d& m, double least) {
  const double a = m.row[0][0] - least, b = m.row[1][1] - least, c = m.row[2][2] - least;
  const double d = m.row[0][1], e = m.row[0][2], f = m.row[1][2];
  return a > 0 && a * b - d * d > 0 && a * (b * c - f * f) - d * (d * c - f * e) + e * (d * f - b * e) > 0;  // Sylvester
}

void findFreeSurface(World& w, const StepTools& t) {
  Continuum& p = w.particles;
  const auto asymmetric = [&](std::size_t i, const Vec3d& gradient) {
    return length(gradient) > surfaceAsymmetry * static_cast<double>(p.gradientSize[i]);
  };
  for (std::size_t i = 0; i < p.owned; i++) {
    const bool wet = liquidFraction(p, i) > 0;
    p.atSurface[i] = wet && (w.modules.corrected ? !eigenvaluesAbove(p.moment[i], surfaceMoment) : asymmetric(i, p.crowding[i]));
  }
  eachWallRow(t.wallContacts.list, [&](std::size_t i, std::span<const WallContact> contacts) {
    p.atSurface[i] = liquidFraction(p, i) > 0 && asymmetric(i, alongWalls(p.crowding[i], contacts, w.scene.spacing));
  });
}

void shiftParticles(World& w, const StepTools& t) {
  Continuum& p = w.particles;
  const double h = w.grid.support;
  for (std::size_t i = 0; i < p.owned; i++) {
    p.smoothing[i] = {};
    if (liquidFraction(p, i) < 1 || p.atSurface[i]) continue;
    const double c = t.liquids[p.material[i]].soundSpeed;
    double speed = w.scene.numerics.shifting * c;
    if (w.modules.corrected) {
      const double tension = c * std::sqrt(std::max(0.0, -p.compression[i]));
      speed = std::min(speed, perStrain * h * strainRate(p.flow[i]) + perTension * tension);
    }
    Vec3d u = p.crowding[i] * -speed;
    const double beside = length(p.surfaceNormal[i]);
    if (beside > 1e-6) {
      const Vec3d inward = p.surfaceNormal[i] * (1 / beside);
      u -= inward * std::min(0.0, dot(u, inward));
    }
    p.smoothing[i] = u;
  }
  eachWallRow(t.wallContacts.list, [&](std::size_t i, std::span<const WallContact> contacts) {
    p.smoothing[i] = alongWalls(p.smoothing[i], contacts, w.scene.spacing);
  });
}

}  // namespace thaw
