// SPDX-License-Identifier: Apache-2.0
// Contact of two surface elements, and of an element with the face of an obstacle.
#pragma once
#include <array>
#include <optional>

#include "core/geometry/basic/signed_distance.hpp"
#include "core/math/quat.hpp"
#include "core/rigid/contact/sharp_edge.hpp"
#include "core/rigid/contact/surface_element.hpp"

namespace thaw {

/// Element in the frame of the scene.
struct PlacedElement {
  Vec3d position{};               ///< m, of the particle
  Vec3d normal{};                 ///< outward unit normal; zero: round
  double offset = 0, radius = 0;  ///< m
  SharpEdge edge{};               ///< edge of a round element, relative to the particle; may be absent

  bool round() const { return normal == Vec3d{}; }
  bool plane() const { return !round() && radius > 1e30; }
  bool sharp() const { return !(edge.to == Vec3d{}); }  ///< the element has an edge or a corner
  Vec3d centre() const { return position + (offset - radius) * normal; }  ///< requires: not a plane
};

struct ElementContact {
  Vec3d point{};                  ///< m
  Vec3d normal{};                 ///< unit vector towards the first element
  double gap = 0;                 ///< m
  double tangentialDistance = 0;  ///< m, along the surface: distance between the two particles, or of the
                                  ///< point from a plane's particle
  bool crossing = false;          ///< two sharp edges cross
};

/// Returns the contact of two elements that face each other, if it lies on both surfaces. A plane gives the
/// normal. Two spheres touch on their line of centres. Two crossing edges touch on the line normal to both.
std::optional<ElementContact> contactOf(const PlacedElement& a, const PlacedElement& b, double spacing);

/// Returns an element at a position (m), rotated from the body frame to the frame of the scene.
PlacedElement placedElement(const SurfaceElement& e, const Vec3d& position, const Quat& orientation,
                            double spacing);

/// Returns true if the edge or corner of an element is its outermost point in a direction (unit vector).
bool isEdgeOutermost(const PlacedElement& e, const Vec3d& direction);

/// Returns true if the element of an edge describes the edge at the distance s (m) along it from its nearest
/// point.
bool onPart(const SharpEdge& edge, double s, double spacing);

/// Returns the normals of both faces of a right-angled edge if the particle has the same distance from both.
/// Returns zeros otherwise.
std::array<Vec3d, 2> facesBeside(const PlacedElement& e);

/// Returns the extent (m) of a round element from its particle in a direction (unit vector).
double extentTowards(const PlacedElement& e, const Vec3d& direction, double spacing);

/// Returns the largest distance (m) between the particle of a round element and the surface that it
/// describes.
double extentOf(const PlacedElement& e, double spacing);

struct OutermostPoint {
  Vec3d point{};            ///< m
  Vec3d curvatureCentre{};  ///< m, centre of curvature, or the point itself for an edge or corner. Its
                            ///< distance from a plane there does not change when the body rotates
  bool atRim = false;       ///< the element ends there; another element probably has a point farther out
};

/// Returns the outermost point of an element in a direction (unit vector), within its part of the surface.
/// Sharp edges of the shape are included. Returns nothing if the element faces away.
std::optional<OutermostPoint> outermost(const PlacedElement& e, const Vec3d& direction, double spacing);

}  // namespace thaw
