// Triangles between oriented particles, for display and export: particles themselves know of none.
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
  std::span<const double> spacings;         ///< m, wanted distance at each
  std::span<const std::uint32_t> groups;    ///< empty: all one surface
  std::span<const std::uint64_t> cutSides;  ///< as Oriented::cutSides; empty: no cuts
};

/// The smallest-sphere test (ST92): three particles, each within twice its spacing of the others, of one
/// surface and facing alike, are a triangle where no other such particle lies in the smallest sphere through
/// them. Counter-clockwise as seen from where the normals point; ascending. Together they are a surface
/// (manifold.hpp): an edge has one or two of them, and small holes are filled.
std::vector<std::array<std::uint32_t, 3>> triangulate(const OrientedPoints& points);

/// The same test of pairs, for what has no triangles (2D version): within twice their spacing, with no other
/// such particle in the smallest sphere through them. Only of particles that `wanted` says, one element each.
/// Ascending.
std::vector<std::array<std::uint32_t, 2>> joinLines(const OrientedPoints& points,
                                                    std::span<const std::uint8_t> wanted);

/// Pairs of particles that are a side of a triangle, each once.
std::vector<std::array<std::uint32_t, 2>> edgesOf(std::span<const std::array<std::uint32_t, 3>> triangles);

}  // namespace thaw
