// SPDX-License-Identifier: Apache-2.0
#include "core/simulation/setup/estimates/expected_rows.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "core/geometry/shapes/placed_mesh.hpp"
#include "core/simulation/setup/estimates/expected_particles.hpp"

namespace thaw {
namespace {

constexpr double hexagon = 0.86602540378443865;  // area of a particle over the square of the spacing
using std::numbers::pi;
// Lower bounds of bytes per row (columns and lists), per point of a body during set-up, and per surface
// sample. A particle has about 21 surface samples.
constexpr double orientedRow = 500, pointBytes = 49, sampleBytes = 21 * 56, vertexRow = 500, vertexPlan = 300;

double areaOf(const Shape& shape, const MeshLoader& load) {
  if (shape.kind != ShapeKind::Mesh) return expectedArea({makeSignedDistance(shape, load)});
  return thaw::areaOf(makePlacedSurface(shape, load).mesh);
}

double particlesOf(const OrientedBody& b, double s, const MeshLoader& load) {
  const double cell = hexagon * s * s, scale = b.shape.scale;
  switch (b.source) {
    case OrientedSource::Surface: return areaOf(b.shape, load) / cell;
    case OrientedSource::Patch: return (scale * b.width / s + 1) * (scale * b.depth / (hexagon * s) + 1);
    case OrientedSource::Disc: return pi * scale * b.radius * scale * b.radius / cell;
    case OrientedSource::Points: return static_cast<double>(b.points.size());
    case OrientedSource::Control: {  // the square in which the hull of the points is searched
      double reach = 0;
      for (const Vec3d& x : b.points)
        for (const Vec3d& y : b.points) reach = std::max(reach, length(x - y));
      return reach * reach / cell;
    }
    case OrientedSource::Curve: return (length(b.to - b.from) + 2 * std::abs(b.bulge)) / s + 1;
  }
  return 0;
}

double verticesOf(const SheetBody& b, double s) {
  const auto along = [&](double l) { return std::max(1.0, std::round(l / s)); };
  switch (b.mesh) {  // as in core/geometry/builtin/sheet_meshes.cpp
    case SheetMesh::Grid: return (along(b.width) + 1) * (along(b.depth) + 1);
    case SheetMesh::Sphere: return 10 * std::pow(along(1.107 * b.radius), 2) + 2;
    case SheetMesh::Head: return 10 * std::pow(along(0.45 * b.height), 2) + 2;
    case SheetMesh::Dome: return 3 * along(b.radius) * (along(b.radius) + 1) + 1;
    case SheetMesh::Forehead: return (along(b.width) + 1) * (along(b.height) + 1);
    case SheetMesh::File: break;  // known already
  }
  return 0;
}

}  // namespace

std::vector<ExpectedRows> expectedRows(const Scene& scene, const MeshLoader& load) {
  std::vector<ExpectedRows> all;
  for (const OrientedBody& b : scene.oriented) {
    ExpectedRows e{"oriented body '" + b.name + "'", b.where};
    e.spacing = spacingOf(scene, b);
    e.ownSpacing = b.spacing > 0;
    try {
      e.rows = particlesOf(b, e.spacing, load);
    } catch (const std::exception&) {  // the body's set-up reports the error with its location
    }
    e.bytesEverywhere = e.rows * (pointBytes + (b.source == OrientedSource::Surface ? sampleBytes : 0));
    e.bytesShared = b.thin * e.rows * orientedRow;
    // As in core/oriented/sampling/sample_points.cpp.
    e.spread = b.source == OrientedSource::Control ||
               (b.source == OrientedSource::Surface && (b.thin == 1 || b.shape.kind != ShapeKind::Mesh));
    all.push_back(std::move(e));
  }
  for (const SheetBody& b : scene.sheets) {
    ExpectedRows e{"sheet '" + b.name + "'", b.where};
    e.word = "vertices";
    e.spacing = spacingOf(scene, b);
    e.ownSpacing = b.spacing > 0;
    e.rows = verticesOf(b, e.spacing);
    e.bytesEverywhere = e.rows * vertexPlan;
    e.bytesShared = e.rows * vertexRow;
    all.push_back(std::move(e));
  }
  return all;
}

}  // namespace thaw
