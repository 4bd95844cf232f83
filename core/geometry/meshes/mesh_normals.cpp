// SPDX-License-Identifier: Apache-2.0
#include "core/geometry/meshes/mesh_normals.hpp"

#include <algorithm>
#include <cmath>

namespace thaw {
namespace {

// height over the longest surrounding edge
constexpr double sliver = 0.2;
// longest edge over the longest surrounding edge. Two such triangles may agree by chance.
constexpr double tiny = 0.1;
// cosine of 11 degrees
constexpr double agrees = 0.98;

}  // namespace

MeshNormals::MeshNormals(const TriangleMesh& mesh) : mesh_(mesh) {
  face_.reserve(mesh.triangles.size());
  first_.assign(mesh.vertices.size() + 1, 0);
  for (const auto& t : mesh.triangles) {
    face_.push_back(normalized(
        cross(mesh.vertices[t[1]] - mesh.vertices[t[0]], mesh.vertices[t[2]] - mesh.vertices[t[0]])));
    for (const std::uint32_t v : t) first_[v + 1]++;
  }
  for (std::size_t v = 0; v < mesh.vertices.size(); v++) first_[v + 1] += first_[v];
  around_.resize(3 * mesh.triangles.size());
  std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
  for (std::uint32_t t = 0; t < mesh.triangles.size(); t++)
    for (const std::uint32_t v : mesh.triangles[t]) around_[next[v]++] = t;
  repairSlivers();
}

/// Replaces unreliable normals of slivers. If a sliver's normal differs from that of the triangle across its
/// longest edge, rounding errors dominate it. The mean normal of the triangles around its corners replaces
/// it. On the narrow side of a plate, the two normals agree.
void MeshNormals::repairSlivers() {
  const std::vector<Vec3d> own = face_;
  const TriangleMesh& m = mesh_;
  const auto doubleArea = [&](std::uint32_t u) {
    return cross(m.vertices[m.triangles[u][1]] - m.vertices[m.triangles[u][0]],
                 m.vertices[m.triangles[u][2]] - m.vertices[m.triangles[u][0]]);
  };
  doubtful_.assign(m.triangles.size(), 0);
  for (std::uint32_t u = 0; u < m.triangles.size(); u++) {
    const auto& t = m.triangles[u];
    // longest edge of the triangle and of those around it
    double longest2 = 0, around2 = 0;
    // ends of its longest edge
    std::uint32_t from = 0, to = 0;
    for (const std::uint32_t v : t)
      for (std::uint32_t i = first_[v]; i < first_[v + 1]; i++)
        for (std::size_t k = 0; k < 3; k++) {
          const auto& c = m.triangles[around_[i]];
          const Vec3d d = m.vertices[c[(k + 1) % 3]] - m.vertices[c[k]];
          around2 = std::max(around2, dot(d, d));
          if (around_[i] == u && dot(d, d) > longest2) longest2 = dot(d, d), from = c[k], to = c[(k + 1) % 3];
        }
    const double area = length(doubleArea(u));
    if (area * area > sliver * sliver * longest2 * around2) continue;
    bool agreed = false;
    Vec3d sum;
    for (const std::uint32_t v : t)
      for (std::uint32_t i = first_[v]; i < first_[v + 1]; i++) {
        const std::uint32_t o = around_[i];
        if (o == u) continue;
        sum += doubleArea(o);
        const auto& c = m.triangles[o];
        const bool across = std::find(c.begin(), c.end(), from) != c.end() &&
                            std::find(c.begin(), c.end(), to) != c.end();
        agreed = agreed || (across && dot(own[o], own[u]) > agrees);
      }
    if ((agreed && longest2 > tiny * tiny * around2) || !(dot(sum, sum) > 0)) continue;
    face_[u] = normalized(sum);
    doubtful_[u] = 1;
  }
}

std::array<double, 3> MeshNormals::sharesOf(const Vec3d& x, std::uint32_t triangle) const {
  const auto& t = mesh_.triangles[triangle];
  std::array<double, 3> share{};
  double sum = 0;
  for (std::size_t k = 0; k < 3; k++) {
    const Vec3d &a = mesh_.vertices[t[(k + 1) % 3]], &b = mesh_.vertices[t[(k + 2) % 3]];
    share[k] = length(cross(a - x, b - x));
    sum += share[k];
  }
  for (double& s : share) s = sum > 0 ? s / sum : 1.0 / 3;
  return share;
}

Vec3d MeshNormals::at(const Vec3d& x, std::uint32_t triangle) const {
  const auto& t = mesh_.triangles[triangle];
  const std::array<double, 3> share = sharesOf(x, triangle);
  Vec3d n;
  for (std::size_t k = 0; k < 3; k++) {
    const Vec3d given = mesh_.normals.empty() ? Vec3d{} : mesh_.normals[triangle][k];
    n += share[k] * (dot(given, given) > 0 ? given : cornerNormal(triangle, t[k]));
  }
  n = normalized(n);
  return dot(n, n) > 0 ? n : face_[triangle];
}

Vec3d MeshNormals::cornerNormal(std::uint32_t triangle, std::uint32_t vertex) const {
  const double crease = std::sqrt(0.5);
  const Vec3d here = mesh_.vertices[vertex];
  Vec3d sum;
  for (std::uint32_t i = first_[vertex]; i < first_[vertex + 1]; i++) {
    const std::uint32_t u = around_[i];
    if (doubtful_[u] || dot(face_[u], face_[triangle]) < crease) continue;
    const auto& c = mesh_.triangles[u];
    const std::size_t at = c[0] == vertex ? 0 : c[1] == vertex ? 1 : 2;
    const Vec3d p = normalized(mesh_.vertices[c[(at + 1) % 3]] - here),
                q = normalized(mesh_.vertices[c[(at + 2) % 3]] - here);
    // The weight is the sine of half the angle. It serves as well as the angle, with the same bits on all
    // machines.
    sum += std::sqrt(std::max(0.0, 0.5 - 0.5 * dot(p, q))) * face_[u];
  }
  return dot(sum, sum) > 0 ? normalized(sum) : face_[triangle];
}

std::uint32_t MeshNormals::colourAt(const Vec3d& x, std::uint32_t triangle) const {
  const std::array<double, 3> share = sharesOf(x, triangle);
  std::uint32_t packed = 0;
  for (int part = 0; part < 3; part++) {
    double c = 0;
    for (std::size_t k = 0; k < 3; k++)
      c += share[k] * static_cast<double>(mesh_.colours[mesh_.triangles[triangle][k]] >> 8 * part & 255);
    packed |= static_cast<std::uint32_t>(std::clamp(std::lround(c), 0l, 255l)) << 8 * part;
  }
  return packed;
}

}  // namespace thaw
