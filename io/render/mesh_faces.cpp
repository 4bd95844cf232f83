// SPDX-License-Identifier: Apache-2.0
#include "io/render/mesh_faces.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace thaw {
namespace {

constexpr float noValue = std::numeric_limits<float>::quiet_NaN();

/// Adds two rows: the side of the normal, then the other.
void addCorner(FrameView& v, const FaceCorner& c, float radius, float value) {
  for (int side = 0; side < 2; side++) {
    v.positions.push_back(c.place);
    v.normals.push_back(side ? c.normal * -1.0f : c.normal);
    v.radii.push_back(radius);
    v.values.push_back(value);
    v.colours.push_back(side ? c.back : c.colour);
    v.components.push_back(0xfffffff0u + static_cast<std::uint32_t>(side));
  }
}

void addSides(FrameView& view, std::uint32_t a, std::uint32_t b, std::uint32_t c) {  // rows of the front
  view.faces.push_back({a, b, c});
  view.faces.push_back({a + 1, c + 1, b + 1});
}

float distance(const Vec3f& a, const Vec3f& b) { return std::sqrt(dot(a - b, a - b)); }

}  // namespace

void extendArrays(FrameView& view) {
  const std::size_t n = view.positions.size();
  view.values.resize(n, noValue);
  view.colours.resize(n, Rgb{188, 193, 200});
  view.components.resize(n, 0);
}

void addMeshFaces(const DrawnMesh& m, FrameView& view) {
  std::vector<Vec3f> normals(m.positions.size());
  // Fraction of the longest edge: offset from the surface for light queries.
  std::vector<float> radii(m.positions.size(), 0);
  for (const auto& t : m.triangles) {
    const Vec3f face = cross(m.positions[t[1]] - m.positions[t[0]], m.positions[t[2]] - m.positions[t[0]]);
    for (int k = 0; k < 3; k++) {
      normals[t[k]] += face;
      radii[t[k]] = std::max(radii[t[k]], 0.6f * distance(m.positions[t[k]], m.positions[t[(k + 1) % 3]]));
    }
  }
  const auto first = static_cast<std::uint32_t>(view.positions.size());
  for (std::size_t i = 0; i < m.positions.size(); i++) {
    const float l = std::sqrt(dot(normals[i], normals[i]));
    addCorner(view, {m.positions[i], l > 0 ? normals[i] / l : Vec3f{0, 0, 1}, m.colours[i], m.colours[i]},
              radii[i], m.values.empty() ? noValue : m.values[i]);
  }
  for (const auto& t : m.triangles) addSides(view, first + 2 * t[0], first + 2 * t[1], first + 2 * t[2]);
}

void addFace(const std::array<FaceCorner, 3>& corners, FrameView& view) {
  const auto first = static_cast<std::uint32_t>(view.positions.size());
  for (std::size_t k = 0; k < 3; k++)
    addCorner(view, corners[k], 0.6f * distance(corners[k].place, corners[(k + 1) % 3].place), noValue);
  addSides(view, first, first + 2, first + 4);
}

}  // namespace thaw
