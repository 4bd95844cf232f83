// SPDX-License-Identifier: Apache-2.0
#include "core/sheet/contact/face_contact.hpp"

#include <algorithm>
#include <cmath>

#include "core/halo/exchange.hpp"
#include "core/materials/enthalpy.hpp"
#include "core/neighbours/rows_around.hpp"
#include "core/sheet/contact/face_depth.hpp"
#include "core/sheet/contact/friction.hpp"
#include "core/sheet/contact/particle_contact.hpp"
#include "core/sheet/search/mesh_pairs.hpp"
#include "core/sheet/search/nearest_points.hpp"

namespace thaw {
namespace {

constexpr double coarser = 0.75;  // particle spacings between vertices, above which triangles are used

/// Triangle near a cell, with rows and positions (m) of its corners.
struct Face {
  std::uint32_t number;
  std::array<std::uint32_t, 3> row;
  std::array<Vec3d, 3> x;
  Vec3d low, high;  ///< bounds of its contact region
};

/// Contact of one sheet with all particles.
struct FaceContact {
  SheetView w;
  const SheetVelocities& now;
  std::size_t sheet;
  const SheetPlan& plan;
  const SheetBody& body;
  const MeshRows& rows;
  std::vector<double> slope;  // N/m, of owned vertices

  FaceContact(const SheetView& view, const SheetVelocities& velocities, std::size_t n)
      : w(view),
        now(velocities),
        sheet(n),
        plan(view.sheets.plans[n]),
        body(view.scene.sheets[n]),
        rows(view.sheets.search->rows),
        slope(view.sheets.rows.owned, 0) {}

  std::vector<RowSpan> ranges;
  std::vector<Face> faces;

  /// Finds the triangles within reach of particles in this cell. All corners lie in cells adjacent to it and
  /// to each other, so the owners of all corners find the same triangles.
  void facesNear(std::uint64_t key) {
    faces.clear();
    const Sheets& s = w.sheets.rows;
    const Vec3i cell = cellOfKey(key);
    rowsAround(w.sheets.cells, key, ranges);
    for (const RowSpan& r : ranges)
      for (std::uint32_t i = r.begin; i < r.end; i++) {
        if (s.body[i] != sheet) continue;
        const std::uint32_t v = vertexOf(s.id[i]);
        for (std::uint32_t k = plan.faceFirst[v]; k < plan.faceFirst[v + 1]; k++) {
          Face f{plan.faceOf[k], rowsOfTriangle(rows, plan, sheet, plan.faceOf[k]), {}, {}, {}};
          bool here = true;
          for (std::size_t q = 0; q < 3 && here; q++) {
            here = f.row[q] != noLocalRow && beside(rows.cell[f.row[q]], cell);
            if (here) f.x[q] = s.position[f.row[q]];
          }
          if (!here || !allAdjacent(rows, f.row)) continue;
          for (int a = 0; a < 3; a++) {
            f.low[a] = std::min({f.x[0][a], f.x[1][a], f.x[2][a]}) - plan.faceReach;
            f.high[a] = std::max({f.x[0][a], f.x[1][a], f.x[2][a]}) + plan.faceReach;
          }
          faces.push_back(f);
        }
      }
  }

  /// Contact geometry of a face and a particle.
  struct Near {
    const Face* face;
    Vec3d shares, off;  ///< barycentric coordinates of the nearest point; vector (m) from the particle to it
    double depth;       ///< 1, fraction of the reach
    Vec3d n;
  };
  bool near(const Face& f, const Vec3d& x, Near& found) const {
    if (x.x < f.low.x || x.y < f.low.y || x.z < f.low.z || x.x > f.high.x || x.y > f.high.y || x.z > f.high.z)
      return false;
    // corners relative to the particle, so the bits depend only on differences
    const Vec3d a = f.x[0] - x, b = f.x[1] - x, c = f.x[2] - x, u = sharesOfNearest(a, b, c, {}),
                d = u.x * a + u.y * b + u.z * c;
    const double r = length(d), depth = 1 - r / plan.faceReach;
    if (!(depth > 0)) return false;
    found = {&f, u, d, depth, r > 0 ? d / r : normalized(cross(f.x[1] - f.x[0], f.x[2] - f.x[0]))};
    return true;
  }

  std::vector<Near> within;  ///< triangles within reach of the current particle

  /// Lists the triangles within reach of particle j. Returns the deepest triangle, or null. Of equally deep
  /// triangles, it is the one with the smallest number.
  const Near* findWithin(std::size_t j) {
    within.clear();
    for (const Face& f : faces)
      if (Near n; near(f, w.particles.position[j], n)) within.push_back(n);
    const Near* nearest = nullptr;
    for (const Near& n : within)
      if (!nearest || n.depth > nearest->depth ||
          (n.depth == nearest->depth && n.face->number < nearest->face->number))
        nearest = &n;
    return nearest;
  }

  Vec3d velocityOf(const Near& n) const {
    Vec3d v{};
    for (std::size_t k = 0; k < 3; k++)
      v += n.shares[static_cast<int>(k)] * w.sheets.rows.moving[n.face->row[k]];
    return v;
  }

  /// Returns the friction (N) on the three corners of a face and on particle j. normal: N, contact force.
  std::array<Vec3d, 4> faceFriction(std::size_t j, const Near& at, const TouchLaw& law, double normal) const {
    if (!(law.friction > 0)) return {};
    const Sheets& s = w.sheets.rows;
    const Continuum& p = w.particles;
    std::array<Vec3d, 4> place{}, velocity{};
    std::array<double, 4> mass{}, share{};
    Vec3d v = -p.velocity[j];
    for (std::size_t k = 0; k < 3; k++) {
      const std::uint32_t i = at.face->row[k];
      place[k] = at.face->x[k] - p.position[j];
      velocity[k] = s.moving[i];
      mass[k] = w.sheets.laws[s.law[i]].contactMass * s.area[i];
      share[k] = at.shares[static_cast<int>(k)];
      v += share[k] * velocity[k];
    }
    velocity[3] = p.velocity[j], mass[3] = p.mass[j], share[3] = -1;
    return frictionForces(rigidPointsOf(place, mass), {velocity, share, at.off, at.n, v}, law, normal);
  }

  /// Mean values of the sheet at a particle, over all triangles within reach.
  struct SheetHere {
    double approach = 0;     ///< m/s, separation speed along the gradient of the depth
    double temperature = 0;  ///< K
    double massPerArea = 0;  ///< kg/m^2, contact mass
  };
  SheetHere sheetAt(std::size_t j, const FaceDepth& all) const {
    const Sheets& s = w.sheets.rows;
    const double perPush = all.perPush();
    SheetHere here;
    for (const Near& n : within) {
      const double part = FaceDepth::push(n.depth) * perPush, weight = part * n.depth / all.depth();
      for (std::size_t k = 0; k < 3; k++) {
        const double share = n.shares[static_cast<int>(k)];
        here.massPerArea += weight * share * w.sheets.laws[s.law[n.face->row[k]]].contactMass;
        if (s.temperature.active) here.temperature += weight * share * s.temperature[n.face->row[k]];
      }
      here.approach += part * dot(velocityOf(n) - w.particles.velocity[j], n.n);
    }
    return here;
  }

  double liquidOf(std::size_t j) const {
    const Continuum& p = w.particles;
    return p.liquid.active ? static_cast<double>(p.liquid[j]) : p.phase[j] == Liquid ? 1 : 0;
  }

  /// Law of the contact along the gradient of the depth, without friction.
  TouchLaw lawOf(std::size_t j, double massPerArea) const {
    const Continuum& p = w.particles;
    const double face = plan.faceArea * massPerArea;
    return {plan.faceRate,
            face * p.mass[j] / (face + p.mass[j]),
            std::min(body.restitution, w.scene.materials[p.material[j]].restitution),
            0,
            now.span,
            particleBarrier(plan, p.material[j], p.mass[j]),
            plan.faceReach};
  }

  /// Exchanges heat between particle j and the sheet at this temperature (K). Returns the conductance (W/K).
  double conduct(std::size_t j, double temperature) {
    Continuum& p = w.particles;
    if (!w.sheets.rows.temperature.active || !p.temperature.active || !p.heatFlow.active ||
        !(body.conductance > 0))
      return 0;
    const double flow = body.conductance * w.scene.spacing * w.scene.spacing,
                 capacity = heatCapacityOf(w.scene.numerics.heat, w.scene.materials[p.material[j]],
                                           liquidOf(j));
    // twice the number of particles side by side, for stability
    const double rate = 2 * (body.conductance / body.heatCapacity + flow / (p.mass[j] * capacity));
    const double conductance = flow * (averaged(rate, now.span) / rate);
    const double heat = conductance * (p.temperature[j] - temperature);
    p.heatFlow[j] -= heat;
    w.ledger.heatIn.add(-heat * now.dt);
    return conductance;
  }

  /// Adds the contact of particle j with the sheet. stiffest: 1/s^2, maximum of its value and the contact's
  /// squared rate.
  void touchParticle(std::size_t j, double& stiffest) {
    const Near* nearest = findWithin(j);
    if (!nearest) return;
    Continuum& p = w.particles;
    FaceDepth all;
    for (const Near& n : within) all.add(n.depth, n.n);
    const SheetHere here = sheetAt(j, all);
    TouchLaw law = lawOf(j, here.massPerArea);
    const Touch t = touchOf(law, all.depth() * plan.faceReach, {1, 0, 0}, {here.approach, 0, 0});
    const double perPush = all.perPush(), steep = all.sumDepth7 * perPush, push = t.force.x,
                 dash = t.dissipativeForce.x,
                 slope = t.slope * steep + all.secondDerivative() * push / plan.faceReach;
    law.friction = (1 - liquidOf(j)) * std::max(body.friction, w.scene.materials[p.material[j]].friction);
    const std::array<Vec3d, 4> friction = faceFriction(j, *nearest, law, push);
    const double conductance = conduct(j, here.temperature);
    const Vec3d g = all.slope(), dissipativeForce = friction[3] - dash * g;
    p.force[j] += friction[3] - push * g;
    p.interaction[j] += 0.5 * t.energy;
    // as in sheet_contact.cpp
    p.dissipation[j] -= dot(dissipativeForce, p.velocity[j] + p.acceleration[j] * (0.5 * now.dt));
    stiffest = std::max(stiffest, 2 * slope * steep / p.mass[j]);
    p.sheetFace[j] = nearest->face->number + 1;
    p.sheetNormalForce[j] = {push * perPush, dash * perPush, slope * perPush};
    p.sheetContactData[j] = {t.energy / all.sum, conductance / all.sum,
                             p.temperature.active ? p.temperature[j] : 0};
    p.sheetFriction[j] = {friction[0], friction[1], friction[2]};
  }

  void touchParticles() {
    Continuum& p = w.particles;
    std::fill_n(p.sheetFace.data(), p.owned, 0u);
    double stiffest = 0;
    for (std::size_t c = 0; c < w.cells.key.size(); c++) {
      if (w.cells.first[c] >= p.owned) continue;
      facesNear(w.cells.key[c]);
      if (faces.empty()) continue;
      for (std::uint32_t j = w.cells.first[c]; j < w.cells.first[c] + w.cells.count[c]; j++)
        touchParticle(j, stiffest);
    }
    w.sheets.stiffestParticle = std::max(w.sheets.stiffestParticle, stiffest);
  }

  /// Adds the corners' fractions of the particle's contact. Forces are proportional to the triangles'
  /// parts of the depth gradient, energy and heat to their parts of the depth's eighth power.
  void pushCorners(std::uint32_t j) {
    const Continuum& p = w.particles;
    Sheets& s = w.sheets.rows;
    const Vec3d push = p.sheetNormalForce[j], numbers = p.sheetContactData[j];
    Near n;
    for (const Face& f : faces) {
      if (!near(f, p.position[j], n)) continue;
      const double part = FaceDepth::push(n.depth);
      for (std::size_t k = 0; k < 3; k++) {
        const std::uint32_t i = f.row[k];
        if (i >= s.owned) continue;
        if (f.number + 1 == p.sheetFace[j]) {
          const Vec3d friction = p.sheetFriction[j].row[k] / s.area[i];
          s.load[i] += friction, s.dissipativeForce[i] += friction;
        }
        const double share = part * n.shares[static_cast<int>(k)];
        if (share == 0) continue;
        s.load[i] += n.n * (share * push.x / s.area[i]);
        s.dissipativeForce[i] += n.n * (share * push.y / s.area[i]);
        slope[i] += share * push.z;
        s.energy[i] += 0.5 * share * n.depth * numbers.x;
        // each corner uses its own temperature; fractions of the total heat could heat warm corners above the
        // source's temperature
        if (s.heatFlow.active) s.heatFlow[i] += share * n.depth * numbers.y * (numbers.z - s.temperature[i]);
      }
    }
  }

  void addVertexLoads() {
    const Continuum& p = w.particles;
    for (std::size_t c = 0; c < w.cells.key.size(); c++) {
      bool found = false;
      for (std::uint32_t j = w.cells.first[c]; j < w.cells.first[c] + w.cells.count[c]; j++) {
        if (p.sheetFace[j] == 0) continue;
        if (!found) facesNear(w.cells.key[c]);
        found = true;
        pushCorners(j);
      }
    }
    const Sheets& s = w.sheets.rows;
    for (std::size_t i = 0; i < s.owned; i++) w.sheets.slope[i] += 2 * slope[i] / s.area[i];
  }
};

}  // namespace

bool coarserThanParticles(const Scene& s, const SheetPlan& plan) {
  return !(s.bodies.empty() && s.emitters.empty()) && plan.spacing > coarser * s.spacing;
}

double faceContactReach(const std::vector<SheetPlan>& plans) {
  double reach = 0;
  for (const SheetPlan& p : plans)
    if (p.byFaces) reach = std::max(reach, p.faceReach + stretchedEdges * p.longestEdge);
  return reach;
}

void addFaceContact(const SheetView& w, Halos halos, const SheetVelocities& now) {
  Continuum& p = w.particles;
  for (std::size_t n = 0; n < w.sheets.plans.size(); n++) {
    if (!w.sheets.plans[n].byFaces) continue;
    FaceContact contact(w, now, n);
    contact.touchParticles();
    refresh(halos.cells, p,
            ColumnList{&p.sheetFace, &p.sheetNormalForce, &p.sheetContactData, &p.sheetFriction})
        .wait();
    contact.addVertexLoads();
  }
}

}  // namespace thaw
