// SPDX-License-Identifier: Apache-2.0
#include "io/render/surfels/spray.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "io/render/surfels/surfel_rows.hpp"
#include "io/surface_mesh/surface_mesh.hpp"

namespace thaw {

namespace {

/// Volume of the largest drop, in cubes of the spacing.
constexpr double largestDrop = 2.5;
/// Surfels of a ball. A longer ellipsoid has more of them.
constexpr double surfelsOfBall = 40;

double ballRadius(double volume) { return std::cbrt(volume * 3 / (4 * std::numbers::pi)); }

/// A surfel of an ellipsoid relative to its centre.
struct Sample {
  Vec3d offset, normal;
  double radius;
};

/// Returns points in a spiral, evenly spread over a ball, stretched along an axis at constant volume.
std::vector<Sample> sampleEllipsoid(const Vec3d& axis, double radius, double stretch) {
  const double along = radius * stretch, across = radius / std::sqrt(stretch);
  const auto count = static_cast<int>(std::lround(surfelsOfBall * stretch));
  const double apart = 1.2 * std::sqrt(4 * std::numbers::pi / count);
  const Vec3d side = normalized(cross(axis, std::abs(axis.z) < 0.9 ? Vec3d{0, 0, 1} : Vec3d{1, 0, 0})),
              other = cross(axis, side);
  const double golden = std::numbers::pi * (3 - std::sqrt(5.0));
  std::vector<Sample> samples;
  for (int k = 0; k < count; k++) {
    const double z = 1 - (2 * k + 1.0) / count, r = std::sqrt(1 - z * z);
    const Vec3d around = std::cos(golden * k) * side + std::sin(golden * k) * other;
    const double step = std::sqrt(along * along * r * r + across * across * z * z);
    samples.push_back({along * z * axis + across * r * around,
                       normalized(z / along * axis + r / across * around), apart * std::max(step, across)});
  }
  return samples;
}

}  // namespace

Spray sprayNamed(const std::string& name) {
  if (name == "ellipsoids") return Spray::Ellipsoids;
  if (name == "spheres") return Spray::Spheres;
  if (name == "hide") return Spray::Hide;
  if (name == "surfels") return Spray::Surfels;
  throw std::invalid_argument("unknown --spray " + name + "; expected ellipsoids, spheres, hide or surfels");
}

std::vector<SprayDrop> findSpray(const SurfaceFrame& frame, double spacing) {
  std::vector<SprayDrop> drops;
  if (!(spacing > 0)) return drops;
  const double cube = spacing * spacing * spacing, most = ballRadius(largestDrop * cube);
  const FrameColumn* velocity = frame.find("velocity");
  for (ComponentRows& c : rowsByComponent(frame)) {
    SprayDrop drop{c.component, {}, {}, {}, 0, cube};
    const double share = 1 / static_cast<double>(c.rows.size());
    for (const std::uint32_t i : c.rows) drop.centre += share * frame.positions[i];
    for (const std::uint32_t i : c.rows) drop.radius += share * length(frame.positions[i] - drop.centre);
    if (!(drop.radius < most)) continue;
    if (velocity && velocity->components == 3)
      for (const std::uint32_t i : c.rows)
        drop.velocity += share * Vec3d{velocity->value(i, 0), velocity->value(i, 1), velocity->value(i, 2)};
    drop.rows = std::move(c.rows);
    drops.push_back(std::move(drop));
  }
  return drops;
}

double radiusOf(const SprayDrop& drop) { return std::max(drop.radius, ballRadius(drop.least)); }

double stretchOf(const SprayDrop& drop, double exposure) {
  const double move = length(drop.velocity) * exposure / (2 * radiusOf(drop));
  return std::isfinite(move) ? 1 + move / (1 + move) : 1;
}

void replaceSpray(SurfaceFrame& frame, const std::vector<SprayDrop>& drops, const SprayStyle& style) {
  if (drops.empty() || style.look == Spray::Surfels) return;
  std::vector<std::uint8_t> gone(frame.positions.size(), 0);
  for (const SprayDrop& d : drops)
    for (const std::uint32_t i : d.rows) gone[i] = 1;
  std::vector<std::uint32_t> rows;
  for (std::uint32_t i = 0; i < gone.size(); i++)
    if (!gone[i]) rows.push_back(i);
  std::vector<Sample> samples;
  std::size_t row = rows.size();
  if (style.look != Spray::Hide)
    for (const SprayDrop& d : drops) {
      const double stretch = style.look == Spray::Ellipsoids ? stretchOf(d, style.exposure) : 1;
      const Vec3d axis = stretch > 1 ? normalized(d.velocity) : Vec3d{0, 0, 1};
      for (Sample& s : sampleEllipsoid(axis, radiusOf(d), stretch)) {
        s.offset += d.centre;
        samples.push_back(s);
        rows.push_back(d.rows.front());
      }
    }
  frame = rowsOf(frame, rows);
  for (const Sample& s : samples) {
    frame.positions[row] = s.offset;
    frame.normals[row] = single(s.normal);
    frame.radii[row] = static_cast<float>(s.radius);
    row++;
  }
}

}  // namespace thaw
