// SPDX-License-Identifier: Apache-2.0
// Lattices of points in bodies. Positions depend only on the shapes and the spacing, not on the number of
// ranks.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "core/geometry/basic/signed_distance.hpp"
#include "core/math/mat3.hpp"

namespace thaw {

/// Rounding of the number of cells along a length to which cells cannot be stretched. Cover rounds up, so
/// points reach the surface. Fit rounds down, so points keep at least half a spacing from the surface.
enum class Layers { Cover, Fit };

/// Lattice of cells over the bounding box of a body, along the axes of the scene or of the body. Points are
/// the middles of cells. Along an axis, the box contains the nearest whole number of equal cells, so that a
/// body fills its container. Lengths that would need cells shorter than 0.75 or longer than 1.3 spacings have
/// cells of one spacing instead, in the middle of the box (Layers).
struct SampleLattice {
  Vec3d corner{};                    ///< m, lower corner of cell (0, 0, 0)
  Vec3d cell{};                      ///< m, edges of a cell; the longest ones where cells differ
  std::int64_t count[3]{};           ///< cells along the axes; at least 1
  std::vector<double> faces[3];      ///< m, ascending, of cells along axes with different cells; else empty
  Mat3d axes = identity3<double>();  ///< columns: unit vectors along the axes
  bool turned = false;               ///< false: the axes are those of the scene
  std::int64_t rows() const { return count[1] * count[2]; }
  /// Returns a vector of the scene from its components along the axes.
  Vec3d along(const Vec3d& v) const { return turned ? axes * v : v; }
  Vec3d at(std::int64_t i, std::int64_t j, std::int64_t k) const {
    if (!faces[0].empty()) return {middle(0, i), middle(1, j), middle(2, k)};
    return corner + along({(static_cast<double>(i) + 0.5) * cell.x, (static_cast<double>(j) + 0.5) * cell.y,
                           (static_cast<double>(k) + 0.5) * cell.z});
  }
  /// Returns the point of a number i + count[0] * (j + count[1] * k).
  Vec3d at(std::int64_t number) const {
    return at(number % count[0], number / count[0] % count[1], number / count[0] / count[1]);
  }
  double middle(int axis, std::int64_t i) const {
    const auto n = static_cast<std::size_t>(i);
    return 0.5 * (faces[axis][n] + faces[axis][n + 1]);
  }
  /// Returns the edges (m) of a cell.
  Vec3d edges(std::int64_t i, std::int64_t j, std::int64_t k) const {
    if (faces[0].empty()) return cell;
    const std::int64_t at[3] = {i, j, k};
    Vec3d e;
    for (int a = 0; a < 3; a++) {
      const auto n = static_cast<std::size_t>(at[a]);
      e[a] = faces[a][n + 1] - faces[a][n];
    }
    return e;
  }
  /// Returns the mass (kg) of a cell by its number, at a density (kg/m^3).
  double mass(std::int64_t number, double density) const {
    const Vec3d e = edges(number % count[0], number / count[0] % count[1], number / count[0] / count[1]);
    return density * e.x * e.y * e.z;
  }
  bool equalCells() const { return faces[0].empty(); }
};

/// Throws ShapeError if the bounds are not finite or the lattice has 2^40 points or more.
SampleLattice sampleLattice(const SignedDistance& shape, double spacing, Layers layers = Layers::Cover);

/// Returns the same along the axes of the shape (axesOf), which follow its rotation in the scene.
SampleLattice turnedLattice(const SignedDistance& shape, double spacing, Layers layers = Layers::Cover);

/// Returns a lattice over several boxes, with faces of cells at the faces of the boxes. Cells are equal
/// between two such faces. Earlier boxes precede: a face too near to others is left out. Throws as
/// sampleLattice.
SampleLattice commonLattice(std::span<const Bounds> boxes, double spacing);

/// Returns the cells of a common lattice that intersect a box.
SampleLattice partOf(const SampleLattice& common, const Bounds& box);

}  // namespace thaw
