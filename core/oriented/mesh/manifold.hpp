// SPDX-License-Identifier: Apache-2.0
// Makes a manifold surface from independently found candidate triangles.
#pragma once
#include "core/oriented/mesh/triangulate.hpp"

namespace thaw {

using Corners = std::array<std::uint32_t, 3>;

/// Returns counter-clockwise triangles that together form a manifold: at most two at an edge, in opposite
/// directions. Triangles with a small circumradius are accepted first.
std::vector<Corners> keepManifold(const OrientedPoints& points, std::vector<Corners> triangles);

/// Fills holes with at most `mostSides` sides, none longer than `longest` spacings, by ear clipping. The ear
/// with the smallest circumradius is first, if its normal agrees with its particles'. If this fails, the
/// triangles between the hole's own vertices are rebuilt. Requires and ensures: triangles are a manifold, as
/// from keepManifold.
void fillHoles(const OrientedPoints& points, std::vector<Corners>& triangles, std::size_t mostSides,
               double longest);

}  // namespace thaw
