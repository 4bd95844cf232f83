// SPDX-License-Identifier: Apache-2.0
// Sampling of a body or an opening. Positions depend only on the shape and the spacing, not on the number of
// ranks.
#pragma once
#include <cstdint>
#include <vector>

#include "core/geometry/basic/signed_distance.hpp"
#include "core/math/mat3.hpp"

namespace thaw {

/// Rounding of the number of lattice points along a length that is not a multiple of the spacing. Cover
/// rounds up, so points reach the surface. Fit rounds down, so points keep at least half a spacing from the
/// surface. Emitted liquid uses Fit, since Cover would push adjacent liquid away.
enum class Layers { Cover, Fit };

/// Cubic lattice centred on the bounding box of a body, along the axes of the scene or of the body. A box
/// with an edge of n spacings gets n points along it. The outer points are half a spacing inside.
struct SampleLattice {
  Vec3d corner{};                    ///< m, half a spacing below point (0, 0, 0) along each axis
  double spacing = 0;                ///< m
  std::int64_t count[3]{};           ///< points along the axes; at least 1
  Mat3d axes = identity3<double>();  ///< columns: unit vectors along the axes
  bool turned = false;               ///< false: the axes are those of the scene
  std::int64_t rows() const { return count[1] * count[2]; }
  /// Returns a vector of the scene from its components along the axes.
  Vec3d along(const Vec3d& v) const { return turned ? axes * v : v; }
  Vec3d at(std::int64_t i, std::int64_t j, std::int64_t k) const {
    return corner + along({(static_cast<double>(i) + 0.5) * spacing, (static_cast<double>(j) + 0.5) * spacing,
                           (static_cast<double>(k) + 0.5) * spacing});
  }
};

/// Rows along x that a rank samples: range [begin, end) of lattice.rows().
struct SampleRange {
  std::int64_t begin = 0, end = 0;
};

/// Throws ShapeError if the bounds are not finite or the lattice has 2^40 points or more.
SampleLattice sampleLattice(const SignedDistance& shape, double spacing, Layers layers = Layers::Cover);

/// Returns the same along the axes of the shape (axesOf), which follow its rotation in the scene.
SampleLattice turnedLattice(const SignedDistance& shape, double spacing, Layers layers = Layers::Cover);

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
