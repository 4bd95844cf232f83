// SPDX-License-Identifier: Apache-2.0
#include "core/rigid/contact/find_contacts.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "core/neighbours/rows_around.hpp"
#include "core/rigid/contact/element_pairs.hpp"
#include "core/rigid/contact/reduce_contacts.hpp"
#include "core/walls/faces.hpp"

namespace thaw {
namespace {

constexpr double nearGap = 0.03;   // spacings; smaller gaps are contacts at any velocity
constexpr double lookAhead = 1.5;  // steps; motions change within the step

bool hasSurface(const Continuum& p, std::size_t i) { return p.piece[i] != notRigid && p.faceOffset[i] > 0; }

PlacedElement placed(const ContactSearch& s, std::size_t i) {
  const Continuum& p = s.particles;
  return {p.position[i], rotated(s.pieces.orientation[p.pieceRow[i]], wide(p.faceNormal[i])),
          static_cast<double>(p.faceOffset[i]), static_cast<double>(p.faceRadius[i])};
}

/// Vector between two points, the shortest one over periodic sides.
Vec3d shortest(const CellGrid& g, Vec3d d) {
  for (int a = 0; a < 3; a++)
    if (g.periodic[a]) d[a] -= g.period[a] * std::round(d[a] / g.period[a]);
  return d;
}

bool mayClose(const ContactSearch& s, std::span<const PieceMotion> motion, const RigidContact& c) {
  const Vec3d other = c.b == noPiece ? c.otherVelocity : velocityAtArm(motion[c.b], c.armB);
  const double approach = -dot(velocityAtArm(motion[c.a], c.armA) - other, c.normal);
  return c.gap < nearGap * s.scene.spacing + lookAhead * s.step * std::max(0.0, approach);
}

/// Surface particles of each cell, and whether they all belong to one piece.
struct SurfaceCells {
  std::vector<std::uint32_t> rows;
  CellTable cells;                       ///< those with rows; first and count refer to `rows`
  std::vector<std::uint64_t> onlyPiece;  ///< notRigid: several
};

SurfaceCells surfaceCells(const ContactSearch& s) {
  SurfaceCells t;
  for (std::size_t c = 0; c < s.cells.key.size(); c++) {
    const auto first = static_cast<std::uint32_t>(t.rows.size());
    for (std::uint32_t i = s.cells.first[c]; i < s.cells.first[c] + s.cells.count[c]; i++)
      if (hasSurface(s.particles, i)) t.rows.push_back(i);
    if (t.rows.size() == first) continue;
    t.cells.key.push_back(s.cells.key[c]);
    t.cells.first.push_back(first);
    t.cells.count.push_back(static_cast<std::uint32_t>(t.rows.size()) - first);
    const auto pieceOf = [&](std::size_t k) { return s.particles.piece[t.rows[k]]; };
    bool one = true;
    for (std::size_t k = first; k < t.rows.size(); k++) one = one && pieceOf(k) == pieceOf(first);
    t.onlyPiece.push_back(one ? pieceOf(first) : notRigid);
  }
  return t;
}

struct Search {
  const ContactSearch& in;
  std::span<const PieceMotion> motion;
  std::vector<FoundContact> found;
  std::vector<ElementContact> elements;  ///< of found contacts of the current particle
};

/// Fills in rows, arms and coefficients that all contacts of a particle share.
FoundContact startOf(const Search& s, std::uint32_t i, const ElementContact& e) {
  const Continuum& p = s.in.particles;
  FoundContact f;
  RigidContact& c = f.contact;
  c.a = p.pieceRow[i];
  c.normal = e.normal;
  c.gap = e.gap;
  c.armA = shortest(s.in.grid, e.point - s.motion[c.a].centre);
  c.keyA = p.id[i];
  f.pieceA = p.piece[i];
  f.particle = i;
  f.direction = directionBin(e.normal);
  return f;
}

/// Adds a contact unless the particle has one with the same partner and direction that is more opposite.
void addPair(Search& s, std::size_t first, const FoundContact& f, const ElementContact& e) {
  for (std::size_t k = first; k < s.found.size(); k++) {
    FoundContact& o = s.found[k];
    if (o.partner != f.partner || o.direction != f.direction) continue;
    ElementContact& best = s.elements[k - first];
    if (std::tuple(e.round, e.aside, f.contact.keyB) < std::tuple(best.round, best.aside, o.contact.keyB)) {
      best = e;
      o = f;
    }
    return;
  }
  s.found.push_back(f);
  s.elements.push_back(e);
}

/// Removes contacts of two edges where the particle also touches a face of the same piece.
void removeEdges(Search& s, std::size_t first) {
  const auto hasFace = [&](std::uint64_t partner) {
    for (std::size_t k = first; k < s.found.size(); k++)
      if (s.found[k].partner == partner && !s.elements[k - first].round) return true;
    return false;
  };
  std::vector<FoundContact> kept;
  for (std::size_t k = first; k < s.found.size(); k++)
    if (!s.elements[k - first].round || !hasFace(s.found[k].partner)) kept.push_back(s.found[k]);
  s.found.resize(first);
  s.found.insert(s.found.end(), kept.begin(), kept.end());
}

void pairContact(Search& s, std::uint32_t i, std::uint32_t j, const PlacedElement& a, std::size_t first) {
  const Continuum& p = s.in.particles;
  const PlacedElement b = placed(s.in, j);
  const std::optional<ElementContact> e = contactOf(a, b, s.in.scene.spacing);
  if (!e) return;
  FoundContact f = startOf(s, i, *e);
  RigidContact& c = f.contact;
  const Material &m = s.in.scene.materials[p.material[i]], &o = s.in.scene.materials[p.material[j]];
  c.b = p.pieceRow[j];
  c.armB = shortest(s.in.grid, e->point - s.motion[c.b].centre);
  c.friction = std::min(m.friction, o.friction);
  c.restitution = std::min(m.restitution, o.restitution);
  c.keyB = p.id[j];
  f.partner = p.piece[j];
  if (mayClose(s.in, s.motion, c)) addPair(s, first, f, *e);
}

/// Contacts of pieces: on the rank of the particle whose piece has the smaller id.
void findPairs(Search& s) {
  const SurfaceCells t = surfaceCells(s.in);
  const Continuum& p = s.in.particles;
  std::vector<RowSpan> ranges;
  for (std::size_t c = 0; c < t.cells.key.size(); c++) {
    if (t.rows[t.cells.first[c]] >= p.owned) continue;
    rowsAround(t.cells, t.cells.key[c], ranges);
    for (std::uint32_t k = t.cells.first[c]; k < t.cells.first[c] + t.cells.count[c]; k++) {
      const std::uint32_t i = t.rows[k];
      const PlacedElement a = placed(s.in, i);
      const std::size_t first = s.found.size();
      s.elements.clear();
      for (const RowSpan& r : ranges)
        for (std::uint32_t m = r.begin; m < r.end; m++) {
          const std::uint32_t j = t.rows[m];
          if (p.piece[j] <= p.piece[i]) continue;
          const Vec3d to = p.position[j] - a.position;
          const double near = a.offset + static_cast<double>(p.faceOffset[j]) +
                              planeReach * s.in.scene.spacing;
          if (dot(to, to) < near * near) pairContact(s, i, j, a, first);
        }
      if (s.found.size() > first + 1) removeEdges(s, first);
    }
  }
}

/// Walls near the surface particles of a cell.
void findReachable(const ContactSearch& s, std::uint64_t key, std::vector<std::uint32_t>& walls) {
  const CellGrid& g = s.grid;
  const Vec3i c = cellOfKey(key);
  Vec3d centre;
  bool border = false;
  for (int a = 0; a < 3; a++) {
    border = border || (!g.periodic[a] && (c[a] <= 0 || c[a] >= g.cells[a] - 1));
    centre[a] = g.origin[a] + (c[a] + 0.5) * g.edge[a];
  }
  const double reach = g.support + 0.51 * length(g.edge);
  walls.clear();
  for (std::size_t k = 0; k < s.walls.list.size(); k++) {
    const Wall& wall = s.walls.list[k];
    if (!wall.present) continue;
    if (!border) {
      const Vec3d rest = toRest(wall.pose, centre);
      if (!nearBounds(wall.bounds, rest, reach) || wall.shape->distanceWithin(rest, 1.01 * reach) > reach)
        continue;
    }
    walls.push_back(static_cast<std::uint32_t>(k));
  }
}

void addWallContact(Search& s, std::uint32_t i, std::uint32_t k, const ElementContact& e) {
  FoundContact f = startOf(s, i, e);
  RigidContact& c = f.contact;
  const Wall& wall = s.in.walls.list[k];
  const Material& m = s.in.scene.materials[s.in.particles.material[i]];
  c.otherVelocity = wallVelocity(wall, e.point);
  c.friction = std::min(m.friction, wall.properties.friction);
  c.restitution = std::min(m.restitution, wall.properties.restitution);
  c.keyB = f.partner = obstacleBit | k;
  if (mayClose(s.in, s.motion, c)) s.found.push_back(f);
}

void wallContacts(Search& s, std::uint32_t i, std::uint32_t k) {
  const Wall& wall = s.in.walls.list[k];
  const double spacing = s.in.scene.spacing;
  const PlacedElement a = placed(s.in, i);
  const double reach = std::min(s.in.grid.support, a.offset + spacing);
  const Vec3d rest = toRest(wall.pose, a.position);
  if (!nearBounds(wall.bounds, rest, reach)) return;
  const Faces faces = facesWithin(*wall.shape, rest, reach, spacing);
  for (std::size_t f = 0; f < faces.count; f++) {
    Vec3d n = directionFromRest(wall.pose, faces.face[f].normal);
    const std::optional<Vec3d> point = outermost(a, -n, spacing);
    if (!point) continue;
    double gap = faces.face[f].distance + dot(*point - a.position, n);
    if (faces.count == 1) {  // the surface may be curved
      Vec3d gradient;
      gap = wall.shape->distance(toRest(wall.pose, *point), &gradient);
      n = directionFromRest(wall.pose, gradient);
    }
    addWallContact(s, i, k, {*point - 0.5 * gap * n, n, gap, 0, false});
  }
}

void findObstacles(Search& s) {
  std::vector<std::uint32_t> walls;
  const Continuum& p = s.in.particles;
  for (std::size_t c = 0; c < s.in.cells.key.size(); c++) {
    const std::uint32_t begin = s.in.cells.first[c], end = begin + s.in.cells.count[c];
    if (begin >= p.owned) continue;
    bool listed = false;
    for (std::uint32_t i = begin; i < end; i++) {
      if (!hasSurface(p, i)) continue;
      if (!listed) findReachable(s.in, s.in.cells.key[c], walls);
      listed = true;
      for (const std::uint32_t k : walls) wallContacts(s, i, k);
    }
  }
}

}  // namespace

std::vector<FoundContact> findContacts(const ContactSearch& search, std::span<const PieceMotion> motion,
                                       Reducer& all) {
  Search s{search, motion, {}, {}};
  findPairs(s);
  findObstacles(s);
  reduceContacts(s.found, search.pieces, all);
  const Continuum& p = search.particles;
  for (FoundContact& f : s.found)
    if (p.contactPartner[f.particle] == f.partner) f.contact.impulse = p.contactImpulse[f.particle];
  return std::move(s.found);
}

void keepImpulses(std::span<const FoundContact> contacts, Continuum& p) {
  for (std::size_t i = 0; i < p.owned; i++) {
    p.contactPartner[i] = 0;
    p.contactImpulse[i] = {};
  }
  for (const FoundContact& f : contacts) {
    const Vec3d &now = f.contact.impulse, &before = p.contactImpulse[f.particle];
    const double size = dot(now, now), other = dot(before, before);
    if (size > other || (size == other && size > 0 && f.partner < p.contactPartner[f.particle])) {
      p.contactPartner[f.particle] = f.partner;
      p.contactImpulse[f.particle] = now;
    }
  }
}

}  // namespace thaw
