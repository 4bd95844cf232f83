// SPDX-License-Identifier: Apache-2.0
#include "core/geometry/sampling/lattice.hpp"

#include <algorithm>
#include <cmath>

#include "core/geometry/basic/shape_error.hpp"
#include "core/geometry/shapes/combined.hpp"

namespace thaw {
namespace {

constexpr double mostPoints = 1099511627776.0;            // 2^40
constexpr double shortestCell = 0.75, longestCell = 1.3;  // spacings
constexpr double rounding = 1e-6;                         // spacings, of equal lengths

/// Cells along a length: their number, and the edge (m) of each. fit: the edges are in the allowed range.
struct Cells {
  double number = 1, edge = 0;
  bool fit = true;
};

Cells cellsAlong(double size, double spacing) {
  const double whole = std::max(1.0, std::round(size / spacing)), edge = size / whole;
  if (std::abs(size - whole * spacing) <= rounding * spacing) return {whole, spacing};
  return {whole, edge, edge >= shortestCell * spacing && edge <= longestCell * spacing};
}

Cells cellsAlong(double size, double spacing, Layers layers) {
  const Cells c = cellsAlong(size, spacing);
  if (c.fit) return c;
  const double cut = layers == Layers::Fit ? std::floor(size / spacing + rounding)
                                           : std::ceil(size / spacing - rounding);
  return {std::max(1.0, cut), spacing};
}

void requireSize(const Bounds& b, double points) {
  for (int a = 0; a < 3; a++)
    if (!std::isfinite(b.min[a]) || !std::isfinite(b.max[a]))
      throw ShapeError("a body of infinite size cannot be filled with particles");
  if (!(points < mostPoints))
    throw ShapeError("a body of this size needs more than 10^12 particles at the scene's spacing");
}

/// Returns the lattice in bounds, along the axes of the bounds.
SampleLattice latticeIn(const Bounds& b, double spacing, Layers layers) {
  SampleLattice l;
  double points = 1;
  for (int a = 0; a < 3; a++) {
    requireSize(b, points);
    const Cells along = cellsAlong(b.max[a] - b.min[a], spacing, layers);
    points *= along.number;
    requireSize(b, points);
    l.count[a] = static_cast<std::int64_t>(along.number);
    l.cell[a] = along.edge;
    l.corner[a] = 0.5 * (b.min[a] + b.max[a]) - 0.5 * along.number * along.edge;
  }
  return l;
}

/// Inserts a face into the ascending list `faces` if whole cells fit on both sides of it.
void addFace(double face, double spacing, std::vector<double>& faces) {
  const auto next = std::ranges::lower_bound(faces, face);
  if (next == faces.begin() || next == faces.end()) return;
  const double below = face - *(next - 1), above = *next - face;
  if (std::min(below, above) > rounding * spacing && cellsAlong(below, spacing).fit &&
      cellsAlong(above, spacing).fit)
    faces.insert(next, face);
}

/// Returns the faces of equal cells between consecutive planes.
std::vector<double> divided(const std::vector<double>& planes, double spacing) {
  std::vector<double> faces{planes.front()};
  for (std::size_t k = 1; k < planes.size(); k++) {
    const double from = planes[k - 1], number = cellsAlong(planes[k] - from, spacing).number;
    for (double n = 1; n < number; n++) faces.push_back(from + (planes[k] - from) * (n / number));
    faces.push_back(planes[k]);
  }
  return faces;
}

}  // namespace

SampleLattice sampleLattice(const SignedDistance& shape, double spacing, Layers layers) {
  return latticeIn(shape.bounds(), spacing, layers);
}

SampleLattice turnedLattice(const SignedDistance& shape, double spacing, Layers layers) {
  const Mat3d axes = axesOf(shape);
  if (isIdentity(axes)) return sampleLattice(shape, spacing, layers);
  const Mat3d rows = transpose(axes);
  Bounds b;
  for (int a = 0; a < 3; a++) {
    b.min[a] = -shape.extent(-rows.row[a]);
    b.max[a] = shape.extent(rows.row[a]);
  }
  SampleLattice l = latticeIn(b, spacing, layers);
  l.axes = axes;
  l.turned = true;
  l.corner = axes * l.corner;
  return l;
}

SampleLattice commonLattice(std::span<const Bounds> boxes, double spacing) {
  SampleLattice l;
  double points = 1;
  for (int a = 0; a < 3; a++) {
    std::vector<double> planes{never, -never};
    for (const Bounds& b : boxes) {
      requireSize(b, points);
      planes[0] = std::min(planes[0], b.min[a]), planes[1] = std::max(planes[1], b.max[a]);
    }
    points *= std::max(1.0, (planes[1] - planes[0]) / spacing);
    requireSize(boxes[0], points);
    for (const Bounds& b : boxes)
      for (const double face : {b.min[a], b.max[a]}) addFace(face, spacing, planes);
    l.faces[a] = divided(planes, spacing);
    l.count[a] = static_cast<std::int64_t>(l.faces[a].size()) - 1;
    l.corner[a] = planes[0];
    for (std::size_t k = 1; k < l.faces[a].size(); k++)
      l.cell[a] = std::max(l.cell[a], l.faces[a][k] - l.faces[a][k - 1]);
  }
  return l;
}

SampleLattice partOf(const SampleLattice& common, const Bounds& box) {
  SampleLattice l = common;
  for (int a = 0; a < 3; a++) {
    const std::vector<double>& all = common.faces[a];
    const double tolerance = rounding * common.cell[a];
    auto from = std::ranges::upper_bound(all, box.min[a] + tolerance);
    if (from != all.begin()) --from;
    auto to = std::ranges::lower_bound(all, box.max[a] - tolerance);
    if (to != all.end()) ++to;
    l.faces[a].assign(from, to);
    l.count[a] = static_cast<std::int64_t>(l.faces[a].size()) - 1;
    l.corner[a] = l.faces[a].front();
  }
  return l;
}

}  // namespace thaw
