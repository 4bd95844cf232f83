#pragma once
#include "core/neighbours/grid.hpp"
#include "core/scene/scene.hpp"

namespace thaw {

/// The grid of a scene: cells of one support radius; along a periodic axis the largest whole fraction of the
/// domain that is not smaller. Throws std::runtime_error with one clear sentence where the domain is too
/// large for 2^20 cells along an axis, or a periodic side too short for three cells. least: m, edge of cells
/// at least, for what the scene alone does not tell.
CellGrid makeGrid(const Scene& scene, double least = 0);

/// The same of a domain, with cells of another radius (m); cells are at least as long as `edge` (m).
/// spacing: m, for messages; 0: not known.
CellGrid makeGrid(const Domain& domain, double support, double edge = 0, double spacing = 0);

}  // namespace thaw
