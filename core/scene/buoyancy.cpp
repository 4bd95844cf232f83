// SPDX-License-Identifier: Apache-2.0
#include "core/scene/buoyancy.hpp"

#include <algorithm>
#include <cmath>

#include "core/scene/material_use.hpp"
#include "core/scene/temperature_table.hpp"

namespace thaw {

bool hasBuoyancy(const Scene& s) {
  if (!(length(s.domain.gravity) + length(s.domain.buoyantGravity) > 0)) return false;
  for (std::size_t k = 0; k < s.materials.size(); k++)
    if (expands(s.materials[k]) && inUse(s, k)) return true;
  return false;
}

double referenceTemperature(const Domain& d, const Material& m) {
  return m.expansionFrom > 0 ? m.expansionFrom : d.ambient;
}

double densityDeficit(const Domain& d, const Material& m, double T) {
  if (!m.densityTable.empty()) return 1 - valueAt(m.densityTable, T, Interpolation::Linear) / m.density;
  return m.expansion * (T - referenceTemperature(d, m));
}

ValueRange temperatureRange(const Scene& s) {
  ValueRange range;
  for (const Body& b : s.bodies)
    if (!b.temperatureField) range.see(b.temperature);
  for (const Emitter& e : s.emitters)
    if (!e.temperatureField) range.see(e.temperature);
  for (const Obstacle& o : s.obstacles)
    if (o.temperature) range.see(*o.temperature);
  for (const Thermostat& t : s.thermostats) range.see(t.temperature);
  for (std::size_t k = 0; k < s.materials.size(); k++)
    if (const Material& m = s.materials[k]; inUse(s, k) && (m.convection > 0 || m.emissivity > 0))
      range.see(s.domain.ambient);
  if (s.expected.coldest <= s.expected.hottest) range.see(s.expected.coldest), range.see(s.expected.hottest);
  return range;
}

ValueRange deficitRange(const Scene& s) {
  const ValueRange temperatures = temperatureRange(s);
  ValueRange range;
  if (temperatures.empty()) return range;
  for (std::size_t k = 0; k < s.materials.size(); k++) {
    const Material& m = s.materials[k];
    if (!inUse(s, k)) continue;
    if (!expands(m)) {
      range.see(0);
      continue;
    }
    for (const double T : {temperatures.low, temperatures.high}) range.see(densityDeficit(s.domain, m, T));
    for (const auto& [T, density] : m.densityTable)  // an extreme value may lie between
      if (T > temperatures.low && T < temperatures.high) range.see(densityDeficit(s.domain, m, T));
  }
  return range;
}

namespace {

bool someSolid(const Scene& s) {
  for (std::size_t k = 0; k < s.materials.size(); k++)
    if (s.materials[k].canBeSolid() && inUse(s, k)) return true;
  return false;
}

}  // namespace

double neutralDeficit(const Scene& s) {
  if (s.numerics.buoyancy != Buoyancy::Boussinesq || someSolid(s)) return 0;
  const ValueRange range = deficitRange(s);
  return range.empty() ? 0 : 0.5 * (range.low + range.high);
}

double buoyantSpeed(const Scene& s) {
  if (!hasBuoyancy(s)) return 0;
  const Vec3d g = s.domain.gravity + s.domain.buoyantGravity;
  double height = 0;  // height times gravity
  for (int a = 0; a < 3; a++) height += std::abs(g[a]) * (s.domain.max[a] - s.domain.min[a]);
  return 0.5 * std::sqrt(height * deficitRange(s).width());
}

namespace {

/// Returns true if the side of an axis is covered by a plane that stays in place.
bool coveredByPlane(const Scene& s, int axis, bool high) {
  const double at = high ? s.domain.max[axis] : s.domain.min[axis], inward = high ? -1 : 1;
  return std::any_of(s.obstacles.begin(), s.obstacles.end(), [&](const Obstacle& o) {
    const Shape& p = o.shape;
    if (p.kind != ShapeKind::HalfSpace || !o.motion.empty() || o.until < never) return false;
    if (length(p.rotate) > 0 || p.fitHeight || p.bottom || p.scale != 1) return false;
    return p.normal[axis] * inward > (1 - 1e-9) * length(p.normal) &&
           std::abs(p.point[axis] + p.move[axis] - at) < 1e-6 * s.spacing;
  });
}

bool isClosed(const Scene& s) {
  for (int a = 0; a < 3; a++)
    for (const bool high : {false, true})
      if (s.domain.side[static_cast<std::size_t>(a)][high] == Side::Open && !coveredByPlane(s, a, high))
        return false;
  return std::all_of(s.obstacles.begin(), s.obstacles.end(), [&](const Obstacle& o) {
    return o.shape.kind == ShapeKind::HalfSpace && o.motion.empty();
  });
}

}  // namespace

bool liquidFillsClosedDomain(const Scene& s) {
  if (s.bodies.empty() || !s.emitters.empty() || !s.oriented.empty() || !s.sheets.empty() || !isClosed(s))
    return false;
  const Vec3d size = s.domain.max - s.domain.min;
  double filled = 0;
  for (const Body& b : s.bodies) {
    const Material& m = s.materials[static_cast<std::size_t>(b.material)];
    const Shape& box = b.shape;
    if (m.canBeSolid() || m.density != s.materials[static_cast<std::size_t>(s.bodies[0].material)].density)
      return false;
    if (box.kind != ShapeKind::Box || box.fitHeight || box.bottom || length(box.rotate) > 0) return false;
    filled += box.size.x * box.size.y * box.size.z * box.scale * box.scale * box.scale;
  }
  return std::abs(filled / (size.x * size.y * size.z) - 1) < 1e-6;
}

}  // namespace thaw
