// SPDX-License-Identifier: Apache-2.0
// Volume fractions of a body around its lattice points.
#pragma once
#include <cstdint>
#include <vector>

#include "core/geometry/sampling/sampling.hpp"

namespace thaw {

/// Returns the volume of the part of a body nearest to each lattice point, in 64ths of a cell. A lattice cell
/// is a particle if its middle is inside the body, so the particles of a ball form a staircase. The part of a
/// particle consists of the inside of its own cell, and of shares of surrounding cells whose middles are
/// outside. The inside of each such cell is divided among the nearest points. points: inside points of the
/// lattice (i + count[0] * row). 64 for all points of a shape with gaps.
std::vector<std::int32_t> cellFractions(const SignedDistance& shape, const SampleLattice& lattice,
                                        const std::vector<std::int64_t>& points);

/// Value of a whole cell (64ths).
inline constexpr std::int32_t wholeCell = 64;

}  // namespace thaw
