// Particles of a body or an opening: positions that depend on the shape and the spacing only, never on the number of ranks.
#pragma once
#include <cstdint>
#include <vector>

#include "core/geometry/signed_distance.hpp"

namespace thaw {

/// Cubic lattice in the bounding box of a body, centred in it, along the axes of the scene. A box of n spacings gets n points,
/// the outer ones half a spacing inside.
struct SampleLattice {
  Vec3d first{};           ///< m, of point (0, 0, 0)
  double spacing = 0;      ///< m
  std::int64_t count[3]{};  ///< points along x, y, z; at least 1
  std::int64_t rows() const { return count[1] * count[2]; }
  Vec3d at(std::int64_t i, std::int64_t j, std::int64_t k) const {
    return {first.x + static_cast<double>(i) * spacing, first.y + static_cast<double>(j) * spacing, first.z + static_cast<double>(k) * spacing};
  }
};

/// Rows (along x) that one rank samples: [begin, end) of lattice.rows().
struct SampleRange { std::int64_t begin = 0, end = 0; };

struct Samples {
  std::vector<Vec3d> position;        ///< m
  std::vector<std::uint64_t> number;  ///< unique within the body, below 2^40, ascending: i + count[0] * row
};

/// Throws ShapeError: the bounds are not finite, or the lattice has 2^40 points or more.
SampleLattice sampleLattice(const SignedDistance& shape, double spacing);

/// The part of rank `rank` of `ranks`: even shares of the rows, empty for some if there are fewer rows than ranks.
SampleRange sampleRange(const SampleLattice& lattice, int rank, int ranks);

/// Points of the rows that are inside the shape, in the order of their numbers. The union over all ranges is the same for every split.
Samples sampleShape(const SignedDistance& shape, const SampleLattice& lattice, SampleRange range);

/// Only their number.
std::int64_t countSamples(const SignedDistance& shape, const SampleLattice& lattice, SampleRange range);

/// Start of a relaxed packing: a lattice point moved by up to `amount` spacings along each axis, at random as a function of seed and
/// id (unique over all bodies).
Vec3d jittered(const Vec3d& point, double amount, double spacing, std::uint64_t seed, std::uint64_t id);

/// The point moved against the gradient until it is at least `margin` (m) deep, or, where the shape is too thin for that, as deep as
/// a few steps get it. Points deep enough stay, bit by bit.
Vec3d pullInside(const SignedDistance& shape, const Vec3d& x, double margin);

}  // namespace thaw
