// Where the particles of an oriented body are at the start.
#pragma once
#include <string>

#include "core/geometry/signed_distance.hpp"
#include "core/scene/oriented_body.hpp"

namespace thaw {

/// One element a particle, in the order of their numbers; the same on all ranks.
struct MadePoints {
  std::vector<Vec3d> places, normals;
  std::vector<std::uint8_t> held;  ///< flags of Oriented: given points and control points
  std::vector<std::string> notes;  ///< what was mended of meshes, a sentence each
  double reach = 0;  ///< m, of thinned points: how far one is from any place of the surface at most; 0 for
                     ///< others
};

inline void addPoint(MadePoints& m, const Vec3d& x, const Vec3d& n, std::uint8_t held = 0) {
  m.places.push_back(x);
  m.normals.push_back(n);
  m.held.push_back(held);
}

/// Of a body: samples of a shape's surface (of an open mesh as it is), a hexagonal patch or disc, points, a
/// thin plate through control points, or a curve. Throws std::invalid_argument, ShapeError.
MadePoints makePoints(const OrientedBody& body, double spacing, std::uint64_t seed, const MeshLoader& load);

/// OrientedBody::cellShare with which its particles have the area of the patch or disc together; 1 of other
/// sources.
double cellShareOf(const OrientedBody& body, double spacing);

/// Evenly spread points of a mesh as it is, open or closed, with its normals: see blueNoise. Throws
/// ShapeError, or what the loader throws.
MadePoints sampleMesh(const Shape& shape, double spacing, std::uint64_t seed, const MeshLoader& load);

}  // namespace thaw
