// SPDX-License-Identifier: Apache-2.0
// Makes a manifold surface of candidate triangles that were found independently.
#pragma once
#include "core/oriented/mesh/triangulate.hpp"

namespace thaw {

using Corners = std::array<std::uint32_t, 3>;

/// Returns the counter-clockwise triangles that form a manifold together: at most two at an edge, in opposite
/// directions. Triangles of small circumradius come first.
std::vector<Corners> keepManifold(const OrientedPoints& points, std::vector<Corners> triangles);

/// Fills holes of at most `mostSides` sides, none longer than `longest` spacings, by ear clipping: the ear of
/// smallest circumradius first, if it faces like its particles. If this fails, the triangles between the
/// hole's own vertices are rebuilt. Requires and ensures: triangles are a manifold, as from keepManifold.
void fillHoles(const OrientedPoints& points, std::vector<Corners>& triangles, std::size_t mostSides,
               double longest);

}  // namespace thaw
