// SPDX-License-Identifier: Apache-2.0
#include "io/export/texture_seams.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <unordered_map>

#include "core/math/mat3.hpp"

namespace thaw {

namespace {

/// An edge crosses a seam if its length in the texture exceeds this times the median.
constexpr float seamLength = 6;
constexpr float shortestSeam = 0.02f;

using Triangle = std::array<std::uint32_t, 3>;

float lengthBetween(const Uv& a, const Uv& b) { return std::hypot(a[0] - b[0], a[1] - b[1]); }

/// Returns the largest length in the texture of an edge that crosses no seam.
float longestEdge(const TriangleMesh& mesh, const std::vector<Uv>& uv) {
  std::vector<float> lengths;
  for (const Triangle& t : mesh.triangles)
    if (const float l = lengthBetween(uv[t[0]], uv[t[1]]); std::isfinite(l)) lengths.push_back(l);
  if (lengths.empty()) return std::numeric_limits<float>::infinity();
  const auto middle = lengths.begin() + static_cast<std::ptrdiff_t>(lengths.size() / 2);
  std::nth_element(lengths.begin(), middle, lengths.end());
  return std::max(seamLength * *middle, shortestSeam);
}

/// Sums over the edges at a vertex, for the gradient of its chart by least squares.
struct EdgeSums {
  Mat3d edges{};
  std::array<Vec3d, 2> changes{};
  void add(const Vec3d& edge, const Uv& from, const Uv& to) {
    edges = edges + outer(edge, edge);
    for (std::size_t c = 0; c < 2; c++) changes[c] = changes[c] + static_cast<double>(to[c] - from[c]) * edge;
  }
};

/// Continues charts of a texture across its seams.
class Charts {
 public:
  Charts(const TriangleMesh& mesh, const std::vector<Uv>& uv)
      : mesh_(mesh), uv_(uv), longest_(longestEdge(mesh, uv)) {
    low_.fill(std::numeric_limits<float>::infinity());
    high_.fill(-std::numeric_limits<float>::infinity());
    for (const Uv& at : uv)
      for (std::size_t c = 0; c < 2; c++)
        low_[c] = std::min(low_[c], at[c]), high_[c] = std::max(high_[c], at[c]);
    for (const Triangle& t : mesh.triangles)
      if (isAcross(t))
        for (const std::uint32_t v : t) sums_.try_emplace(v);
    for (const Triangle& t : mesh.triangles)
      if (!sums_.empty() && !isAcross(t)) addEdges(t);
  }

  float longest() const { return longest_; }

  std::array<Uv, 3> cornersOf(const Triangle& t) const {
    std::array<Uv, 3> corners{uv_[t[0]], uv_[t[1]], uv_[t[2]]};
    if (!isAcross(t)) return corners;
    // Choose the chart that most corners share.
    std::size_t base = 0, most = 0;
    for (std::size_t k = 0; k < 3; k++) {
      std::size_t near = 0;
      for (std::size_t m = 0; m < 3; m++) near += m != k && isNear(corners[k], corners[m]);
      if (near > most) base = k, most = near;
    }
    const Uv from = corners[base];
    for (std::size_t k = 0; k < 3; k++)
      if (!isNear(from, corners[k])) corners[k] = continued(t[base], t[k]);
    return corners;
  }

 private:
  bool isNear(const Uv& a, const Uv& b) const { return lengthBetween(a, b) <= longest_; }
  bool isAcross(const Triangle& t) const {
    for (std::size_t k = 0; k < 3; k++)
      if (lengthBetween(uv_[t[k]], uv_[t[(k + 1) % 3]]) > longest_) return true;
    return false;
  }

  void addEdges(const Triangle& t) {
    for (const std::uint32_t v : t) {
      const auto sums = sums_.find(v);
      if (sums == sums_.end()) continue;
      for (const std::uint32_t w : t)
        if (w != v) sums->second.add(mesh_.vertices[w] - mesh_.vertices[v], uv_[v], uv_[w]);
    }
  }

  /// Returns the coordinates of vertex `to` on the chart of vertex `from`. Returns those of `from` itself
  /// where the chart's gradient is unknown.
  Uv continued(std::uint32_t from, std::uint32_t to) const {
    const EdgeSums& sums = sums_.at(from);
    const Mat3d& e = sums.edges;
    const double size = e.row[0].x + e.row[1].y + e.row[2].z;
    if (!(size > 0)) return uv_[from];
    // Edges of a flat fan have no part along the normal.
    constexpr double flat = 1e-3;
    const Vec3d away = inverse(e + flat * size * identity3<double>()) *
                       (mesh_.vertices[to] - mesh_.vertices[from]);
    Uv at = uv_[from];
    for (std::size_t c = 0; c < 2; c++)
      at[c] = std::clamp(at[c] + static_cast<float>(dot(sums.changes[c], away)), low_[c], high_[c]);
    return isNear(at, uv_[from]) ? at : uv_[from];
  }

  const TriangleMesh& mesh_;
  const std::vector<Uv>& uv_;
  float longest_;
  Uv low_{}, high_{};                                 ///< range of all coordinates
  std::unordered_map<std::uint32_t, EdgeSums> sums_;  ///< for vertices of triangles across seams
};

/// Appends a copy of the vertex's value.
template<class T> void repeat(std::vector<T>& values, std::uint32_t v) {
  if (!values.empty()) values.push_back(values[v]);
}

std::uint32_t duplicate(ComponentMesh& m, std::uint32_t v, const Uv& uv) {
  const auto number = static_cast<std::uint32_t>(m.mesh.vertices.size());
  repeat(m.mesh.vertices, v);
  repeat(m.colours, v), repeat(m.normals, v), repeat(m.velocities, v);
  repeat(m.temperatures, v), repeat(m.liquid, v), repeat(m.ids, v);
  m.uvs.push_back(uv);
  return number;
}

}  // namespace

std::vector<std::array<Uv, 3>> cornerUvs(const TriangleMesh& mesh, const std::vector<Uv>& uv) {
  const Charts charts(mesh, uv);
  std::vector<std::array<Uv, 3>> corners;
  corners.reserve(mesh.triangles.size());
  for (const Triangle& t : mesh.triangles) corners.push_back(charts.cornersOf(t));
  return corners;
}

void splitAtSeams(ComponentMesh& m) {
  if (m.uvs.empty()) return;
  const std::vector<Uv> before = m.uvs;
  const TriangleMesh whole = m.mesh;
  const Charts charts(whole, before);
  std::unordered_map<std::uint32_t, std::vector<std::uint32_t>> copies;
  for (Triangle& t : m.mesh.triangles) {
    const std::array<Uv, 3> corners = charts.cornersOf(t);
    for (std::size_t k = 0; k < 3; k++) {
      if (corners[k] == before[t[k]] || std::isnan(before[t[k]][0])) continue;
      std::vector<std::uint32_t>& known = copies[t[k]];
      // Triangles of one chart share the copy.
      const auto on = std::ranges::find_if(
          known, [&](std::uint32_t v) { return lengthBetween(m.uvs[v], corners[k]) <= charts.longest(); });
      if (on != known.end()) {
        t[k] = *on;
        continue;
      }
      const std::uint32_t copy = duplicate(m, t[k], corners[k]);
      known.push_back(copy);
      t[k] = copy;
    }
  }
}

}  // namespace thaw
