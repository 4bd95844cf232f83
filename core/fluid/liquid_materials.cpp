#include "core/fluid/liquid_materials.hpp"

#include <algorithm>
#include <cmath>

#include "core/scene/expected_speeds.hpp"

namespace thaw {

double expectedSpeed(const Scene& s) {
  const double g = length(s.domain.gravity);
  double height = 0, given = 0;
  for (const Body& b : s.bodies) given = std::max(given, length(b.velocity));
  for (const Emitter& e : s.emitters) given = std::max(given, e.speed);
  for (const Obstacle& o : s.obstacles) given = std::max(given, fastestMove(o.motion));
  if (g > 0) {
    const Vec3d down = normalized(s.domain.gravity), size = s.domain.max - s.domain.min;
    height = std::abs(down.x) * size.x + std::abs(down.y) * size.y + std::abs(down.z) * size.z;
  }
  return std::sqrt(given * given + 2 * g * std::min(height, s.fallHeight));
}

std::vector<LiquidMaterial> liquidMaterials(const Scene& s) {
  std::vector<LiquidMaterial> all;
  const double v = expectedSpeed(s), h = s.numerics.support * s.spacing;
  for (const Material& m : s.materials) {
    LiquidMaterial l;
    const double tension = std::sqrt(2 * m.surfaceTension / (m.density * s.spacing));
    l.soundSpeed = m.soundSpeed > 0 ? m.soundSpeed : std::max({v, tension, 1e-3}) / std::sqrt(s.numerics.maxDensityError);
    l.stiffness = m.density * l.soundSpeed * l.soundSpeed;
    l.artificial = m.artificialViscosity * l.soundSpeed * h * m.density / 10;
    l.rootTension = std::sqrt(m.surfaceTension);
    all.push_back(l);
  }
  return all;
}

double viscosityAt(const Material& m, double liquidFraction, double temperature) {
  const auto& t = m.viscosityTable;
  if (t.empty()) return m.viscosity.at(liquidFraction);
  if (temperature <= t.front().first) return t.front().second;
  for (std::size_t k = 1; k < t.size(); k++)
    if (temperature < t[k].first) {
      const double a = (temperature - t[k - 1].first) / (t[k].first - t[k - 1].first);
      return t[k - 1].second * std::pow(t[k].second / t[k - 1].second, a);
    }
  return t.back().second;
}

}  // namespace thaw
