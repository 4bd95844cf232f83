#include "io/render/mesh_discs.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/geometry/mesh_edges.hpp"

namespace thaw {
namespace {

void addDisc(FrameView& v, const Vec3f& x, const Vec3f& n, float radius, float value, const Rgb& colour, std::uint32_t component) {
  v.positions.push_back(x);
  v.normals.push_back(n);
  v.radii.push_back(radius);
  v.values.push_back(value);
  v.colours.push_back(colour);
  v.components.push_back(component);
}

std::vector<Vec3f> normalsOf(const DrawnMesh& m) {
  std::vector<Vec3f> n(m.positions.size());
  for (const auto& t : m.triangles) {
    const Vec3f face = cross(m.positions[t[1]] - m.positions[t[0]], m.positions[t[2]] - m.positions[t[0]]);
    for (const std::uint32_t v : t) n[v] += face;
  }
  for (Vec3f& x : n)
    if (const float l = std::sqrt(dot(x, x)); l > 0) x = x / l;
  return n;
}

/// Of each vertex: does its piece have a border, so that its back can be seen?
std::vector<std::uint8_t> openPieces(const DrawnMesh& m) {
  TriangleMesh mesh;
  mesh.vertices.resize(m.positions.size());
  mesh.triangles.assign(m.triangles.begin(), m.triangles.end());
  DisjointSets pieces(m.positions.size());
  std::vector<std::uint8_t> border(m.positions.size(), 0), open(m.positions.size(), 0);
  const std::vector<EdgeSide> sides = edgeSides(mesh);
  for (const EdgeSide& s : sides) pieces.join(static_cast<std::uint32_t>(s.edge >> 32), static_cast<std::uint32_t>(s.edge & 0xffffffffu));
  forEachEdge(sides, [&](std::size_t first, std::size_t last) {
    if (last - first == 1) border[pieces.find(static_cast<std::uint32_t>(sides[first].edge >> 32))] = 1;
  });
  for (std::uint32_t v = 0; v < open.size(); v++) open[v] = border[pieces.find(v)];
  return open;
}

constexpr float noValue = std::numeric_limits<float>::quiet_NaN();
constexpr std::uint32_t meshComponent = 0xfffffff0u;

}  // namespace

void addMeshDiscs(const DrawnMesh& m, int fine, FrameView& view) {
  const std::vector<Vec3f> normals = normalsOf(m);
  const std::vector<std::uint8_t> open = openPieces(m);
  const auto parts = static_cast<float>(fine);
  for (const auto& t : m.triangles) {
    const Vec3f &a = m.positions[t[0]], &b = m.positions[t[1]], &c = m.positions[t[2]];
    const Vec3f ab = b - a, ac = c - a, bc = c - b;
    const float edge = std::sqrt(std::max({dot(ab, ab), dot(ac, ac), dot(bc, bc)}));
    if (!(edge > 0)) continue;
    // middles of the small triangles: those that point as the large one does, and those between
    for (int i = 0; i < fine; i++)
      for (int j = 0; i + j < fine; j++)
        for (int turned = 0; turned < (i + j + 1 < fine ? 2 : 1); turned++) {
          const float u = (static_cast<float>(i) + (turned ? 2.0f : 1.0f) / 3) / parts, w = (static_cast<float>(j) + (turned ? 2.0f : 1.0f) / 3) / parts, s = 1 - u - w;
          const auto mean = [&](const auto& x, const auto& y, const auto& z) { return x * s + y * u + z * w; };
          const Vec3f x = mean(a, b, c);
          Vec3f n = mean(normals[t[0]], normals[t[1]], normals[t[2]]);
          const float l = std::sqrt(dot(n, n));
          if (!(l > 0)) continue;
          n = n / l;
          const float value = m.values.empty() ? noValue : mean(m.values[t[0]], m.values[t[1]], m.values[t[2]]);
          const float radius = 0.62f * edge / parts;
          addDisc(view, x, n, radius, value, m.colours[t[0]], meshComponent);
          // the back lies a little behind, so that it does not look over the edge where the sheet turns away
          if (open[t[0]]) addDisc(view, x - n * (0.35f * radius), n * -1.0f, radius, value, m.colours[t[0]], meshComponent + 1);
        }
  }
}

void ballsOfParticles(float radius, const Rgb& colour, FrameView& view) {
  FrameView balls;
  balls.time = view.time;
  balls.unit = view.unit;
  const float g = 1.618034f, l = std::sqrt(1 + g * g);
  std::vector<Vec3f> directions;
  for (const float s : {1.0f, -1.0f})
    for (const float t : {1.0f, -1.0f}) {
      directions.push_back({0, s / l, t * g / l});
      directions.push_back({s / l, t * g / l, 0});
      directions.push_back({t * g / l, 0, s / l});
    }
  for (std::size_t i = 0; i < view.positions.size(); i++)
    for (const Vec3f& n : directions)
      addDisc(balls, view.positions[i] + n * radius, n, 0.62f * radius, view.values.empty() ? noValue : view.values[i], colour, static_cast<std::uint32_t>(i));
  view = std::move(balls);
}

}  // namespace thaw
