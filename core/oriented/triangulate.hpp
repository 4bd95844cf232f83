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
  std::span<const Vec3d> positions;           ///< m
  std::span<const Vec3d> normals;             ///< unit
  std::span<const double> spacings;           ///< m, wanted distance at each
  std::span<const std::uint32_t> groups;      ///< empty: all one surface
  std::span<const std::uint64_t> cutSides;    ///< as Oriented::cutSides; empty: no cuts
};

/// The smallest-sphere test (ST92): three particles, each within twice its spacing of the others, of one surface and facing alike, are a triangle
/// where no other such particle lies in the smallest sphere through them. Counter-clockwise as seen from where the normals point; ascending.
std::vector<std::array<std::uint32_t, 3>> triangulate(const OrientedPoints& points);

/// Pairs of particles that are a side of a triangle, each once.
std::vector<std::array<std::uint32_t, 2>> edgesOf(std::span<const std::array<std::uint32_t, 3>> triangles);

}  // namespace thaw
