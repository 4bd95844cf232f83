// SPDX-License-Identifier: Apache-2.0
#include "core/sheet/forces/outer_forces.hpp"

#include <algorithm>
#include <cmath>

#include "core/contact/touch.hpp"
#include "core/sheet/forces/brush_pressure.hpp"
#include "core/sheet/forces/cell_sums.hpp"

namespace thaw {
namespace {

/// Returns the wind pressure (Pa) on the upwind side: density (v . n)^2 along the normal. v: m/s, relative
/// velocity.
Vec3d windLoad(const SheetBody& b, double density, const Vec3d& v, const Vec3d& areaNormal, double area) {
  const double size = length(areaNormal);
  if (!(size > 0)) return {};
  const Vec3d n = areaNormal / size;
  const double un = dot(b.wind - v, n);
  return n * (density * un * std::abs(un) * size / area);
}

const Wall* wallNamed(const Walls& walls, const std::string& name) {
  for (const Wall& wall : walls.list)
    if (wall.properties.name == name && wall.present) return &wall;
  return nullptr;
}

/// Returns the force per area (N/m^2) of all walls. Records work and impulse.
Vec3d wallLoad(const SheetView& w, std::size_t i, const SheetVelocities& now, Vec3d& impulse) {
  SheetBodies& sheets = w.sheets;
  Sheets& s = sheets.rows;
  const SheetBody& b = w.scene.sheets[s.body[i]];
  const SheetPlan& plan = sheets.plans[s.body[i]];
  Vec3d load{};
  for (const Wall& wall : w.walls.list) {
    if (!wall.present) continue;
    const Vec3d rest = toRest(wall.pose, s.position[i]);
    const Vec3d u = wallVelocity(wall, s.position[i]);
    const double ahead = std::isfinite(now.span) ? contactLookAhead * now.span * length(now.velocity[i] - u)
                                                 : 0,
                 near = plan.thickness + ahead;
    if (!nearBounds(wall.bounds, rest, near)) continue;
    Vec3d n;
    const double d = wall.shape->distanceWithin(rest, near, &n);
    if (!(d < near)) continue;
    n = directionFromRest(wall.pose, n);
    const double rise = dot(now.velocity[i] - u, n);
    if (d - plan.thickness < std::max(0.0, -rise) * contactLookAhead * now.span || d < plan.thickness)
      sheets.impactRate = std::max(sheets.impactRate,
                                   blowRate(plan.contactRate, plan.thickness, std::abs(rise)));
    if (!(d < plan.thickness)) continue;
    const Touch touch = touchOf({plan.contactRate, sheets.laws[s.law[i]].contactMass,
                                 std::min(wall.properties.restitution, b.restitution),
                                 std::max(wall.properties.friction, b.friction), now.span},
                                plan.thickness - d, n, now.velocity[i] - u);
    load += touch.force;
    s.energy[i] += touch.energy * s.area[i];
    s.dissipativeForce[i] += touch.dissipativeForce;
    if (!wall.properties.motion.empty()) {
      w.ledger.wallWork.add(dot(touch.force, u) * s.area[i] * now.dt);
      // kickSheets records the dissipation at a fixed wall
      s.dissipated[i] += dot(touch.dissipativeForce, u) * s.area[i] * now.dt;
    }
    sheets.slope[i] += touch.slope;
    if (s.temperature.active && wall.properties.temperature && b.conductance > 0) {
      const double rate = b.conductance * s.area[i];
      s.heatFlow[i] += averaged(rate / (s.area[i] * b.heatCapacity), now.span) * s.area[i] * b.heatCapacity *
                       (*wall.properties.temperature - s.temperature[i]);
    }
  }
  impulse += load * s.area[i];
  return load;
}

}  // namespace

void clearLoads(SheetBodies& sheets, const Scene& scene) {
  Sheets& s = sheets.rows;
  const Vec3d g = scene.domain.gravity;
  for (std::size_t i = 0; i < s.owned; i++) {
    s.load[i] = sheets.laws[s.law[i]].law.mass * g;
    s.energy[i] = 0;
  }
  if (s.outside.active) std::fill_n(s.outside.data(), s.owned, Vec3d{});
  if (s.dissipativeForce.active) std::fill_n(s.dissipativeForce.data(), s.owned, Vec3d{});
  if (s.heatFlow.active) std::fill_n(s.heatFlow.data(), s.owned, 0.0);
  if (s.changing.active) std::fill_n(s.changing.data(), s.owned, Mat3d{});
}

void addOuterForces(const SheetView& w, const SheetVelocities& now) {
  SheetBodies& sheets = w.sheets;
  Sheets& s = sheets.rows;
  const double time = w.clock.time + now.dt;  // time of these forces
  bool walls = false;
  for (const Wall& wall : w.walls.list) walls = walls || wall.present;
  if (!walls && !s.outside.active) return;
  struct Pushes {
    double shrinkWrap;
    const Wall* target;
    std::vector<std::vector<PressureSample>> brush;
  };
  std::vector<Pushes> pushes;
  for (std::size_t n = 0; n < w.scene.sheets.size(); n++) {
    const SheetBody& b = w.scene.sheets[n];
    pushes.push_back({b.shrinkWrap * sheets.factors[n].now[placeOf(SheetFactor::ShrinkWrap)],
                      b.shrinkWrapTo.empty() ? nullptr : wallNamed(w.walls, b.shrinkWrapTo),
                      {}});
    // addShrinkWrap handles bodies. A removed target causes no shrink-wrap
    if (!b.shrinkWrapTo.empty() && !pushes.back().target) pushes.back().shrinkWrap = 0;
    for (const PressureBrush& brush : b.pressureBrushes)
      pushes.back().brush.push_back(pressureSamples(brush, time, now.dt));
  }
  std::vector<Vec3d>& impulse = sheets.impulseBuffer;
  impulse.resize(s.owned);
  for (std::size_t i = 0; i < s.owned; i++) {
    const SheetBody& b = w.scene.sheets[s.body[i]];
    const Pushes& p = pushes[s.body[i]];
    Vec3d out{};
    const auto& factor = sheets.laws[s.law[i]].factor;
    const double pressure = p.shrinkWrap * factor[placeOf(SheetFactor::ShrinkWrap)];
    if (const double density = b.windDensity * factor[placeOf(SheetFactor::Wind)] *
                               sheets.factors[s.body[i]].now[placeOf(SheetFactor::Wind)];
        density > 0) {
      out += windLoad(b, density, now.velocity[i], s.areaNormal[i], s.area[i]);
    }
    if (pressure != 0) {
      if (p.target) {
        Vec3d n;
        p.target->shape->distance(toRest(p.target->pose, s.position[i]), &n);
        out -= pressure * directionFromRest(p.target->pose, n);
      } else {
        out -= (pressure / s.area[i]) * s.areaNormal[i];
      }
    }
    for (std::size_t k = 0; k < p.brush.size(); k++)
      if (!p.brush[k].empty()) out += brushPressure(b.pressureBrushes[k], p.brush[k], s.position[i]);
    impulse[i] = out * s.area[i];
    if (s.outside.active) s.outside[i] = out;
    s.load[i] += out;
    if (walls) s.load[i] += wallLoad(w, i, now, impulse[i]);
  }
  addByCell3(sheets.cells, s.owned, w.ledger.wallForce, [&](std::size_t i) { return impulse[i]; });
}

double fastestDrag(const SheetBodies& sheets, const Scene& scene, const SheetVelocities& now) {
  const Sheets& s = sheets.rows;
  double fastest = 0;
  for (std::size_t i = 0; i < s.owned && s.areaNormal.active; i++) {
    const SheetBody& b = scene.sheets[s.body[i]];
    const double density = b.windDensity * sheets.laws[s.law[i]].factor[placeOf(SheetFactor::Wind)] *
                           sheets.factors[s.body[i]].most[placeOf(SheetFactor::Wind)];
    if (!(density > 0) || !(s.mass[i] > 0)) continue;
    const double perSpeed = 2 * density * length(s.areaNormal[i]) / s.mass[i],
                 rate = perSpeed * length(b.wind - now.velocity[i]),
                 faster = perSpeed * length(s.load[i]) * s.area[i] / s.mass[i];
    fastest = std::max(fastest, 0.5 * (rate + std::sqrt(rate * rate + 4 * dragInAStep * faster)));
  }
  return fastest;
}

void addRestEnergy(SheetBodies& sheets, const Scene& scene, double time) {
  Sheets& s = sheets.rows;
  for (std::size_t i = 0; i < s.owned; i++) {
    const SheetBody& b = scene.sheets[s.body[i]];
    const double k = sheets.laws[s.law[i]].law.stiffness;
    if (!(k > 0)) continue;
    Vec3d z = s.position[i] - s.rest[i];
    if (s.flow.active) z -= s.flow[i];
    s.energy[i] += 0.5 * k * b.factorAt(SheetFactor::Stiffness, time) * s.area[i] * dot(z, z);
  }
}

void recordConstraintImpulse(const SheetBodies& sheets, Ledger& ledger, double sign, double dt) {
  const Sheets& s = sheets.rows;
  bool any = s.clamped.active;
  for (const SheetLaw& l : sheets.laws) any = any || l.law.damping > 0 || l.law.stiffness > 0;
  if (!any) return;
  addByCell3(sheets.cells, s.owned, ledger.wallImpulse, [&](std::size_t i) {
    const SpringLaw& l = sheets.laws[s.law[i]].law;
    const bool free = !(l.damping > 0) && !(l.stiffness > 0) && !(s.clamped.active && s.clamped[i]);
    return free ? Vec3d{} : s.velocity[i] * (sign * s.mass[i]) - s.load[i] * (0.5 * dt * s.area[i]);
  });
}

void recordExternalWork(const SheetBodies& sheets, Ledger& ledger) {
  const Sheets& s = sheets.rows;
  addByCell(sheets.cells, s.owned, ledger.wallWork,
            [&](std::size_t i) { return 0.5 * dot(s.outside[i], s.moved[i]) * s.area[i]; });
}

}  // namespace thaw
