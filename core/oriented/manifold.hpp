// Makes a surface of the triangles that a test of each one by itself has found.
#pragma once
#include "core/oriented/triangulate.hpp"

namespace thaw {

using Corners = std::array<std::uint32_t, 3>;

/// Of triangles that run counter-clockwise those that make a surface together: no more than two at an edge,
/// which run along it in opposite directions. The roundest (radius of the circle through the corners) come
/// first.
std::vector<Corners> keepManifold(const OrientedPoints& points, std::vector<Corners> triangles);

/// Adds triangles in holes of at most `mostSides` sides, none longer than `longest` spacings: the roundest
/// corner first (ears), where they face as the particles do. Of a hole that cannot be closed so the triangles
/// between its own corners are made anew. Needs triangles as keepManifold leaves them, and leaves them so.
void fillHoles(const OrientedPoints& points, std::vector<Corners>& triangles, std::size_t mostSides,
               double longest);

}  // namespace thaw
