// SPDX-License-Identifier: Apache-2.0
// Initial positions of the particles of an oriented body.
#pragma once
#include <string>

#include "core/geometry/basic/signed_distance.hpp"
#include "core/scene/oriented_body.hpp"

namespace thaw {

/// Sampled points, one per particle, ordered by number; the same on all ranks.
struct SampledPoints {
  std::vector<Vec3d> places, normals;  ///< m, unit
  std::vector<std::uint8_t> flags;     ///< Oriented::flags of given points and control points
  std::vector<std::string> notes;      ///< repairs of meshes, one sentence each
  double reach = 0;  ///< m, after thinning: largest distance of a surface position from the points; else 0
};

inline void addPoint(SampledPoints& m, const Vec3d& x, const Vec3d& n, std::uint8_t flags = 0) {
  m.places.push_back(x);
  m.normals.push_back(n);
  m.flags.push_back(flags);
}

/// Samples a body: a shape's surface or an open mesh, a hexagonal patch or disc, points, a thin plate through
/// control points, or a curve. Throws std::invalid_argument, ShapeError.
SampledPoints samplePoints(const OrientedBody& body, double spacing, std::uint64_t seed,
                           const MeshLoader& load);

/// Returns the OrientedBody::cellShare for which the particles' areas sum to that of the patch or disc; 1 for
/// other sources.
double areaFactorOf(const OrientedBody& body, double spacing);

/// Returns evenly spread points on an open or closed mesh, with the mesh's normals (blueNoise). Throws
/// ShapeError and the loader's exceptions.
SampledPoints sampleMesh(const Shape& shape, double spacing, std::uint64_t seed, const MeshLoader& load);

}  // namespace thaw
