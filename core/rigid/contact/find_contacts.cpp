// SPDX-License-Identifier: Apache-2.0
#include "core/rigid/contact/find_contacts.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

#include "core/particles/row_span.hpp"
#include "core/rigid/contact/reduce_contacts.hpp"
#include "core/solid/bonds/weight.hpp"
#include "core/walls/faces.hpp"
#include "core/walls/reachable.hpp"

namespace thaw {
namespace {

constexpr double nearGap = 0.03;    // spacings; smaller gaps are contacts at any velocity
constexpr double faceGap = 0.03;    // spacings; an edge must be this much closer than a face to replace it
constexpr double flatEdge = 0.3;    // spacings; faces with round edges are plane up to here beyond their
                                    // outermost
constexpr double roundEdge = 0.5;   // particles, then have a chamfer up to here, and are round farther out
constexpr double overEdge = 0.02;   // spacings; contacts up to here beyond a sharp edge are still on its face
constexpr double onFace = 0.1;      // spacings, largest distance of a face's edge from the face's plane
constexpr double besideEdge = 1.6;  // spacings; particles at an edge describe their faces up to here
constexpr double flushOverlap = 0.15;  // spacings, largest overlap of aligned edges with a face
constexpr double onePoint = 0.5;       // spacings; closer crossings of edges are the same contact
constexpr double lookAhead = 1.5;      // steps; more than one, because motions change within the step

bool isAsleep(const ContactSearch& s, std::size_t i) {
  return s.pieces.sleeping[s.particles.pieceRow[i]] != 0;
}

bool mayClose(const ContactSearch& s, std::span<const PieceMotion> motion, const RigidContact& c) {
  const double approach = -dot(relativeVelocity(c, motion), c.normal);
  return c.gap < nearGap * s.scene.spacing + lookAhead * s.step * std::max(0.0, approach);
}

/// Surface particle with the data used in comparisons.
struct SurfaceParticle {
  PlacedElement element;
  Vec3d centre;                ///< m, of the sphere
  double size;                 ///< m, largest distance of the surface from the centre; plane: infinite
  std::array<Vec3d, 2> faces;  ///< normals of the faces at an edge
  std::uint64_t piece;
  std::uint32_t row;
  std::uint8_t bend;  ///< result of bend()
  bool sleeping;
};

/// Surface particles of each cell.
struct SurfaceCells {
  std::vector<SurfaceParticle> rows;
  CellTable cells;                       ///< cells with rows; first and count refer to `rows`
  std::vector<std::uint64_t> low, high;  ///< smallest and largest piece of each cell
  std::vector<std::uint8_t> awake;       ///< 1: any piece in the cell is awake
};

/// Returns 2 for edges and corners, 1 for curved surfaces, 0 for planes.
std::uint8_t bend(const PlacedElement& e) { return e.round() ? 2 : e.plane() ? 0 : 1; }

SurfaceParticle surfaceParticle(const ContactSearch& s, std::uint32_t i) {
  const PlacedElement e = placedElement(s.particles, s.pieces, i, s.scene.spacing);
  const double size = e.round() ? extentOf(e, s.scene.spacing) : e.radius;
  const Vec3d centre = e.plane() ? e.position : e.centre();
  return {e, centre, size, facesBeside(e), s.particles.piece[i], i, bend(e), isAsleep(s, i)};
}

SurfaceCells surfaceCells(const ContactSearch& s) {
  SurfaceCells t;
  for (std::size_t c = 0; c < s.cells.key.size(); c++) {
    const auto first = static_cast<std::uint32_t>(t.rows.size());
    std::uint64_t low = ~std::uint64_t{0}, high = 0;
    bool awake = false;
    for (std::uint32_t i = s.cells.first[c]; i < s.cells.first[c] + s.cells.count[c]; i++) {
      if (!hasSurface(s.particles, i)) continue;
      t.rows.push_back(surfaceParticle(s, i));
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

/// Iterates over the cells around each cell, ascending by key. The first cell of each row of three also
/// ascends, so no search is needed.
class CellsAround {
 public:
  explicit CellsAround(const SurfaceCells& t) : t_(t) {}

  /// Lists the rows around cell c. Returns true if all belong to one piece, or all pieces sleep.
  bool nothingToTouch(std::size_t c, std::vector<RowSpan>& ranges) {
    const std::vector<std::uint64_t>& key = t_.cells.key;
    const Vec3i at = cellOfKey(key[c]);
    std::uint64_t low = t_.low[c], high = t_.high[c];
    bool awake = false;
    ranges.clear();
    for (std::size_t n = 0; n < next_.size(); n++) {
      const int y = at.y + static_cast<int>(n) % 3 - 1, z = at.z + static_cast<int>(n) / 3 - 1;
      const std::uint64_t first = cellKey({at.x - 1, y, z}), last = cellKey({at.x + 1, y, z});
      std::size_t& k = next_[n];
      while (k < key.size() && key[k] < first) k++;
      for (std::size_t m = k; m < key.size() && key[m] <= last; m++) {
        ranges.push_back({t_.cells.first[m], t_.cells.first[m] + t_.cells.count[m]});
        low = std::min(low, t_.low[m]);
        high = std::max(high, t_.high[m]);
        awake = awake || t_.awake[m] != 0;
      }
    }
    return low == high || !awake;
  }

 private:
  const SurfaceCells& t_;
  std::array<std::size_t, 9> next_{};  ///< first cell that is not before each row of three
};

struct Search {
  const ContactSearch& in;
  std::span<const PieceMotion> motion;
  Periods periods;
  std::vector<double> rimSpeed;  ///< m/s, for each row: upper bound of the speed of its contacts relative to
                                 ///< its centre
  std::vector<FoundContact> found;
};

/// Returns a contact with the data common to all contacts of a particle.
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

/// Particle that another particle may touch, or a face at its edge.
struct Candidate {
  const SurfaceParticle* particle;
  std::uint8_t bend;  ///< result of bend(); 0: a face
  Vec3d normal;       ///< normal of a face
  std::optional<ElementContact> contact;
  double beyond = 0;      ///< m, distance of the contact point beyond the face of the element
  std::uint32_t bin = 0;  ///< directionBin of the contact normal

  const PlacedElement& element() const { return particle->element; }
};

/// Returns the contact of particle i with j, without material data.
FoundContact startOfPair(const Search& s, std::uint32_t i, std::uint32_t j, const ElementContact& e) {
  const Continuum& p = s.in.particles;
  FoundContact f = startOf(s, i, e);
  RigidContact& c = f.contact;
  c.b = p.pieceRow[j];
  c.armB = minimumImage(e.point - s.motion[c.b].centre, s.periods);
  c.keyB = p.id[j];
  f.partner = p.piece[j];
  f.other = j;
  return f;
}

void addPairContact(Search& s, std::uint32_t i, const Candidate& to) {
  const Continuum& p = s.in.particles;
  const std::uint32_t j = to.particle->row;
  FoundContact f = startOfPair(s, i, j, *to.contact);
  const Material &m = s.in.scene.materials[p.material[i]], &o = s.in.scene.materials[p.material[j]];
  f.contact.friction = std::min(m.friction, o.friction);
  f.contact.restitution = std::min(m.restitution, o.restitution);
  f.contact.rolling = std::max(m.rollingFriction, o.rollingFriction);
  s.found.push_back(f);
}

/// Returns true if the contact of particle i with j may close within the step.
bool pairMayClose(const Search& s, std::uint32_t i, std::uint32_t j, const ElementContact& e) {
  return mayClose(s.in, s.motion, startOfPair(s, i, j, e).contact);
}

/// Returns upper bounds (m/s) of the rotational speed of each piece at points where particles of this rank
/// may touch others.
std::vector<double> rimSpeeds(const ContactSearch& in, std::span<const PieceMotion> motion) {
  const Continuum& p = in.particles;
  const Periods periods = periodsOf(in.grid);
  std::vector<double> square(motion.size(), 0);
  for (std::size_t i = 0; i < p.size(); i++) {
    if (!hasSurface(p, i)) continue;
    const Vec3d arm = minimumImage(p.position[i] - motion[p.pieceRow[i]].centre, periods);
    square[p.pieceRow[i]] = std::max(square[p.pieceRow[i]], dot(arm, arm));
  }
  std::vector<double> speed(motion.size());
  for (std::size_t k = 0; k < speed.size(); k++)
    speed[k] = length(motion[k].spin) * (std::sqrt(square[k]) + 2 * in.grid.support);
  return speed;
}

/// Returns the largest gap (m) at which a contact of two particles may close within the step, for any contact
/// point and normal. Bevels reduce gaps by less than a factor of 1.5, except for small radii.
double gapLimit(const Search& s, const SurfaceParticle& a, const SurfaceParticle& b) {
  constexpr double most = 1.5, smallRadii = 0.8;  // 1, spacings
  const double spacing = s.in.scene.spacing;
  const std::uint32_t ra = s.in.particles.pieceRow[a.row], rb = s.in.particles.pieceRow[b.row];
  const double between = length(s.motion[ra].velocity - s.motion[rb].velocity);
  const double speed = between + s.rimSpeed[ra] + s.rimSpeed[rb];
  const double gap = most * (nearGap * spacing + lookAhead * s.in.step * speed);
  const bool planes = a.bend == 0 && b.bend == 0;
  const bool small = !planes && a.element.radius + b.element.offset < smallRadii * spacing;
  return small ? std::max(gap, spacing) : gap;
}

/// Returns the distance (m) from the centre of a round or curved element to its surface in a direction.
double extentTowards(const SurfaceParticle& a, const Vec3d& direction, double spacing) {
  return a.bend == 2 ? extentTowards(a.element, direction, spacing) : a.size;
}

/// Returns true if a particle may touch a face at the edge of another particle within the step.
bool isNearFaces(const SurfaceParticle& a, const SurfaceParticle& b, double gap, double spacing) {
  const Vec3d to = a.centre - b.element.position;
  return std::any_of(b.faces.begin(), b.faces.end(), [&](const Vec3d& n) {
    return !(n == Vec3d{}) && dot(to, n) - b.element.offset - extentTowards(a, -n, spacing) < gap;
  });
}

/// Returns true if a contact of two particles may close within the step.
bool isNear(const Search& s, const SurfaceParticle& a, const SurfaceParticle& b) {
  const double spacing = s.in.scene.spacing, gap = gapLimit(s, a, b);
  const Vec3d to = a.centre - b.centre;
  if (a.bend == 0 && b.bend == 0) {
    const double reach = std::max(a.element.offset + b.element.offset, spacing) + gap;
    return dot(to, to) < reach * reach + elementReach * spacing * elementReach * spacing;
  }
  if (b.bend == 0) return dot(to, b.element.normal) - b.element.offset - a.size < gap;
  if (b.bend == 2 && isNearFaces(a, b, gap, spacing)) return true;
  const double size = length(to);
  if (!(size > 0)) return true;
  const Vec3d towards = to / size;
  return size - extentTowards(a, -towards, spacing) - extentTowards(b, towards, spacing) < gap;
}

/// Returns the vector (m) along a face to a contact point from the face's nearest outermost particle. The
/// outermost particles are round. The vector is zero well within the face.
Vec3d beyondFace(const Search& s, const Candidate& plane, std::span<const Candidate> candidates) {
  const Vec3d n = plane.contact->normal;
  const auto along = [&](const Vec3d& from) {
    const Vec3d to = plane.contact->point - from;
    return to - dot(to, n) * n;
  };
  const double most = elementReach * s.in.scene.spacing,
               tangentialDistance = plane.contact->tangentialDistance;
  Vec3d beyond = tangentialDistance > most ? (1 - most / tangentialDistance) * along(plane.element().position)
                                           : Vec3d{};
  for (const Candidate& c : candidates) {
    if (c.bend < 2 || c.particle->piece != plane.particle->piece) continue;
    const Vec3d to = along(c.element().position);
    if (dot(to, to) < dot(beyond, beyond)) beyond = to;
  }
  return beyond;
}

/// Position of a contact point relative to the sharp edges of a face.
struct WithinEdges {
  bool sharp = false;        ///< a sharp edge is present, and no round edge is closer
  double inside = HUGE_VAL;  ///< m, distance inside the nearest sharp edge; negative: beyond the edge
  Vec3d outward{};           ///< unit vector along the face to that edge
};

WithinEdges withinEdges(const Search& s, const Candidate& plane, std::span<const Candidate> candidates) {
  const PlacedElement& face = plane.element();
  const double spacing = s.in.scene.spacing;
  double sharp = HUGE_VAL, round = HUGE_VAL;  // m^2, squares of distances along the face
  WithinEdges w;
  for (const Candidate& c : candidates) {
    if (c.bend < 2 || c.particle->piece != plane.particle->piece) continue;
    const PlacedElement& e = c.element();
    const Vec3d edge = e.position + e.edge.to, to = plane.contact->point - edge;
    const Vec3d onIt = to - dot(to, plane.normal) * plane.normal;
    if (!e.sharp()) round = std::min(round, dot(onIt, onIt));
    if (!e.sharp() || std::abs(dot(edge - face.position, plane.normal) - face.offset) > onFace * spacing)
      continue;
    const Vec3d out = e.edge.to - dot(e.edge.to, plane.normal) * plane.normal;
    const double size = length(out);
    if (!(size > onFace * spacing) || !onPart(e.edge, dot(to, e.edge.along), spacing)) continue;
    sharp = std::min(sharp, dot(onIt, onIt));
    const double inside = -dot(onIt, out) / size;
    if (inside < w.inside) w.inside = inside, w.outward = out / size;
  }
  w.sharp = sharp <= round && sharp < HUGE_VAL;
  return w;
}

/// Returns true if an element touches a face within its sharp edges, rather than another face beyond one of
/// the edges.
bool touchesFace(const PlacedElement& a, const WithinEdges& at, double gap, double spacing) {
  if (at.inside < -overEdge * spacing) return false;
  if (!a.sharp()) return true;
  // Aligned edges are flush with an edge of the face, for all overlaps that occur in contacts.
  const double most = dot(a.edge.to, at.outward) < 0 ? faceGap : flushOverlap;
  return -gap < at.inside + most * spacing;
}

/// Ends faces at their edges. Faces with round edges have bevels: beyond flatEdge, the gap grows, up to the
/// gap of two spheres at roundEdge. The normal is the gradient of the gap, so the normal velocity is the
/// rate of change of the gap when a particle slides. Beyond roundEdge, the contact is dropped, because edges
/// touch there.
void endFaces(const Search& s, const PlacedElement& a, std::vector<Candidate>& candidates) {
  const double flat = flatEdge * s.in.scene.spacing;
  for (Candidate& c : candidates) {
    if (c.bend > 0 || !c.contact) continue;
    if (const WithinEdges at = withinEdges(s, c, candidates); at.sharp) {
      if (!touchesFace(a, at, c.contact->gap, s.in.scene.spacing)) c.contact.reset();
      continue;
    }
    if (c.particle->bend == 2) {  // too far along the edge of this face
      c.contact.reset();
      continue;
    }
    const Vec3d beyond = beyondFace(s, c, candidates);
    c.beyond = length(beyond);
    if (!(c.beyond > flat)) continue;
    const double both = a.radius + c.element().offset, height = c.contact->gap + both;
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

/// Returns true if contact o of a particle with a piece replaces contact c.
bool replaces(const Search& s, const PlacedElement& a, const Candidate& o, const Candidate& c) {
  if (!o.contact || &o == &c || o.particle->piece != c.particle->piece) return false;
  const auto id = [&](const Candidate& x) { return s.in.particles.id[x.particle->row]; };
  const double gap = o.contact->gap, other = c.contact->gap, even = faceGap * s.in.scene.spacing;
  const bool nearer = std::tuple(gap, id(o)) < std::tuple(other, id(c));
  const bool edge = a.round() && c.bend == 2;
  if (c.contact->crossing)
    return o.contact->crossing && o.bin == c.bin && nearer &&
           length(o.contact->point - c.contact->point) < onePoint * s.in.scene.spacing;
  if (o.contact->crossing) return edge;
  if (edge != (a.round() && o.bend == 2)) return edge ? gap < other + even : other >= gap + even;
  if (o.bin != c.bin) return false;
  if (o.bend == 0 && c.bend == 0)
    return std::tuple(o.beyond, o.particle->bend, o.contact->tangentialDistance, id(o)) <
           std::tuple(c.beyond, c.particle->bend, c.contact->tangentialDistance, id(c));
  return nearer;
}

/// Returns true if the search from particle a lists the contact with b. The search from the more curved
/// element also finds the faces and edges around the other particle.
bool lists(const SurfaceParticle& a, const SurfaceParticle& b) {
  return a.bend != b.bend ? a.bend > b.bend : a.piece < b.piece;
}

/// Adds the contacts of a particle, one for each piece and direction.
void addPairContacts(Search& s, const SurfaceParticle& a, std::vector<Candidate>& candidates) {
  if (a.bend > 0) endFaces(s, a.element, candidates);
  for (Candidate& c : candidates)
    if (c.contact) c.bin = directionBin(c.contact->normal);
  for (const Candidate& c : candidates)
    if (c.contact && (c.bend < a.bend || lists(a, *c.particle)) &&
        pairMayClose(s, a.row, c.particle->row, *c.contact) &&
        std::none_of(candidates.begin(), candidates.end(),
                     [&](const Candidate& o) { return replaces(s, a.element, o, c); }))
      addPairContact(s, a.row, c);
}

/// Calls use(b) for surface particles b that particle a may touch, until use(b) returns true. Returns true
/// in that case.
template<class Use>
bool anyAround(const Search& s, const SurfaceParticle& a, const SurfaceCells& t,
               std::span<const RowSpan> ranges, Use&& use) {
  const double reach = a.element.offset + 2 * sphereReach * s.in.scene.spacing;
  for (const RowSpan& r : ranges)
    for (std::uint32_t m = r.begin; m < r.end; m++) {
      const SurfaceParticle& b = t.rows[m];
      if (b.piece == a.piece || (a.sleeping && b.sleeping)) continue;
      const Vec3d to = b.element.position - a.element.position;
      const double near = reach + b.element.offset;
      if (dot(to, to) < near * near && use(b)) return true;
    }
  return false;
}

/// Adds the faces at an edge. Near the corners of a face, the face's own particles may be too far away, and
/// narrow faces have none.
void addFacesBeside(const Search& s, const SurfaceParticle& a, const SurfaceParticle& b,
                    std::vector<Candidate>& candidates) {
  const double spacing = s.in.scene.spacing;
  const Vec3d between = a.centre - b.element.position;
  // The limit depends on the partition. This has no effect, since a face dropped here never replaces an
  // edge that may close.
  const double gap = gapLimit(s, a, b) + faceGap * spacing;
  for (const Vec3d& n : b.faces) {
    if (n == Vec3d{} || dot(between, n) - b.element.offset - extentTowards(a, -n, spacing) > gap) continue;
    const PlacedElement face{b.element.position, n, b.element.offset, HUGE_VAL, {}};
    const std::optional<ElementContact> c = contactOf(a.element, face, spacing);
    if (!c) continue;
    const SharpEdge& e = b.element.edge;
    const Vec3d to = c->point - b.element.position - e.to, out = e.to - dot(e.to, n) * n;
    const double inside = -dot(to, out) / length(out);
    if (onPart(e, dot(to, e.along), spacing) && inside > -overEdge * spacing && inside < besideEdge * spacing)
      candidates.push_back({&b, 0, n, c});
  }
}

void findPairsOf(Search& s, const SurfaceParticle& a, const SurfaceCells& t, std::span<const RowSpan> ranges,
                 std::vector<Candidate>& candidates) {
  if (!anyAround(s, a, t, ranges, [&](const SurfaceParticle& b) {
        return (lists(a, b) || (a.bend > 0 && b.bend == 2)) && isNear(s, a, b);
      }))
    return;
  candidates.clear();
  anyAround(s, a, t, ranges, [&](const SurfaceParticle& b) {
    std::optional<ElementContact> contact;
    if (a.bend >= b.bend) contact = contactOf(a.element, b.element, s.in.scene.spacing);
    if (contact || b.bend == 2) candidates.push_back({&b, b.bend, b.element.normal, contact});
    if (a.bend > 0 && b.bend == 2) addFacesBeside(s, a, b, candidates);
    return false;
  });
  addPairContacts(s, a, candidates);
}

/// Finds the contacts between pieces.
void findPairs(Search& s) {
  const SurfaceCells t = surfaceCells(s.in);
  std::vector<RowSpan> ranges;
  std::vector<Candidate> candidates;
  CellsAround around(t);
  for (std::size_t c = 0; c < t.cells.key.size(); c++) {
    if (t.rows[t.cells.first[c]].row >= s.in.particles.owned) continue;
    if (around.nothingToTouch(c, ranges)) continue;
    for (std::uint32_t k = t.cells.first[c]; k < t.cells.first[c] + t.cells.count[c]; k++)
      findPairsOf(s, t.rows[k], t, ranges, candidates);
  }
}

/// rebounds: true if the contact has restitution. On a rolling ball, the rim of an element closes its gap
/// without an impact.
void addWallContact(Search& s, std::uint32_t i, std::uint32_t k, const ElementContact& e, bool rebounds) {
  FoundContact f = startOf(s, i, e);
  RigidContact& c = f.contact;
  const Wall& wall = s.in.walls.list[k];
  const Material& m = s.in.scene.materials[s.in.particles.material[i]];
  c.otherVelocity = wallVelocity(wall, e.point);
  c.friction = std::min(m.friction, wall.properties.friction);
  c.restitution = rebounds ? std::min(m.restitution, wall.properties.restitution) : 0;
  c.rolling = m.rollingFriction;
  if (c.rolling > 0) c.otherSpin = wall.pose.angularVelocity;
  c.keyB = f.partner = obstacleBit | k;
  if (mayClose(s.in, s.motion, c)) s.found.push_back(f);
}

/// Returns the rise (m) of a point of a piece along a normal in the next step, due to the curvature of its
/// path.
double riseOf(const Search& s, std::uint32_t i, const Vec3d& curvatureCentre, const Vec3d& normal) {
  const PieceMotion& m = s.motion[s.in.particles.pieceRow[i]];
  const Vec3d arm = minimumImage(curvatureCentre - m.centre, s.periods);
  return 0.5 * s.in.step * s.in.step * dot(normal, cross(m.spin, cross(m.spin, arm)));
}

void wallContacts(Search& s, std::uint32_t i, std::uint32_t k) {
  const Wall& wall = s.in.walls.list[k];
  const double spacing = s.in.scene.spacing;
  const PlacedElement a = placedElement(s.in.particles, s.in.pieces, i, spacing);
  const double reach = std::min(s.in.grid.support, std::max(a.offset, length(a.edge.to)) + spacing);
  const Vec3d rest = toRest(wall.pose, a.position);
  if (!nearBounds(wall.bounds, rest, reach)) return;
  const Faces faces = facesWithin(*wall.shape, rest, reach, spacing);
  for (std::size_t f = 0; f < faces.count; f++) {
    Vec3d n = directionFromRest(wall.pose, faces.face[f].normal);
    const std::optional<OutermostPoint> outer = outermost(a, -n, spacing);
    if (!outer) continue;
    const Vec3d& point = outer->point;
    double gap = faces.face[f].distance + dot(point - a.position, n);
    if (faces.count == 1) {  // the surface may be curved
      Vec3d gradient;
      gap = wall.shape->distance(toRest(wall.pose, point), &gradient);
      n = directionFromRest(wall.pose, gradient);
    }
    addWallContact(s, i, k, {point - 0.5 * gap * n, n, gap + riseOf(s, i, outer->curvatureCentre, n), 0},
                   !outer->atRim);
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

PlacedElement placedElement(const Continuum& p, const Pieces& pieces, std::size_t i, double spacing) {
  return placedElement({p.faceNormal[i], p.faceOffset[i], p.faceRadius[i]}, p.position[i],
                       pieces.orientation[p.pieceRow[i]], spacing);
}

std::vector<FoundContact> findContacts(const ContactSearch& search, std::span<const PieceMotion> motion,
                                       Reducer& all) {
  Search s{search, motion, periodsOf(search.grid), rimSpeeds(search, motion), {}};
  findPairs(s);
  findObstacles(s);
  reduceContacts(s.found, search.pieces, search.scene.spacing, all);
  guessImpulses(search.particles, s.found);
  return std::move(s.found);
}

void guessImpulses(const Continuum& p, std::span<FoundContact> contacts) {
  constexpr std::size_t none = ~std::size_t{0};
  std::vector<std::size_t> best(p.owned, none);
  const auto order = [&](std::size_t k) {
    const RigidContact& c = contacts[k].contact;
    return std::tuple(-dot(c.normal, p.contactImpulse[contacts[k].particle]), c.keyB, c.gap, c.normal.x,
                      c.normal.y, c.normal.z);
  };
  for (std::size_t k = 0; k < contacts.size(); k++) {
    const std::uint32_t i = contacts[k].particle;
    if (p.contactPartner[i] != contacts[k].partner) continue;
    if (best[i] == none || order(k) < order(best[i])) best[i] = k;
  }
  for (const std::size_t k : best) {
    if (k == none) continue;
    RigidContact& c = contacts[k].contact;
    c.impulse = p.contactImpulse[contacts[k].particle];
    if (p.rollingImpulse.active) c.angularImpulse = p.rollingImpulse[contacts[k].particle];
  }
}

void keepImpulses(std::span<const FoundContact> contacts, const Pieces& pieces, Continuum& p) {
  const auto forget = [&](std::size_t i) {
    p.contactPartner[i] = 0;
    p.contactImpulse[i] = {};
    if (p.rollingImpulse.active) p.rollingImpulse[i] = {};
  };
  for (std::size_t i = 0; i < p.owned; i++)
    if (p.piece[i] == notRigid || !pieces.sleeping[p.pieceRow[i]]) forget(i);
  for (const FoundContact& f : contacts) forget(f.particle);
  for (const FoundContact& f : contacts) {
    const Vec3d &now = f.contact.impulse, &before = p.contactImpulse[f.particle];
    const double size = dot(now, now), other = dot(before, before);
    if (size > other || (size == other && size > 0 && f.partner < p.contactPartner[f.particle])) {
      p.contactPartner[f.particle] = f.partner;
      p.contactImpulse[f.particle] = now;
      if (p.rollingImpulse.active) p.rollingImpulse[f.particle] = f.contact.angularImpulse;
    }
  }
}

}  // namespace thaw
