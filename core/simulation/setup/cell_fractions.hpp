// SPDX-License-Identifier: Apache-2.0
// Volume fractions of a body around its lattice points.
#pragma once
#include <cstdint>
#include <vector>

#include "core/geometry/sampling/sampling.hpp"

namespace thaw {

/// Returns the part of a body nearest to each lattice point, in 64ths of a cell. A lattice cell is a particle
/// if its middle is inside the body, so particles of a ball form a staircase. The part is the inside of its
/// own cell, and a share of the inside of surrounding cells whose middles are outside. Each of those is
/// divided among the nearest points. points: inside points of the lattice (i + count[0] * row). 64 for all
/// points of a shape with gaps.
std::vector<std::int32_t> cellFractions(const SignedDistance& shape, const SampleLattice& lattice,
                                        const std::vector<std::int64_t>& points);

/// Value of a whole cell (64ths).
inline constexpr std::int32_t wholeCell = 64;

}  // namespace thaw
