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

constexpr double coarser = 0.75;  // particle spacings between vertices

/// Triangle near a cell, with rows and positions of its corners.
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
  /// to each other, so the owner of each finds the same.
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

  /// Returns the friction (N) on the three corners of a face and on particle j.
  std::array<Vec3d, 4> faceFriction(std::size_t j, const Face& f, const Vec3d& shares, const Vec3d& off,
                                    const Vec3d& n, const Vec3d& v, const TouchLaw& law,
                                    double normal) const {
    if (!(law.friction > 0)) return {};
    const Sheets& s = w.sheets.rows;
    const Continuum& p = w.particles;
    std::array<Vec3d, 4> place{}, velocity{};
    std::array<double, 4> mass{}, share{};
    for (std::size_t k = 0; k < 3; k++) {
      const std::uint32_t i = f.row[k];
      place[k] = f.x[k] - p.position[j];
      velocity[k] = s.moving[i];
      mass[k] = w.sheets.laws[s.law[i]].contactMass * s.area[i];
      share[k] = shares[static_cast<int>(k)];
    }
    velocity[3] = p.velocity[j], mass[3] = p.mass[j], share[3] = -1;
    return frictionForces(rigidPointsOf(place, mass), velocity, share, off, n, v, law, normal);
  }

  /// Contact geometry of a face and a particle.
  struct Near {
    const Face* face;
    Vec3d shares, off;  ///< barycentric coordinates of the nearest point; m, from the particle to it
    double depth;       ///< fraction of the reach
    Vec3d n;
  };
  bool near(const Face& f, const Vec3d& x, Near& found) const {
    if (x.x < f.low.x || x.y < f.low.y || x.z < f.low.z || x.x > f.high.x || x.y > f.high.y || x.z > f.high.z)
      return false;
    // corners relative to the particle, so the bits are those of differences
    const Vec3d a = f.x[0] - x, b = f.x[1] - x, c = f.x[2] - x, u = sharesOfNearest(a, b, c, {}),
                d = u.x * a + u.y * b + u.z * c;
    const double r = length(d), depth = 1 - r / plan.faceReach;
    if (!(depth > 0)) return false;
    found = {&f, u, d, depth, r > 0 ? d / r : normalized(cross(f.x[1] - f.x[0], f.x[2] - f.x[0]))};
    return true;
  }

  std::vector<Near> within;

  void touchParticle(std::size_t j, double& stiffest) {
    Continuum& p = w.particles;
    const Sheets& s = w.sheets.rows;
    FaceDepth all;
    const Near* nearest = nullptr;
    within.clear();
    for (const Face& f : faces)
      if (Near n; near(f, p.position[j], n)) within.push_back(n);
    for (const Near& n : within) {
      all.add(n.depth, n.n);
      if (!nearest || n.depth > nearest->depth ||
          (n.depth == nearest->depth && n.face->number < nearest->face->number))
        nearest = &n;
    }
    if (!nearest) return;
    const double perPush = all.perPush(), steep = all.pushes * perPush;
    double approach = 0, temperature = 0, massPerArea = 0;
    for (const Near& n : within) {
      const double part = FaceDepth::push(n.depth) * perPush, weight = part * n.depth / all.depth();
      Vec3d v{};
      for (std::size_t k = 0; k < 3; k++) {
        const double share = n.shares[static_cast<int>(k)];
        massPerArea += weight * share * w.sheets.laws[s.law[n.face->row[k]]].contactMass;
        v += share * s.moving[n.face->row[k]];
        if (s.temperature.active) temperature += weight * share * s.temperature[n.face->row[k]];
      }
      approach += part * dot(v - p.velocity[j], n.n);
    }
    const Material& material = w.scene.materials[p.material[j]];
    const double liquid = p.liquid.active        ? static_cast<double>(p.liquid[j])
                          : p.phase[j] == Liquid ? 1
                                                 : 0,
                 face = plan.faceArea * massPerArea, mass = face * p.mass[j] / (face + p.mass[j]);
    TouchLaw law{plan.faceRate,
                 mass,
                 std::min(body.restitution, material.restitution),
                 0,
                 now.span,
                 particleBarrier(plan, p.material[j], p.mass[j]),
                 plan.faceReach};
    const double depth = all.depth() * plan.faceReach;
    const Touch t = touchOf(law, depth, {1, 0, 0}, {approach, 0, 0});  // along the gradient of the depth
    const double push = t.force.x, dash = t.dissipativeForce.x,
                 slope = t.slope * steep + all.bend() * push / plan.faceReach;
    law.friction = (1 - liquid) * std::max(body.friction, material.friction);
    Vec3d v = -p.velocity[j];
    for (std::size_t k = 0; k < 3; k++)
      v += nearest->shares[static_cast<int>(k)] * s.moving[nearest->face->row[k]];
    const std::array<Vec3d, 4> rubs = faceFriction(j, *nearest->face, nearest->shares, nearest->off,
                                                   nearest->n, v, law, push);
    double conducts = 0;  // W/K
    if (s.temperature.active && p.temperature.active && p.heatFlow.active && body.conductance > 0) {
      const double flow = body.conductance * w.scene.spacing * w.scene.spacing;
      // twice the number of particles side by side, for stability
      const double rate = 2 * (body.conductance / body.heatCapacity +
                               flow / (p.mass[j] * heatCapacityOf(w.scene.numerics.heat, material, liquid)));
      conducts = flow * (averaged(rate, now.span) / rate);
      const double heat = conducts * (p.temperature[j] - temperature);
      p.heatFlow[j] -= heat;
      w.ledger.heatIn.add(-heat * now.dt);
    }
    const Vec3d g = all.slope(), dissipativeForce = rubs[3] - dash * g;
    p.force[j] += rubs[3] - push * g;
    p.interaction[j] += 0.5 * t.energy;
    // as in sheet_contact.cpp
    p.dissipation[j] -= dot(dissipativeForce, p.velocity[j] + p.acceleration[j] * (0.5 * now.dt));
    stiffest = std::max(stiffest, 2 * slope * steep / p.mass[j]);
    p.sheetFace[j] = nearest->face->number + 1;
    p.sheetNormalForce[j] = {push * perPush, dash * perPush, slope * perPush};
    p.sheetContactData[j] = {t.energy / all.sum, conducts / all.sum,
                             p.temperature.active ? p.temperature[j] : 0};
    p.sheetFriction[j] = {rubs[0], rubs[1], rubs[2]};
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

  /// Adds the corners' fractions of the particle's contact: forces by the triangles' parts of the depth
  /// gradient, energy and heat by those of its eighth power.
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
          const Vec3d rubs = p.sheetFriction[j].row[k] / s.area[i];
          s.load[i] += rubs, s.dissipativeForce[i] += rubs;
        }
        const double share = part * n.shares[static_cast<int>(k)];
        if (share == 0) continue;
        s.load[i] += n.n * (share * push.x / s.area[i]);
        s.dissipativeForce[i] += n.n * (share * push.y / s.area[i]);
        slope[i] += share * push.z;
        s.energy[i] += 0.5 * share * n.depth * numbers.x;
        // each corner uses its own temperature; fractions of the total heat could heat warm corners above the
        // heat source
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
