// How much of a body lies around each point of its lattice.
#pragma once
#include <cstdint>
#include <vector>

#include "core/geometry/sampling.hpp"

namespace thaw {

/// A lattice cell is a particle where its middle is inside the body, so that the particles of a ball are a
/// staircase. Its share says what of the body is nearest to it: that part of its own cell which is inside,
/// and what is inside of the cells around whose middles are not. Nearest: of the points inside that are
/// around such a cell. In 64ths of a cell, for points of the lattice that are inside (i + count[0] * row). 64
/// for all of a shape with gaps.
std::vector<std::int32_t> cellShares(const SignedDistance& shape, const SampleLattice& lattice,
                                     const std::vector<std::int64_t>& points);

/// 64ths of a cell of a whole one.
inline constexpr std::int32_t wholeCell = 64;

}  // namespace thaw
