// SPDX-License-Identifier: Apache-2.0
#include "core/rigid/contact/element_pairs.hpp"

#include <algorithm>
#include <cmath>

#include "core/rigid/contact/edge_code.hpp"

namespace thaw {
namespace {

constexpr double facing = 0.7;          // cosine between the normals of two planes that touch
constexpr double cone = 0.9;            // an edge still replaces the sphere slightly beyond the normals of
                                        // its faces
constexpr double edgeReach = 0.6;       // spacings, half the length that an element describes along an edge
constexpr double leastCrossing = 0.05;  // smallest sine of the angle between edges that cross
constexpr double deepestEdge = 0.5;     // spacings, largest overlap of an edge; deeper points belong to
                                        // another face
constexpr double shallow = 0.03;        // spacings; edges touch a face instead if they overlap by more than
                                        // this plus the distance to an end

/// Returns true if the element's point in this direction lies on the part of the surface that the element
/// describes.
bool reaches(const PlacedElement& e, const Vec3d& direction, double spacing) {
  if (e.round()) return true;
  const double cosine = dot(e.normal, direction);
  if (!(cosine > 0)) return false;
  return e.plane() || e.radius * length(direction - cosine * e.normal) <= sphereReach * spacing;
}

/// Returns the outermost point of the surface in a direction (m, relative to the particle). Edges are round.
Vec3d roundPoint(const PlacedElement& e, const Vec3d& direction) {
  if (e.round() || e.plane()) return e.offset * direction;
  return (e.offset - e.radius) * e.normal + e.radius * direction;
}

/// Returns the same for sharp edges.
Vec3d outerPoint(const PlacedElement& e, const Vec3d& direction) {
  return isEdgeOutermost(e, direction) ? e.edge.to : roundPoint(e, direction);
}

std::optional<Vec3d> commonNormal(const PlacedElement& a, const PlacedElement& b) {
  if (a.plane() && b.plane()) {
    if (dot(a.normal, b.normal) > -facing) return {};
    return normalized(b.normal - a.normal);
  }
  if (a.plane()) return -a.normal;
  if (b.plane()) return b.normal;
  const Vec3d line = a.centre() - b.centre();
  const double size = length(line);
  if (!(size > 0)) return {};
  return line / size;
}

/// Returns the distance (m) along a plane element from its particle to a point.
double tangentialDistanceOf(const PlacedElement& plane, const Vec3d& point) {
  const Vec3d to = point - plane.position;
  return length(to - dot(to, plane.normal) * plane.normal);
}

/// Returns the length (m) along an edge from its nearest point to the end of the part that the element
/// describes.
double partAlong(double end, double spacing) { return end < HUGE_VAL ? end : edgeReach * spacing; }

/// Returns the contact of two sharp edges that cross.
std::optional<ElementContact> crossingOf(const PlacedElement& a, const PlacedElement& b, double spacing) {
  const SharpEdge &ea = a.edge, &eb = b.edge;
  const Vec3d across = cross(ea.along, eb.along);
  const double sine = length(across);
  if (!(sine > leastCrossing)) return {};
  const Vec3d n = across / (dot(ea.to, across) < 0 ? sine : -sine);
  if (!isEdgeOutermost(a, -n) || !isEdgeOutermost(b, n)) return {};
  const Vec3d pa = a.position + ea.to, pb = b.position + eb.to, between = pa - pb;
  const double k = dot(across, n), sa = -dot(cross(between, eb.along), n) / k,
               sb = -dot(cross(between, ea.along), n) / k;
  if (!onPart(ea, sa, spacing) || !onPart(eb, sb, spacing)) return {};
  const double gap = dot(between, n);
  const double room = std::min({ea.ahead - sa, ea.behind + sa, eb.ahead - sb, eb.behind + sb});
  if (-gap > std::min(deepestEdge * spacing, std::max(0.0, room) + shallow * spacing)) return {};
  return ElementContact{pb + sb * eb.along + 0.5 * gap * n, n, gap, std::hypot(sa, sb), true};
}

/// Returns the contact of a sharp edge or corner with a sphere.
std::optional<ElementContact> edgeOnSphere(const PlacedElement& a, const PlacedElement& b, double spacing) {
  const Vec3d centre = b.centre(), start = a.position + a.edge.to;
  const double s = dot(centre - start, a.edge.along);
  if (!onPart(a.edge, s, spacing)) return {};
  const Vec3d point = start + s * a.edge.along, line = point - centre;
  const double size = length(line);
  if (!(size > 0)) return {};
  const Vec3d n = line / size;
  if (!isEdgeOutermost(a, -n) || !reaches(b, n, spacing)) return {};
  const double gap = size - b.radius;
  return ElementContact{point - 0.5 * gap * n, n, gap, std::abs(s)};
}

/// Returns the contact of an edge or corner with an element that is not a plane. Returns none if they do not
/// touch at the edge.
std::optional<ElementContact> contactOfEdge(const PlacedElement& a, const PlacedElement& b, double spacing) {
  if (a.sharp() && b.sharp()) return crossingOf(a, b, spacing);
  if (a.sharp()) return edgeOnSphere(a, b, spacing);
  std::optional<ElementContact> c = edgeOnSphere(b, a, spacing);
  if (c) c->normal = -c->normal;
  return c;
}

}  // namespace

std::optional<ElementContact> contactOf(const PlacedElement& a, const PlacedElement& b, double spacing) {
  if ((a.sharp() || b.sharp()) && !a.plane() && !b.plane())
    if (const std::optional<ElementContact> c = contactOfEdge(a, b, spacing)) return c;
  const std::optional<Vec3d> n = commonNormal(a, b);
  if (!n || !reaches(a, -*n, spacing) || !reaches(b, *n, spacing)) return {};
  const Vec3d to = a.position - b.position;
  const double height = dot(to, *n);
  if (!(height > -spacing)) return {};  // the elements are back to back
  const bool planes = a.plane() || b.plane();
  const Vec3d outerA = planes ? outerPoint(a, -*n) : roundPoint(a, -*n),
              outerB = planes ? outerPoint(b, *n) : roundPoint(b, *n);
  ElementContact c{{}, *n, height + dot(outerA - outerB, *n), length(to - height * *n)};
  const bool edge = planes && (isEdgeOutermost(a, -*n) || isEdgeOutermost(b, *n));
  if (edge && -c.gap > deepestEdge * spacing) return {};
  // surface points of spheres and edges; on a plane, the point opposite to the other element
  const Vec3d pa = a.position + outerA, pb = b.position + outerB;
  const Vec3d middle = a.plane() == b.plane() ? 0.5 * (pa + pb) : a.plane() ? pb : pa;
  const double between = a.plane() == b.plane() ? 0 : (a.plane() ? 0.5 : -0.5) * c.gap;
  c.point = middle + between * *n;
  if (a.plane() && b.plane())
    return c.tangentialDistance <= elementReach * spacing ? std::optional(c) : std::nullopt;
  if (!a.plane() && !b.plane()) return c;
  c.tangentialDistance = tangentialDistanceOf(a.plane() ? a : b, c.point);
  return c.tangentialDistance <= planeReach * spacing ? std::optional(c) : std::nullopt;
}

bool onPart(const SharpEdge& e, double s, double spacing) {
  return s <= partAlong(e.ahead, spacing) && s >= -partAlong(e.behind, spacing);
}

PlacedElement placedElement(const SurfaceElement& e, const Vec3d& position, const Quat& orientation,
                            double spacing) {
  const double offset = e.offset;
  if (e.radius > e.offset)
    return {position, rotated(orientation, wide(e.normal)), offset, static_cast<double>(e.radius), {}};
  PlacedElement placed{position, {}, offset, offset, edgeOf(e, spacing)};
  placed.edge.to = rotated(orientation, placed.edge.to);
  placed.edge.along = rotated(orientation, placed.edge.along);
  return placed;
}

bool isEdgeOutermost(const PlacedElement& e, const Vec3d& direction) {
  return e.sharp() && dot(e.edge.to, direction) > cone * e.offset;
}

std::array<Vec3d, 2> facesBeside(const PlacedElement& e) {
  constexpr double even = 1e-3;  // relative
  const double square = dot(e.edge.to, e.edge.to), expected = 2 * e.offset * e.offset;
  if (e.edge.along == Vec3d{} || std::abs(square - expected) > even * expected) return {};
  const Vec3d out = 0.5 / e.offset * e.edge.to, aside = cross(e.edge.along, out);
  return {normalized(out + aside), normalized(out - aside)};
}

double extentTowards(const PlacedElement& e, const Vec3d& direction, double spacing) {
  if (!e.sharp()) return e.offset;
  const double along = dot(e.edge.along, direction);
  const double part = partAlong(along > 0 ? e.edge.ahead : e.edge.behind, spacing);
  return std::max(e.offset,
                  dot(e.edge.to, direction) + (e.edge.along == Vec3d{} ? 0 : part * std::abs(along)));
}

double extentOf(const PlacedElement& e, double spacing) {
  if (!e.sharp()) return e.offset;
  if (e.edge.along == Vec3d{}) return length(e.edge.to);
  const double part = std::max(partAlong(e.edge.ahead, spacing), partAlong(e.edge.behind, spacing));
  return std::sqrt(dot(e.edge.to, e.edge.to) + part * part);
}

std::optional<OutermostPoint> outermost(const PlacedElement& e, const Vec3d& direction, double spacing) {
  const auto fixed = [](const Vec3d& x) { return OutermostPoint{x, x, false}; };
  if (e.round()) {
    if (isEdgeOutermost(e, direction)) return fixed(e.position + e.edge.to);
    return OutermostPoint{e.position + e.offset * direction, e.position, false};
  }
  const double cosine = dot(e.normal, direction);
  if (!(cosine > 0)) return {};
  if (e.plane()) {
    if (cosine > facing) return fixed(e.position + e.offset * e.normal);
    return {};
  }
  const Vec3d along = direction - cosine * e.normal;
  const double sine = length(along), most = sphereReach * spacing / e.radius;
  if (sine <= most) return OutermostPoint{e.centre() + e.radius * direction, e.centre(), false};
  if (cosine < facing) return {};
  const Vec3d towards = std::sqrt(std::max(0.0, 1 - most * most)) * e.normal + (most / sine) * along;
  OutermostPoint rim = fixed(e.centre() + e.radius * towards);
  rim.atRim = true;
  return rim;
}

}  // namespace thaw
