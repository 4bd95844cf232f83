// SPDX-License-Identifier: Apache-2.0
// Triangulation of oriented particles for display and export, because particles store no topology.
#pragma once
#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "core/math/vec3.hpp"

namespace thaw {

struct OrientedPoints {
  std::span<const Vec3d> positions;         ///< m
  std::span<const Vec3d> normals;           ///< unit
  std::span<const double> spacings;         ///< m, rest distance of each particle
  std::span<const std::uint32_t> groups;    ///< empty: one surface
  std::span<const std::uint64_t> cutSides;  ///< as Oriented::cutSides; empty: no cuts
};

/// Returns triangles by the smallest-sphere test (ST92). The three particles belong to one surface, their
/// normals agree, and each is within twice its spacing of the others. The smallest sphere through them
/// contains no other such particle. Triangles are counter-clockwise seen from the normals, in ascending
/// order. Together they are a manifold (manifold.hpp), with small holes filled.
std::vector<std::array<std::uint32_t, 3>> triangulate(const OrientedPoints& points);

/// Returns pairs by the same test (2D version) in ascending order, for particles without triangles. wanted:
/// one flag for each particle; only flagged particles are used.
std::vector<std::array<std::uint32_t, 2>> joinLines(const OrientedPoints& points,
                                                    std::span<const std::uint8_t> wanted);

/// Returns the edges of triangles, each once.
std::vector<std::array<std::uint32_t, 2>> edgesOf(std::span<const std::array<std::uint32_t, 3>> triangles);

}  // namespace thaw
