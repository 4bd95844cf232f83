// SPDX-License-Identifier: Apache-2.0
#include "core/oriented/sampling/sample_points.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <stdexcept>

#include "core/geometry/meshes/mesh_normals.hpp"
#include "core/geometry/sampling/blue_noise.hpp"
#include "core/geometry/shapes/placed_mesh.hpp"
#include "core/geometry/shapes/pose.hpp"
#include "core/math/hash_random.hpp"
#include "core/oriented/data/oriented.hpp"
#include "core/oriented/interpolation/interpolant.hpp"
#include "core/oriented/sampling/poisson_discs.hpp"
#include "core/oriented/sampling/relax_points.hpp"
#include "core/oriented/sampling/sample_surface.hpp"
#include "core/oriented/sampling/thin_points.hpp"

namespace thaw {
namespace {

constexpr double rowHeight = 0.86602540378443865;
// Radius around a control point in which particles are fixed, in spacings: two rings of particles. A bent
// surface would pull a single ring out of the surface.
constexpr double fixedRadius = 2.2;

/// Calls use(x, y) for a hexagonal lattice over a rectangle around the origin.
template<class Use> void eachOfLattice(double width, double depth, double spacing, Use&& use) {
  const auto rows = static_cast<std::int64_t>(std::floor(depth / (rowHeight * spacing) + 1e-9)),
             columns = static_cast<std::int64_t>(std::floor(width / spacing + 1e-9));
  for (std::int64_t j = 0; j <= rows; j++)
    for (std::int64_t i = 0; i <= columns; i++) {
      const double x = (static_cast<double>(i) - 0.5 * static_cast<double>(columns) +
                        (j % 2 ? 0.25 : -0.25)) *
                       spacing;
      use(x, (static_cast<double>(j) - 0.5 * static_cast<double>(rows)) * rowHeight * spacing);
    }
}

/// Calls use(x, y) for the lattice of a patch or disc in its own plane.
template<class Use> void eachOfFlat(const OrientedBody& b, double spacing, Use&& use) {
  const bool disc = b.source == OrientedSource::Disc;
  const double scale = b.shape.scale, radius = scale * b.radius, width = disc ? 2 * radius : scale * b.width,
               depth = disc ? width : scale * b.depth;
  eachOfLattice(width, depth, spacing, [&](double x, double y) {
    if (!disc || x * x + y * y <= radius * radius * (1 + 1e-9)) use(x, y);
  });
}

SampledPoints flatPatch(const OrientedBody& b, double spacing) {
  SampledPoints m;
  Pose pose = poseOf(b.shape.move, b.shape.rotate);
  pose.moved = true;
  eachOfFlat(b, spacing, [&](double x, double y) {
    addPoint(m, fromRest(pose, {x, y, 0}), directionFromRest(pose, {0, 0, 1}));
  });
  return m;
}

// Returns whether (px, py) lies in the convex hull of the points, to within 5 degrees.
bool inHull(const std::vector<double>& x, const std::vector<double>& y, double px, double py) {
  for (int k = 0; k < 72; k++) {
    const double c = std::cos(k * 0.0872664625997165), s = std::sin(k * 0.0872664625997165),
                 mine = c * px + s * py;
    double most = -1e300;
    for (std::size_t i = 0; i < x.size(); i++) most = std::max(most, c * x[i] + s * y[i]);
    if (mine > most + 1e-9) return false;
  }
  return true;
}

/// Samples a thin plate over the hull of its points. It takes the points, then positions in random order at
/// least 0.75 spacings apart. These then relax. A lattice lifted onto the plate would be stretched and tear
/// where the plate is steep. Position and normal of particles near a control point are fixed. Otherwise, the
/// potentials would flatten the plate.
SampledPoints plateThrough(const OrientedBody& b, double spacing, std::uint64_t seed) {
  const ThinPlate plate = thinPlate(b.points);
  SampledPoints m;
  double reach = 0;
  for (std::size_t k = 0; k < plate.x.size(); k++) {
    reach = std::max({reach, std::abs(plate.x[k]), std::abs(plate.y[k])});
    addPoint(m, b.points[k], plate.normal(plate.x[k], plate.y[k]), fixedPosition);
  }
  std::vector<SurfaceSample> samples;
  eachOfLattice(2 * reach + spacing, 2 * reach + spacing, spacing / 4, [&](double x, double y) {
    if (inHull(plate.x, plate.y, x, y))
      samples.push_back(
          {randomBits(seed, Purpose::OrientedSample, samples.size()), plate.at(x, y), plate.normal(x, y)});
  });
  addPoissonDiscs(samples, 0.75 * spacing, m);
  relaxPoints(1.05 * spacing, m, [&](Vec3d& place, Vec3d& n) {
    const Vec3d d = place - plate.origin;
    const double x = dot(d, plate.u), y = dot(d, plate.v);
    place = plate.at(x, y);
    n = plate.normal(x, y);
  });
  for (std::size_t i = 0; i < m.places.size(); i++)
    for (const Vec3d& point : b.points)
      if (length(m.places[i] - point) < fixedRadius * spacing) m.flags[i] = fixedPosition | fixedOrientation;
  return m;
}

/// Samples a parabola in y = 0, with particles one spacing apart along it.
SampledPoints curve(const OrientedBody& b, double spacing) {
  SampledPoints m;
  const Vec3d chord = b.to - b.from, up{-chord.z / length(chord), 0, chord.x / length(chord)};
  const auto at = [&](double s) { return b.from + s * chord + (4 * b.bulge * s * (1 - s)) * up; };
  constexpr int fine = 20000;
  double total = 0;
  std::vector<double> arc(fine + 1, 0);
  for (int k = 1; k <= fine; k++)
    arc[static_cast<std::size_t>(k)] = total += length(at(static_cast<double>(k) / fine) -
                                                       at((k - 1.0) / fine));
  const auto pieces = std::max<std::int64_t>(1, std::llround(total / spacing));
  for (std::int64_t k = 0; k <= pieces; k++) {
    const auto where = std::lower_bound(
                           arc.begin(), arc.end(),
                           total * static_cast<double>(k) / static_cast<double>(pieces) * (1 - 1e-12)) -
                       arc.begin();
    const double s = k == pieces ? 1 : static_cast<double>(where) / fine;
    const Vec3d along = normalized(chord + (4 * b.bulge * (1 - 2 * s)) * up);
    addPoint(m, at(s), {-along.z, 0, along.x});
  }
  return m;
}

void addRepairs(const Shape& shape, const MeshReport& report, SampledPoints& m) {
  if (std::string text = describeRepairs(shape.mesh, report); !text.empty())
    m.notes.push_back(std::move(text));
}

/// Returns the mesh of an open mesh shape. For other shapes, the result is empty, and their signed distance
/// reports errors.
std::optional<PlacedMesh> openMesh(const Shape& shape, const MeshLoader& load) {
  if (shape.kind != ShapeKind::Mesh) return {};
  try {
    if (PlacedMesh placed = makePlacedSurface(shape, load); placed.report.border > 0) return placed;
  } catch (const std::exception&) {}
  return {};
}

SampledPoints sampleBodyShape(const Shape& shape, double spacing, std::uint64_t seed,
                              const MeshLoader& load) {
  if (const std::optional<PlacedMesh> open = openMesh(shape, load)) {
    SampledPoints m = sampleOpenMesh(open->mesh, spacing, seed);
    addRepairs(shape, open->report, m);
    return m;
  }
  const std::shared_ptr<const SignedDistance> solid = makeSignedDistance(shape, load);
  SampledPoints m = sampleSurface(*solid, spacing, seed);
  solid->addNotes(m.notes);
  return m;
}

}  // namespace

double areaFactorOf(const OrientedBody& b, double spacing) {
  if (b.source != OrientedSource::Patch && b.source != OrientedSource::Disc) return 1;
  std::int64_t count = 0;
  eachOfFlat(b, spacing, [&](double, double) { count++; });
  const double area = b.shape.scale * b.shape.scale *
                      (b.source == OrientedSource::Disc ? std::numbers::pi * b.radius * b.radius
                                                        : b.width * b.depth);
  return count > 0 ? area / (rowHeight * spacing * spacing * static_cast<double>(count)) : 1;
}

SampledPoints sampleMesh(const Shape& shape, double spacing, std::uint64_t seed, const MeshLoader& load) {
  const PlacedMesh placed = makePlacedSurface(shape, load);
  const MeshNormals normals(placed.mesh);
  SampledPoints m;
  addRepairs(shape, placed.report, m);
  for (const MeshSample& s : blueNoise(placed.mesh, spacing, seed))
    addPoint(m, s.position, normals.at(s.position, s.triangle));
  return m;
}

SampledPoints samplePoints(const OrientedBody& b, double spacing, std::uint64_t seed,
                           const MeshLoader& load) {
  SampledPoints m;
  switch (b.source) {
    case OrientedSource::Surface:
      if (b.thin < 1 && b.shape.kind == ShapeKind::Mesh) m = sampleMesh(b.shape, spacing, seed, load);
      else m = sampleBodyShape(b.shape, spacing, seed, load);
      break;
    case OrientedSource::Patch:
    case OrientedSource::Disc: m = flatPatch(b, spacing); break;
    case OrientedSource::Control: m = plateThrough(b, spacing, seed); break;
    case OrientedSource::Curve: m = curve(b, spacing); break;
    case OrientedSource::Points: {
      const std::vector<Vec3d> normals = b.normals.empty() ? normalsOf(b.points) : b.normals;
      for (std::size_t k = 0; k < b.points.size(); k++)
        addPoint(m, b.points[k], normalized(normals[k]),
                 b.growth != OrientedGrowth::None ? fixedPosition | fixedOrientation : 0);
    }
  }
  if (b.thin < 1 && !m.places.empty()) {
    std::vector<std::string> notes = std::move(m.notes);
    m = thinPoints(m, b.thin, seed);
    m.notes = std::move(notes);
  }
  if (m.places.empty())
    throw std::invalid_argument("it has no particle; expected a body larger than its spacing");
  return m;
}

}  // namespace thaw
