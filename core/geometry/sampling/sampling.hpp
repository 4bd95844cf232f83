// SPDX-License-Identifier: Apache-2.0
// Sampling of a body or an opening. Positions depend only on the shape and the spacing, not on the number of
// ranks.
#pragma once
#include <cstdint>
#include <vector>

#include "core/geometry/basic/signed_distance.hpp"
#include "core/geometry/sampling/lattice.hpp"

namespace thaw {

/// Rows along x that a rank samples: range [begin, end) of lattice.rows().
struct SampleRange {
  std::int64_t begin = 0, end = 0;
};

/// Returns the rows of one rank: equal shares, empty for some ranks if there are fewer rows than ranks.
SampleRange sampleRange(const SampleLattice& lattice, int rank, int ranks);

/// Returns the indices i, ascending, of the points of a row that are inside the shape. The number of a point
/// is i + count[0] * row. It is unique within the body and below 2^40. known: one object for all rows of a
/// body.
std::vector<std::int64_t> insideOfRow(const SignedDistance& shape, const SampleLattice& lattice,
                                      std::int64_t row, KnownSides& known);

/// Returns a lattice point (m) with a random offset of up to `amount` spacings along each axis, for the
/// start of a relaxed packing. The offset is a function of seed and id (unique over all bodies).
Vec3d jittered(const Vec3d& point, double amount, double spacing, std::uint64_t seed, std::uint64_t id);

/// Moves a point against the gradient until it is at least `margin` (m) deep. In thinner shapes, it becomes
/// as deep as a few steps allow. Points that are deep enough keep their bits.
Vec3d pullInside(const SignedDistance& shape, const Vec3d& x, double margin);

}  // namespace thaw
