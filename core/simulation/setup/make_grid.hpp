// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "core/neighbours/grid.hpp"
#include "core/scene/scene.hpp"

namespace thaw {

/// Makes the grid of a scene. The cell edge is one support radius. Along a periodic axis, it is the smallest
/// integer fraction of the domain's length that is at least a support radius. Throws std::runtime_error if
/// the domain needs more than 2^20 cells along an axis, or a periodic side is shorter than three cells.
/// least: m, lower bound of the cell edge, for ranges that the scene alone does not determine.
CellGrid makeGrid(const Scene& scene, double least = 0);

/// As above for a domain and a support radius (m); cells are at least `edge` (m) long. spacing: m, for
/// messages; 0: unknown.
CellGrid makeGrid(const Domain& domain, double support, double edge = 0, double spacing = 0);

}  // namespace thaw
