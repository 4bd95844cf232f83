// SPDX-License-Identifier: Apache-2.0
#include "io/render/oriented_view.hpp"

#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

#include "io/frames/read_oriented_frame.hpp"
#include "io/render/mesh_faces.hpp"

namespace thaw {
namespace {

namespace fs = std::filesystem;

constexpr float golden = 2.39996323f;
constexpr Rgb fixedColour{200, 60, 60};  // fixed particles are red

Rgb paintOf(const OrientedFrame& f, std::size_t i) {
  return {f.colours[i][0], f.colours[i][1], f.colours[i][2]};
}

Rgb darker(Rgb c, double share) {
  const auto part = [&](std::uint8_t v) { return static_cast<std::uint8_t>(v * share); };
  return {part(c.r), part(c.g), part(c.b)};
}

/// Returns evenly distributed points on the unit sphere.
Vec3f onSphere(int k, int n) {
  const float z = 1 - (2 * static_cast<float>(k) + 1) / static_cast<float>(n),
              r = std::sqrt(std::max(0.0f, 1 - z * z)), a = golden * static_cast<float>(k);
  return {r * std::cos(a), r * std::sin(a), z};
}

void addRod(FrameView& view, const Vec3d& from, const Vec3d& to, double radius, Rgb colour,
            std::uint32_t component) {
  const Vec3d along = to - from;
  const double l = length(along);
  if (!(l > 0)) return;
  const Vec3d e = along / l, u = normalized(cross(e, std::abs(e.x) < 0.6 ? Vec3d{1, 0, 0} : Vec3d{0, 1, 0})),
              v = cross(e, u);
  const int steps = std::max(2, static_cast<int>(std::ceil(l / (0.9 * radius))));
  for (int k = 0; k <= steps; k++)
    for (int a = 0; a < 8; a++) {
      const double angle = (a + 0.5 * (k % 2)) * (std::numbers::pi / 4);
      const Vec3d out = std::cos(angle) * u + std::sin(angle) * v;
      addDisc(view,
              {single(from + (static_cast<double>(k) / steps) * along + radius * out), single(out),
               static_cast<float>(0.7 * radius)},
              colour, component, false);
    }
}

void addMesh(FrameView& view, const OrientedFrame& f,
             std::span<const std::array<std::uint32_t, 3>> triangles) {
  for (const auto& t : triangles) {
    const Vec3d x[3] = {f.positions[t[0]], f.positions[t[1]], f.positions[t[2]]};
    // normals at a crease average both sides: the triangle uses its own normal there
    const bool folded = ((f.flags[t[0]] | f.flags[t[1]] | f.flags[t[2]]) & 1) != 0;
    const Vec3d flat = normalized(cross(x[1] - x[0], x[2] - x[0]));
    const Rgb colour = paintOf(f, t[0]);
    std::array<FaceCorner, 3> corners;
    for (std::size_t k = 0; k < 3; k++)
      corners[k] = {single(x[k]), single(folded ? flat : f.normals[t[k]]), colour, darker(colour, 0.72)};
    addFace(corners, view);
  }
}

/// Draws particles without a triangle (curves, isolated points, detached particles) as a ball with a normal.
void addIsolated(FrameView& view, const OrientedFrame& f,
                 std::span<const std::array<std::uint32_t, 3>> triangles) {
  std::vector<bool> shown(f.positions.size());
  for (const auto& t : triangles)
    for (const std::uint32_t corner : t) shown[corner] = true;
  for (std::size_t i = 0; i < f.positions.size(); i++) {
    if (shown[i]) continue;
    const double s = f.spacings[i];
    const auto component = static_cast<std::uint32_t>(5000 + i);
    addBall(view, single(f.positions[i]), static_cast<float>(0.22 * s),
            f.flags[i] & 2 ? fixedColour : paintOf(f, i), component);
    addRod(view, f.positions[i], f.positions[i] + (0.8 * s) * f.normals[i], 0.05 * s, {70, 110, 210},
           component);
  }
}

}  // namespace

OrientedLook orientedLookNamed(const std::string& name) {
  if (name == "mesh") return OrientedLook::Mesh;
  if (name == "wire") return OrientedLook::Wire;
  if (name == "discs") return OrientedLook::Discs;
  if (name == "axes") return OrientedLook::Axes;
  throw std::invalid_argument("expected mesh, wire, discs or axes for oriented particles, got " + name);
}

void addDisc(FrameView& view, const ViewDisc& disc, Rgb colour, std::uint32_t component, bool twoSided) {
  for (int side = 0; side < (twoSided ? 2 : 1); side++) {
    view.positions.push_back(disc.position);
    view.normals.push_back(side ? -disc.normal : disc.normal);
    view.radii.push_back(disc.radius);
    view.colours.push_back(side ? darker(colour, 0.72) : colour);
    view.components.push_back(2 * component + static_cast<std::uint32_t>(side));
    view.values.push_back(std::numeric_limits<float>::quiet_NaN());
  }
}

void addBall(FrameView& view, const Vec3f& place, float radius, Rgb colour, std::uint32_t component) {
  constexpr int discs = 40;
  for (int k = 0; k < discs; k++) {
    const Vec3f n = onSphere(k, discs);
    addDisc(view, {place + radius * n, n, 0.4f * radius}, colour, component, false);
  }
}

void spheresToDiscs(FrameView& view, float radius) {
  FrameView made;
  made.time = view.time;
  made.unit = view.unit;
  for (std::size_t i = 0; i < view.positions.size(); i++) {
    const std::size_t first = made.positions.size();
    addBall(made, view.positions[i], view.sizes.empty() ? radius : radius * view.sizes[i], {188, 193, 200},
            static_cast<std::uint32_t>(i));
    for (std::size_t k = first; k < made.positions.size(); k++)
      made.values[k] = view.values.empty() ? std::numeric_limits<float>::quiet_NaN() : view.values[i];
  }
  view = std::move(made);
  view.paint = SurfelPaint::Mixed;
}

void addOriented(FrameView& view, const fs::path& frame, OrientedLook look) {
  const OrientedFrame f = readOrientedFrame(frame.string());
  view.paint = SurfelPaint::Mixed;
  for (std::size_t i = 0; i < f.positions.size(); i++) {
    const auto component = static_cast<std::uint32_t>(5000 + i);
    const double s = f.spacings[i];
    const Rgb colour = f.flags[i] & 2 ? fixedColour : paintOf(f, i);
    if (look == OrientedLook::Discs) {
      addDisc(view, {single(f.positions[i]), single(f.normals[i]), static_cast<float>(0.36 * s)}, colour,
              component, true);
    } else if (look == OrientedLook::Axes) {
      const Vec3d x = f.positions[i], n = f.normals[i], u = f.tangents[i], v = cross(n, u);
      addRod(view, x, x + (0.4 * s) * u, 0.035 * s, {210, 80, 70}, component);
      addRod(view, x, x + (0.4 * s) * v, 0.035 * s, {90, 170, 90}, component);
      addRod(view, x, x + (0.8 * s) * n, 0.035 * s, {70, 110, 210}, component);
    }
  }
  if (look == OrientedLook::Discs || look == OrientedLook::Axes) return;
  const auto triangles = triangulate(f.points());
  addIsolated(view, f, triangles);
  if (look == OrientedLook::Mesh) return addMesh(view, f, triangles);
  std::uint32_t number = 5000;
  for (const auto& e : edgesOf(triangles))
    addRod(view, f.positions[e[0]], f.positions[e[1]], 0.05 * f.spacings[e[0]], paintOf(f, e[0]), number++);
}

void addOrientedBeside(FrameView& view, const fs::path& oriented, OrientedLook look, float spacing) {
  if (view.normals.empty()) spheresToDiscs(view, 0.6f * spacing);
  if (view.values.empty()) view.values.assign(view.positions.size(), std::numeric_limits<float>::quiet_NaN());
  addOriented(view, oriented, look);
}

}  // namespace thaw
