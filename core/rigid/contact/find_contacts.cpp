// SPDX-License-Identifier: Apache-2.0
#include "core/rigid/contact/find_contacts.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "core/neighbours/rows_around.hpp"
#include "core/rigid/contact/element_pairs.hpp"
#include "core/rigid/contact/reduce_contacts.hpp"
#include "core/solid/bonds/weight.hpp"
#include "core/walls/faces.hpp"
#include "core/walls/reachable.hpp"

namespace thaw {
namespace {

constexpr double nearGap = 0.03;   // spacings; smaller gaps are contacts at any velocity
constexpr double faceGap = 0.03;   // spacings; faces count before edges that are not this much closer
constexpr double flatEdge = 0.3;   // spacings; faces are plane so far beyond their outermost particles, have
constexpr double roundEdge = 0.5;  // a chamfer up to here, and are round further out, as their edges are
constexpr double lookAhead = 1.5;  // steps; motions change within the step

bool hasSurface(const Continuum& p, std::size_t i) { return p.piece[i] != notRigid && p.faceOffset[i] > 0; }

PlacedElement placed(const ContactSearch& s, std::size_t i) {
  const Continuum& p = s.particles;
  return {p.position[i], rotated(s.pieces.orientation[p.pieceRow[i]], wide(p.faceNormal[i])),
          static_cast<double>(p.faceOffset[i]), static_cast<double>(p.faceRadius[i])};
}

bool isAsleep(const ContactSearch& s, std::size_t i) { return s.pieces.asleep[s.particles.pieceRow[i]] != 0; }

bool mayClose(const ContactSearch& s, std::span<const PieceMotion> motion, const RigidContact& c) {
  const Vec3d other = c.b == noPiece ? c.otherVelocity : velocityAtArm(motion[c.b], c.armB);
  const double approach = -dot(velocityAtArm(motion[c.a], c.armA) - other, c.normal);
  return c.gap < nearGap * s.scene.spacing + lookAhead * s.step * std::max(0.0, approach);
}

/// Surface particles of each cell.
struct SurfaceCells {
  std::vector<std::uint32_t> rows;
  CellTable cells;                       ///< cells with rows; first and count refer to `rows`
  std::vector<std::uint64_t> low, high;  ///< smallest and largest piece of each cell
  std::vector<std::uint8_t> awake;       ///< 1: a piece in the cell is awake
};

SurfaceCells surfaceCells(const ContactSearch& s) {
  SurfaceCells t;
  for (std::size_t c = 0; c < s.cells.key.size(); c++) {
    const auto first = static_cast<std::uint32_t>(t.rows.size());
    std::uint64_t low = ~std::uint64_t{0}, high = 0;
    bool awake = false;
    for (std::uint32_t i = s.cells.first[c]; i < s.cells.first[c] + s.cells.count[c]; i++) {
      if (!hasSurface(s.particles, i)) continue;
      t.rows.push_back(i);
      low = std::min(low, s.particles.piece[i]);
      high = std::max(high, s.particles.piece[i]);
      awake = awake || !isAsleep(s, i);
    }
    if (t.rows.size() == first) continue;
    t.cells.key.push_back(s.cells.key[c]);
    t.cells.first.push_back(first);
    t.cells.count.push_back(static_cast<std::uint32_t>(t.rows.size()) - first);
    t.low.push_back(low);
    t.high.push_back(high);
    t.awake.push_back(awake);
  }
  return t;
}

/// Lists the rows around a cell; returns true if they all belong to one piece, or to sleeping ones.
bool nothingToTouch(const SurfaceCells& t, std::size_t c, std::vector<RowSpan>& ranges) {
  rowsAround(t.cells, t.cells.key[c], ranges);
  std::uint64_t low = t.low[c], high = t.high[c];
  bool awake = t.awake[c] != 0;
  for (const RowSpan& r : ranges) {
    const auto at = std::lower_bound(t.cells.first.begin(), t.cells.first.end(), r.begin) -
                    t.cells.first.begin();
    low = std::min(low, t.low[static_cast<std::size_t>(at)]);
    high = std::max(high, t.high[static_cast<std::size_t>(at)]);
    awake = awake || t.awake[static_cast<std::size_t>(at)] != 0;
  }
  return low == high || !awake;
}

struct Search {
  const ContactSearch& in;
  std::span<const PieceMotion> motion;
  Periods periods;
  std::vector<FoundContact> found;
};

/// Returns the common part of all contacts of a particle.
FoundContact startOf(const Search& s, std::uint32_t i, const ElementContact& e) {
  const Continuum& p = s.in.particles;
  FoundContact f;
  RigidContact& c = f.contact;
  c.a = p.pieceRow[i];
  c.normal = e.normal;
  c.gap = e.gap;
  c.armA = minimumImage(e.point - s.motion[c.a].centre, s.periods);
  c.keyA = p.id[i];
  f.pieceA = p.piece[i];
  f.particle = i;
  return f;
}

/// A particle that another one may touch.
struct Candidate {
  std::uint32_t row;
  PlacedElement element;
  std::optional<ElementContact> contact;
  double beyond = 0;  ///< m, distance of the point of contact from the face that the element belongs to
};

void addPairContact(Search& s, std::uint32_t i, const Candidate& to) {
  const Continuum& p = s.in.particles;
  FoundContact f = startOf(s, i, *to.contact);
  RigidContact& c = f.contact;
  const Material &m = s.in.scene.materials[p.material[i]], &o = s.in.scene.materials[p.material[to.row]];
  c.b = p.pieceRow[to.row];
  c.armB = minimumImage(to.contact->point - s.motion[c.b].centre, s.periods);
  c.friction = std::min(m.friction, o.friction);
  c.restitution = std::min(m.restitution, o.restitution);
  c.keyB = p.id[to.row];
  f.partner = p.piece[to.row];
  f.other = to.row;
  if (mayClose(s.in, s.motion, c)) s.found.push_back(f);
}

/// Vector (m) along a face to a point of contact from the nearest of its outermost particles, which are
/// round; zero well within the face.
Vec3d beyondFace(const Search& s, const Candidate& plane, std::span<const Candidate> candidates) {
  const Continuum& p = s.in.particles;
  const Vec3d n = plane.contact->normal;
  const auto along = [&](const Vec3d& from) {
    const Vec3d to = plane.contact->point - from;
    return to - dot(to, n) * n;
  };
  const double most = elementReach * s.in.scene.spacing, aside = plane.contact->aside;
  Vec3d beyond = aside > most ? (1 - most / aside) * along(plane.element.position) : Vec3d{};
  for (const Candidate& c : candidates) {
    if (!c.element.round() || p.piece[c.row] != p.piece[plane.row]) continue;
    const Vec3d to = along(c.element.position);
    if (dot(to, to) < dot(beyond, beyond)) beyond = to;
  }
  return beyond;
}

/// Bevels the edges of a face. From flatEdge on, the gap of a particle beyond the face grows, up to that of
/// two spheres at roundEdge. The normal is the gradient of the gap, so that sliding changes no overlap that
/// the normal velocity does not show. From roundEdge on, drops the contact: edges touch there instead.
void bevelEdges(const Search& s, const PlacedElement& a, std::vector<Candidate>& candidates) {
  const double flat = flatEdge * s.in.scene.spacing;
  for (Candidate& c : candidates) {
    if (!c.element.plane() || !c.contact) continue;
    const Vec3d beyond = beyondFace(s, c, candidates);
    c.beyond = length(beyond);
    if (!(c.beyond > flat)) continue;
    const double both = a.radius + c.element.offset, height = c.contact->gap + both;
    const double round = std::min(roundEdge * s.in.scene.spacing, both);
    if (c.beyond > round || height < 0.5 * both) {
      c.contact.reset();
      continue;
    }
    const double slope = (both - std::sqrt(both * both - round * round)) / (round - flat);
    const Vec3d gradient = c.contact->normal + (slope / c.beyond) * beyond;
    c.contact->gap = (c.contact->gap + slope * (c.beyond - flat)) / length(gradient);
    c.contact->normal = normalized(gradient);
  }
}

/// Returns true if a particle touches the piece at o rather than at c.
bool replaces(const Search& s, const PlacedElement& a, const Candidate& o, const Candidate& c) {
  const Continuum& p = s.in.particles;
  if (&o == &c || !o.contact || p.piece[o.row] != p.piece[c.row]) return false;
  const double gap = o.contact->gap, other = c.contact->gap, even = faceGap * s.in.scene.spacing;
  const bool edge = a.round() && c.element.round();
  if (edge != (a.round() && o.element.round())) return edge ? gap < other + even : other >= gap + even;
  if (directionBin(o.contact->normal) != directionBin(c.contact->normal)) return false;
  if (o.element.plane() && c.element.plane())
    return std::tuple(o.beyond, o.contact->aside, p.id[o.row]) <
           std::tuple(c.beyond, c.contact->aside, p.id[c.row]);
  return std::tuple(gap, p.id[o.row]) < std::tuple(other, p.id[c.row]);
}

/// 2: edges and corners, 1: curved surfaces, 0: planes.
int bend(const PlacedElement& e) { return e.round() ? 2 : e.plane() ? 0 : 1; }

/// Returns true if the search from particle i lists its contact with j. The search from the more curved
/// element finds the faces and edges around the other one.
bool lists(const PlacedElement& a, const PlacedElement& b, bool smaller) {
  return bend(a) != bend(b) ? bend(a) > bend(b) : smaller;
}

/// Adds the contacts of a particle, one for each piece and direction.
void addPairContacts(Search& s, std::uint32_t i, const PlacedElement& a, std::vector<Candidate>& candidates) {
  const Continuum& p = s.in.particles;
  if (!a.plane()) bevelEdges(s, a, candidates);
  for (const Candidate& c : candidates)
    if (c.contact && lists(a, c.element, p.piece[i] < p.piece[c.row]) &&
        std::none_of(candidates.begin(), candidates.end(),
                     [&](const Candidate& o) { return replaces(s, a, o, c); }))
      addPairContact(s, i, c);
}

void findPairsOf(Search& s, std::uint32_t i, const SurfaceCells& t, std::span<const RowSpan> ranges,
                 std::vector<Candidate>& candidates) {
  const Continuum& p = s.in.particles;
  const PlacedElement a = placed(s.in, i);
  const double spacing = s.in.scene.spacing;
  const bool sleeps = isAsleep(s.in, i);
  candidates.clear();
  bool any = false;
  for (const RowSpan& r : ranges)
    for (std::uint32_t m = r.begin; m < r.end; m++) {
      const std::uint32_t j = t.rows[m];
      if (p.piece[j] == p.piece[i] || (sleeps && isAsleep(s.in, j))) continue;
      const Vec3d to = p.position[j] - a.position;
      const double near = a.offset + static_cast<double>(p.faceOffset[j]) + 2 * sphereReach * spacing;
      if (!(dot(to, to) < near * near)) continue;
      Candidate c{j, placed(s.in, j), {}};
      if (bend(a) >= bend(c.element)) c.contact = contactOf(a, c.element, spacing);
      any = any || c.contact;
      if (c.contact || c.element.round()) candidates.push_back(c);
    }
  if (any) addPairContacts(s, i, a, candidates);
}

/// Contacts of pieces.
void findPairs(Search& s) {
  const SurfaceCells t = surfaceCells(s.in);
  std::vector<RowSpan> ranges;
  std::vector<Candidate> candidates;
  for (std::size_t c = 0; c < t.cells.key.size(); c++) {
    if (t.rows[t.cells.first[c]] >= s.in.particles.owned) continue;
    if (nothingToTouch(t, c, ranges)) continue;
    for (std::uint32_t k = t.cells.first[c]; k < t.cells.first[c] + t.cells.count[c]; k++)
      findPairsOf(s, t.rows[k], t, ranges, candidates);
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
    addWallContact(s, i, k, {*point - 0.5 * gap * n, n, gap, 0});
  }
}

bool moves(const Wall& wall, const Vec3d& at) {
  return !wall.properties.motion.empty() && !(wallVelocity(wall, at) == Vec3d{});
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
      if (!listed) findReachable(s.in.grid, s.in.walls, s.in.cells.key[c], walls);
      listed = true;
      const bool sleeps = isAsleep(s.in, i);
      for (const std::uint32_t k : walls)
        if (!sleeps || moves(s.in.walls.list[k], p.position[i])) wallContacts(s, i, k);
    }
  }
}

}  // namespace

std::vector<FoundContact> findContacts(const ContactSearch& search, std::span<const PieceMotion> motion,
                                       Reducer& all) {
  Search s{search, motion, periodsOf(search.grid), {}};
  findPairs(s);
  findObstacles(s);
  reduceContacts(s.found, search.pieces, search.scene.spacing, all);
  const Continuum& p = search.particles;
  for (FoundContact& f : s.found)
    if (p.contactPartner[f.particle] == f.partner) f.contact.impulse = p.contactImpulse[f.particle];
  return std::move(s.found);
}

void keepImpulses(std::span<const FoundContact> contacts, const Pieces& pieces, Continuum& p) {
  const auto forget = [&](std::size_t i) {
    p.contactPartner[i] = 0;
    p.contactImpulse[i] = {};
  };
  for (std::size_t i = 0; i < p.owned; i++)
    if (p.piece[i] == notRigid || !pieces.asleep[p.pieceRow[i]]) forget(i);
  for (const FoundContact& f : contacts) forget(f.particle);
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
