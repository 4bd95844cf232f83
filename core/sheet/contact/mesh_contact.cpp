// SPDX-License-Identifier: Apache-2.0
#include "core/sheet/contact/mesh_contact.hpp"

#include <array>
#include <cmath>

#include "core/sheet/contact/friction.hpp"
#include "core/sheet/data/touching_sheets.hpp"
#include "core/sheet/search/mesh_pairs.hpp"

namespace thaw {
namespace {

// In stacked layers, a vertex is within reach of several triangles, and an edge of even more edges. The
// number of these pairs grows with the reach. Together, they should be about as stiff as one contact. If the
// reach is shorter than the edges, there are few pairs, and each must bear the load alone.
constexpr double moreTriangles = 5, moreEdges = 16;  // number of extra pairs for a reach of one mean edge
                                                     // length
// Pairs come into reach within a step. The bound of stiffness is scaled by this factor, which halves the
// energy error of contact.
constexpr double ahead = 2;
constexpr double deepest = 0.1;  // fraction of the reach; closer pairs do not shorten the step further

struct MeshContact {
  SheetBodies& sheets;
  const Scene& scene;
  const SheetVelocities& now;
  Sheets& s;
  std::vector<double>& slope;  // N/m, of owned vertices

  double massOf(std::uint32_t i) const { return sheets.laws[s.law[i]].contactMass * s.area[i]; }

  /// Returns the law between bodies of these masses (kg). more: number of extra pairs for a reach of one mean
  /// edge length.
  TouchLaw lawOf(const MeshPair& p, double first, double second, double more) const {
    const std::size_t a = s.body[p.row[0]], b = s.body[p.row[3]];
    const SheetBody &x = scene.sheets[a], &y = scene.sheets[b];
    const double far = p.reach / std::max(sheets.plans[a].spacing, sheets.plans[b].spacing),
                 part = 1 / (1 + more * far * far);
    return {std::max(sheets.plans[a].contactRate, sheets.plans[b].contactRate),
            part * first * second / (first + second), std::min(x.restitution, y.restitution),
            std::max(x.friction, y.friction), now.span};
  }

  Vec3d relativeVelocity(const MeshPair& p) const {
    Vec3d v{};
    for (std::size_t k = 0; k < 4; k++) v += p.share[k] * s.moving[p.row[k]];
    return v;
  }

  /// Adds friction of a pair to its vertices.
  void pairFriction(const MeshPair& p, const TouchLaw& law, double normal, const Vec3d& n, const Vec3d& v) {
    if (!(law.friction > 0)) return;
    std::array<Vec3d, 4> place, velocity;
    std::array<double, 4> mass;
    for (std::size_t k = 0; k < 4; k++) {
      place[k] = s.position[p.row[k]] - s.position[p.row[0]];
      velocity[k] = s.moving[p.row[k]];
      mass[k] = massOf(p.row[k]);
    }
    const std::array<Vec3d, 4> forces = frictionForces(rigidPointsOf(place, mass),
                                                       {velocity, p.share, p.apart, n, v}, law, normal);
    for (std::size_t k = 0; k < 4; k++) {
      const std::uint32_t i = p.row[k];
      if (i >= s.owned) continue;
      const Vec3d load = forces[k] / s.area[i];
      s.load[i] += load;
      s.dissipativeForce[i] += load;
    }
  }

  /// Adds force, energy, dissipation and slope of a touching pair to its vertices by weight.
  Touch touch(const MeshPair& p, const TouchLaw& law) {
    const Vec3d n = p.apart / p.distance, v = relativeVelocity(p);
    TouchLaw smooth = law;
    smooth.friction = 0;
    const Touch t = touchOf(smooth, p.reach - p.distance, n, v);
    pairFriction(p, law, dot(t.force, n), n, v);
    sheets.closingRate = std::max(sheets.closingRate, -dot(v, n) / std::max(p.distance, deepest * p.reach));
    sheets.impactRate = std::max(sheets.impactRate, blowRate(law.rate, p.reach, std::abs(dot(v, n))));
    for (std::size_t k = 0; k < 4; k++) {
      const std::uint32_t i = p.row[k];
      if (i >= s.owned) continue;
      s.load[i] += (p.share[k] / s.area[i]) * t.force;
      s.dissipativeForce[i] += (p.share[k] / s.area[i]) * t.dissipativeForce;
      s.energy[i] += 0.5 * std::abs(p.share[k]) * t.energy;
      slope[i] += std::abs(p.share[k]) * t.slope;
    }
    return t;
  }

  void vertexAndTriangle(const MeshPair& p) {
    const double face = (massOf(p.row[1]) + massOf(p.row[2]) + massOf(p.row[3])) / 3;
    touch(p, lawOf(p, massOf(p.row[0]), face, moreTriangles));
  }

  void edgeAndEdge(const MeshPair& p) {
    const Vec3d a = s.position[p.row[1]] - s.position[p.row[0]],
                b = s.position[p.row[3]] - s.position[p.row[2]];
    const double la = length(a), lb = length(b);
    if (!(la > 0) || !(lb > 0)) return;
    const double cosine = dot(a, b) / (la * lb), crossed = 1 - cosine * cosine;
    if (!(crossed > 0)) return;
    TouchLaw law = lawOf(p, 0.5 * (massOf(p.row[0]) + massOf(p.row[1])),
                         0.5 * (massOf(p.row[2]) + massOf(p.row[3])), moreEdges);
    law.mass *= crossed;
    const Touch t = touch(p, law);
    // the energy depends on sin^2, so a torque turns the edges parallel
    const double whole = t.energy / crossed, depth = p.reach - p.distance, least = std::min(la, lb);
    const Vec3d ofA = (2 * whole * cosine / la) * (b / lb - cosine * (a / la)),
                ofB = (2 * whole * cosine / lb) * (a / la - cosine * (b / lb));
    const std::array<Vec3d, 4> turn{-ofA, ofA, -ofB, ofB};
    const double more = 2 * whole / depth / least * 3 + 2 * whole / (least * least) * 4;
    for (std::size_t k = 0; k < 4; k++) {
      const std::uint32_t i = p.row[k];
      if (i >= s.owned) continue;
      s.load[i] += turn[k] / s.area[i];
      slope[i] += more;
    }
  }
};

}  // namespace

double meshContactReach(const Scene& s, const std::vector<SheetPlan>& plans) {
  double reach = 0;
  for (std::size_t n = 0; n < plans.size(); n++)
    if (meshTouches(s, n))
      reach = std::max(reach, plans[n].thickness + 2 * stretchedEdges * plans[n].longestEdge);
  return reach;
}

void addMeshContact(SheetBodies& sheets, const Scene& scene, const SheetVelocities& now) {
  Sheets& s = sheets.rows;
  Vec3d mean{};
  for (std::size_t i = 0; i < s.owned; i++) mean += s.moving[i];
  MeshSearch& pairs = *sheets.search;
  findMeshPairs(sheets, scene,
                {mean / static_cast<double>(std::max<std::size_t>(1, s.owned)), now.dt,
                 std::isfinite(now.span) ? contactLookAhead * now.span : 0},
                pairs);
  if (pairs.coming > 0) sheets.impactRate = std::max(sheets.impactRate, blowRate(1, 1, pairs.coming));
  std::vector<double> slope(s.owned, 0);
  MeshContact contact{sheets, scene, now, s, slope};
  for (const MeshPair& p : pairs.faces) contact.vertexAndTriangle(p);
  for (const MeshPair& p : pairs.edges) contact.edgeAndEdge(p);
  for (std::size_t i = 0; i < s.owned; i++) sheets.slope[i] += 2 * ahead * slope[i] / s.area[i];
}

}  // namespace thaw
