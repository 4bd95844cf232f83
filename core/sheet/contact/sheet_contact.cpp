// SPDX-License-Identifier: Apache-2.0
#include "core/sheet/contact/sheet_contact.hpp"

#include <algorithm>
#include <cmath>

#include "core/contact/touch.hpp"
#include "core/halo/exchange.hpp"
#include "core/materials/enthalpy.hpp"
#include "core/neighbours/rows_around.hpp"
#include "core/sheet/contact/face_contact.hpp"
#include "core/sheet/contact/mesh_contact.hpp"
#include "core/sheet/contact/particle_contact.hpp"
#include "core/sheet/data/touching_sheets.hpp"
#include "core/sheet/forces/time_factors.hpp"
#include "core/sheet/search/mesh_pairs.hpp"

namespace thaw {
namespace {

double pairMass(double a, double b) { return a * b / (a + b); }

// Returns the contact mass (kg).
double massOf(const SheetBodies& sheets, std::size_t i) {
  const Sheets& s = sheets.rows;
  return sheets.laws[s.law[i]].contactMass * s.area[i];
}

/// Returns the repulsion or attraction (N/m) of a vertex at a time factor of 1.
double ownOf(const SheetBodies& sheets, const Scene& scene, SheetFactor f, std::size_t i) {
  const Sheets& s = sheets.rows;
  return scene.sheets[s.body[i]].*sheetCoefficients[placeOf(f)].value *
         sheets.laws[s.law[i]].factor[placeOf(f)];
}

/// Mean stiffness (N/m) of both ends. stiffness: present value; later: maximum until the end of the next
/// step, for the slope.
struct PairSpring {
  double own, stiffness, later;
};
PairSpring pairSpring(const SheetBodies& sheets, const Scene& scene, SheetFactor f, std::size_t i,
                      std::size_t j) {
  const Sheets& s = sheets.rows;
  const double own = 0.5 * ownOf(sheets, scene, f, i), other = 0.5 * ownOf(sheets, scene, f, j);
  if (!(own > 0) && !(other > 0)) return {};
  const FactorsNow &p = sheets.factors[s.body[i]], &q = sheets.factors[s.body[j]];
  const std::size_t k = placeOf(f);
  return {own, own * p.now[k] + other * q.now[k], own * p.most[k] + other * q.most[k]};
}

/// Adds repulsion and attraction between vertices.
void addVertexForces(SheetBodies& b, const Scene& scene) {
  Sheets& s = b.rows;
  std::vector<double> slope(s.owned, 0);
  double reach2 = 0;
  for (std::size_t k = 0; k < b.plans.size(); k++) {
    const double r = b.plans[k].thickness +
                     (scene.sheets[k].attraction > 0 ? scene.sheets[k].attractionRange : 0);
    reach2 = std::max(reach2, r * r);
  }
  eachNear(b.cells, s.owned, b.cells, [&](std::size_t i, std::size_t j) {
    if (i == j) return;
    // the same difference at both ends, except for the sign
    const Vec3d d = s.position[i] - s.position[j];
    const double r2 = dot(d, d);
    if (!(r2 < reach2) || !(r2 > 0)) return;
    const SheetPlan &p = b.plans[s.body[i]], &q = b.plans[s.body[j]];
    const SheetBody &x = scene.sheets[s.body[i]], &y = scene.sheets[s.body[j]];
    const bool same = s.body[i] == s.body[j];
    if (same) {
      if (!(x.repulsion > 0) && !(x.attraction > 0)) return;
      const Vec3d apart = s.rest[i] - s.rest[j];
      const double never2 = exclusionDistance(p) * exclusionDistance(p);
      if (dot(apart, apart) < never2) return;
    }
    const double r = std::sqrt(r2), thick = 0.5 * (p.thickness + q.thickness), depth = thick - r;
    const Vec3d n = d / r;
    Vec3d force{};
    double energy = 0;
    const double beyond = -depth, reach = std::max(x.attractionRange, y.attractionRange);
    if (const PairSpring repulsion = pairSpring(b, scene, SheetFactor::Repulsion, i, j);
        repulsion.later > 0 && depth > 0) {
      const double unit = 0.5 * depth * depth;
      force += n * (repulsion.stiffness * depth);
      energy += repulsion.stiffness * unit;
      slope[i] += repulsion.later;
      if (s.changing.active) factorEnergyOf(s, i, SheetFactor::Repulsion) += repulsion.own * unit;
    }
    if (const PairSpring attraction = pairSpring(b, scene, SheetFactor::Attraction, i, j);
        attraction.later > 0 && beyond < reach) {
      const double u = std::max(beyond, 0.0) / reach,
                   unit = reach * reach * (u * u * (0.5 - u * (2.0 / 3) + 0.25 * u * u) - 1.0 / 12);
      force -= n * (attraction.stiffness * reach * u * (1 - u) * (1 - u));
      energy += attraction.stiffness * unit;
      slope[i] += attraction.later;
      if (s.changing.active) factorEnergyOf(s, i, SheetFactor::Attraction) += attraction.own * unit;
    }
    s.load[i] += force / s.area[i];
    s.energy[i] += 0.5 * energy;
  });
  for (std::size_t i = 0; i < s.owned; i++) b.slope[i] += 2 * slope[i] / s.area[i];
}

/// Contact of a vertex and a continuum particle.
struct PairContact {
  Touch touch;
  double heat = 0;  ///< W, to the vertex
};

struct Particles {
  SheetView w;
  const SheetVelocities& now;
  bool heat;
  bool meet(std::size_t i, std::size_t j, PairContact& m) const {
    const Sheets& s = w.sheets.rows;
    const Continuum& p = w.particles;
    const SheetPlan& plan = w.sheets.plans[s.body[i]];
    if (plan.byFaces) return false;
    const Vec3d d = s.position[i] - p.position[j];
    const double reach = 0.5 * (plan.thickness + w.scene.spacing), r2 = dot(d, d);
    if (!(r2 < reach * reach) || !(r2 > 0)) return false;
    const SheetBody& b = w.scene.sheets[s.body[i]];
    const Material& material = w.scene.materials[p.material[j]];
    const double r = std::sqrt(r2), liquid = p.liquid.active        ? static_cast<double>(p.liquid[j])
                                             : p.phase[j] == Liquid ? 1
                                                                    : 0;
    // mass of the particle's part that this vertex supports
    const double mass = pairMass(massOf(w.sheets, i), p.mass[j]),
                 part = std::min(1.0, s.area[i] / (w.scene.spacing * w.scene.spacing));
    m.touch = touchOf({plan.contactRate, mass, std::min(b.restitution, material.restitution),
                       (1 - liquid) * std::max(b.friction, material.friction), now.span,
                       part * particleBarrier(plan, p.material[j], p.mass[j]), reach},
                      reach - r, d / r, s.moving[i] - p.velocity[j]);
    m.heat = 0;
    if (heat && b.conductance > 0) {
      const double area = std::min(s.area[i], w.scene.spacing * w.scene.spacing), flow = b.conductance * area;
      // stable for up to eight pairs
      const double rate = 8 * flow *
                          (1 / (s.area[i] * b.heatCapacity) +
                           1 / (p.mass[j] * heatCapacityOf(w.scene.numerics.heat, material, liquid)));
      m.heat = flow * (averaged(rate, now.span) / rate) * (p.temperature[j] - s.temperature[i]);
    }
    return true;
  }
};

void addParticleContact(const SheetView& w, const SheetVelocities& now) {
  SheetBodies& b = w.sheets;
  Sheets& s = b.rows;
  Continuum& p = w.particles;
  const Particles pair{w, now, s.temperature.active && p.temperature.active && p.heatFlow.active};
  std::vector<double> slope(s.owned, 0);
  PairContact m;
  eachNear(b.cells, s.owned, w.cells, [&](std::size_t i, std::size_t j) {
    if (!pair.meet(i, j, m)) return;
    s.load[i] += m.touch.force / s.area[i];
    s.energy[i] += 0.5 * m.touch.energy;
    s.dissipativeForce[i] += m.touch.dissipativeForce / s.area[i];
    if (s.heatFlow.active) s.heatFlow[i] += m.heat;
    slope[i] += m.touch.slope;
  });
  for (std::size_t i = 0; i < s.owned; i++) b.slope[i] += 2 * slope[i] / s.area[i];
  std::vector<double> stiff(p.owned, 0);
  eachNear(w.cells, p.owned, b.cells, [&](std::size_t j, std::size_t i) {
    if (!pair.meet(i, j, m)) return;
    p.force[j] -= m.touch.force;
    p.interaction[j] += 0.5 * m.touch.energy;
    // Dissipation of both ends, at the velocity after half of this kick. The last acceleration approximates
    // the kick.
    p.dissipation[j] += dot(m.touch.dissipativeForce, p.velocity[j] + p.acceleration[j] * (0.5 * now.dt));
    if (pair.heat) {
      p.heatFlow[j] -= m.heat;
      w.ledger.heatIn.add(-m.heat * now.dt);
    }
    stiff[j] += 2 * m.touch.slope / p.mass[j];
  });
  for (const double x : stiff) b.stiffestParticle = std::max(b.stiffestParticle, x);
}

/// Adds contact of vertices and oriented particles, as with the continuum, but without heat. The force on
/// oriented particles is constant over their next step.
void addOrientedContact(SheetBodies& b, OrientedBodies& oriented, const Scene& scene,
                        const SheetVelocities& now) {
  Sheets& s = b.rows;
  Oriented& o = oriented.rows;
  const auto meet = [&](std::size_t i, std::size_t j, Touch& touch) {
    const SheetPlan& plan = b.plans[s.body[i]];
    const OrientedBody& other = scene.oriented[o.body[j]];
    const SheetBody& sheet = scene.sheets[s.body[i]];
    const double spacing = spacingOf(scene, other);
    const Vec3d d = s.position[i] - o.position[j];
    const double reach = 0.5 * (plan.thickness + spacing), r2 = dot(d, d);
    if (!(r2 < reach * reach) || !(r2 > 0)) return false;
    const double r = std::sqrt(r2), mass = orientedMass(other, spacing);  // not the column, because ghosts
                                                                          // have no mass
    touch = touchOf({plan.contactRate, pairMass(massOf(b, i), mass), sheet.restitution,
                     std::max(sheet.friction, other.friction), now.span},
                    reach - r, d / r, s.moving[i] - o.velocity[j]);
    return true;
  };
  std::vector<double> slope(s.owned, 0);
  Touch touch;
  eachNear(b.cells, s.owned, oriented.cells, [&](std::size_t i, std::size_t j) {
    if (!meet(i, j, touch)) return;
    s.load[i] += touch.force / s.area[i];
    s.energy[i] += 0.5 * touch.energy;
    s.dissipativeForce[i] += touch.dissipativeForce / s.area[i];
    slope[i] += touch.slope;
  });
  for (std::size_t i = 0; i < s.owned; i++) b.slope[i] += 2 * slope[i] / s.area[i];
  eachNear(oriented.cells, o.owned, b.cells, [&](std::size_t j, std::size_t i) {
    if (!meet(i, j, touch)) return;
    Vec3d force = touch.force, dissipativeForce = touch.dissipativeForce;
    if (scene.oriented[o.body[j]].planar) force.y = dissipativeForce.y = 0;
    o.force[j] -= force;
    o.external[j] -= force;
    o.dissipativeForce[j] -= dissipativeForce;
    o.energy[j] += 0.5 * touch.energy;
    o.stiffness[j] += 2 * touch.slope / o.mass[j];
  });
}

}  // namespace

namespace {

bool hasVertexForces(const Scene& s) {
  return std::any_of(s.sheets.begin(), s.sheets.end(),
                     [](const SheetBody& b) { return b.repulsion > 0 || b.attraction > 0; });
}

}  // namespace

bool sheetsInteract(const Scene& s) { return hasVertexForces(s) || meshesTouch(s); }

bool sheetsTouchContinuum(const Scene& s) { return !s.sheets.empty() && hasContinuum(s); }

double exclusionDistance(const SheetPlan& p) { return std::max(2 * p.spacing, 1.3 * p.thickness); }

void addSheetContacts(const SheetView& w, Halos halos, const SheetVelocities& now) {
  SheetBodies& b = w.sheets;
  Sheets& s = b.rows;
  const bool meshes = meshesTouch(w.scene), pushes = hasVertexForces(w.scene),
             continuum = sheetsTouchContinuum(w.scene), oriented = w.modules.sheetContact;
  bool points = false, faces = false;  // types of contact with the continuum
  for (const SheetPlan& p : b.plans) (p.byFaces ? faces : points) = true;
  if (!meshes && !pushes && !continuum && !oriented) return;
  std::copy(now.velocity.begin(), now.velocity.end(), s.moving.data());
  ColumnList columns{&s.position, &s.moving, &s.rest, &s.area, &s.body, &s.law};
  if (s.temperature.active) columns.push_back(&s.temperature);
  if (faces || meshes) columns.push_back(&s.id);
  sendGhosts(*halos.bodyTypes[sheetType], s, b.cells, columns).wait();
  if (faces || meshes) {
    if (!b.search) b.search = std::make_shared<MeshSearch>();
    findMeshRows(s, b.cells, b.plans, b.search->rows);
  }
  if (meshes) addMeshContact(b, w.scene, now);
  if (pushes) addVertexForces(b, w.scene);
  if (continuum && points) addParticleContact(w, now);
  if (continuum && faces) addFaceContact(w, halos, now);
  if (oriented) addOrientedContact(b, w.oriented, w.scene, now);
}

}  // namespace thaw
