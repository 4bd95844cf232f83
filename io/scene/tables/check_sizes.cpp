// SPDX-License-Identifier: Apache-2.0
// Refuses spacings that no machine has memory for, before anything is made. The memory of this machine is
// checked later (io/run/require_memory.hpp).
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <optional>
#include <stdexcept>

#include "core/geometry/basic/signed_distance.hpp"
#include "core/simulation/setup/estimates/expected_particles.hpp"
#include "core/simulation/setup/estimates/expected_rows.hpp"
#include "core/simulation/setup/make_grid.hpp"
#include "io/scene/tables/read_sections.hpp"

namespace thaw {
namespace {

constexpr double mostLatticePoints = 1099511627776.0;  // 2^40, the range of ids in a body
constexpr double modest = 1e6;                         // particles that fit any machine

/// Returns the largest distance (m) of a shape's points from its own origin, 0 for shapes without a size in
/// the scene.
double reach(const Shape& s) {
  switch (s.kind) {
    case ShapeKind::Box: return 0.5 * length(s.size);
    case ShapeKind::Sphere: return s.radius;
    case ShapeKind::Cylinder: return std::hypot(s.radius, 0.5 * s.height);
    case ShapeKind::Torus: return s.radius + s.radius2;
    case ShapeKind::Glass: return std::hypot(s.radius, s.height);
    default: return 0;
  }
}

/// Returns the approximate number of particles in a shape, 0 if that needs a file.
double particlesIn(const Shape& shape, double spacing) {
  try {
    const double expected = expectedParticles({makeSignedDistance(shape)}, spacing);
    return std::isfinite(expected) ? expected : 0;
  } catch (const std::exception&) { return 0; }
}

/// Returns the error for all continuum bodies together, at the key `spacing`, if one of them has more
/// particles than there are ids. Else returns "".
std::string tooFineForBodies(const Scene& s, bool noGrid) {
  double sum = 0, most = 0;
  const Body* largest = nullptr;
  bool tooMany = false;
  for (const Body& b : s.bodies) {
    const double scale = b.shape.fitHeight ? 1 : b.shape.scale,
                 around = std::pow(2 * scale * reach(b.shape) / s.spacing, 3);
    if (!noGrid && !(around > 16 * mostLatticePoints)) continue;
    const double own = particlesIn(b.shape, s.spacing), points = own > 0 ? own : around;
    tooMany = tooMany || points > mostLatticePoints;
    sum += points;
    if (points > most) most = points, largest = &b;
  }
  if (!tooMany) return "";
  return fmt::format(
      "spacing: at {:.3g} m body '{}'{} would take about {:.1e} particles, at least {:.1e} GB of memory; "
      "use a coarser spacing ({:.2g} m makes a million of them), or a smaller body",
      s.spacing, largest->name, most < sum ? " and others" : "", sum, sum * leastParticleBytes / 1e9,
      s.spacing * std::cbrt(sum / modest));
}

/// Checks oriented bodies and sheets without files, if the domain cannot be divided into cells. The error is
/// at the body if it has its own spacing, else at the `spacing` of the scene for the largest body.
bool tooFineForBodyTypes(const SceneReading& x, std::vector<SceneError>& errors) {
  const std::size_t before = errors.size();
  const auto refuse = [&](const ExpectedRows& e, const SourcePlace& where, const char* key) {
    errors.push_back(
        {where,
         fmt::format(
             "{}{}: at a spacing of {:.3g} m it would have about {:.1e} {}, which take at least {:.1e} GB of "
             "memory; use a coarser spacing ({:.2g} m makes a million of them), or a smaller body",
             key, e.name, e.spacing, e.rows, e.word, (e.bytesEverywhere + e.bytesShared) / 1e9,
             e.spacing * std::sqrt(e.rows / modest))});
  };
  std::optional<ExpectedRows> largest;
  for (const ExpectedRows& e : expectedRows(
           *x.scene, [](const std::string& path) -> TriangleMesh { throw std::runtime_error(path); })) {
    if (!(e.rows > 100 * modest)) continue;
    if (e.ownSpacing) refuse(e, e.where, "");
    else if (!largest || e.rows > largest->rows) largest = e;
  }
  if (largest) refuse(*largest, x.spacing, "spacing: ");
  return errors.size() > before;
}

/// Returns text on the room for particles in the domain. Meshes in files are not read yet.
std::string roomText(const Scene& s) {
  double finest = s.spacing;
  for (const OrientedBody& b : s.oriented) finest = std::min(finest, spacingOf(s, b));
  for (const SheetBody& b : s.sheets) finest = std::min(finest, spacingOf(s, b));
  const Vec3d n = (s.domain.max - s.domain.min) * (1 / finest);
  if (hasContinuum(s))
    return fmt::format("; at {:.3g} m it has room for about {:.0e} particles", finest, n.x * n.y * n.z);
  return fmt::format("; at {:.3g} m a surface as large as its sides would have about {:.0e} particles",
                     finest, 2 * (n.x * n.y + n.y * n.z + n.z * n.x));
}

/// Returns the reason why the domain cannot be divided into cells, or "".
std::string noGridFor(const Scene& s) {
  for (int a = 0; a < 3; a++)
    if (!(s.domain.max[a] > s.domain.min[a])) return "";  // reported where it is read
  try {
    makeGrid(s);
  } catch (const std::runtime_error& e) { return e.what(); }
  return "";
}

}  // namespace

void checkSizes(const SceneReading& x, std::vector<SceneError>& errors) {
  const Scene& s = *x.scene;
  if (s.bodies.size() + s.emitters.size() > 65000)
    errors.push_back({x.start, fmt::format("the scene has {} bodies and emitters; expected at most 65000",
                                           s.bodies.size() + s.emitters.size())});
  const std::string noGrid = noGridFor(s);
  // A body that is too fine is too fine for the domain as well. One message is enough.
  if (const std::string text = tooFineForBodies(s, !noGrid.empty()); !text.empty())
    return errors.push_back({x.spacing, text});
  if (noGrid.empty() || tooFineForBodyTypes(x, errors)) return;
  errors.push_back({x.domain.line > 0 ? x.domain : x.spacing, noGrid + roomText(s)});
}

}  // namespace thaw
