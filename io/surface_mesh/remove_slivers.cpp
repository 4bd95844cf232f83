// SPDX-License-Identifier: Apache-2.0
#include "io/surface_mesh/remove_slivers.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "io/surface_mesh/triangle_angles.hpp"
#include "io/surface_mesh/triangle_edits.hpp"

namespace thaw {
namespace {

constexpr double sliver = 0.3490658503988659;  // rad, 20 degrees
constexpr double sameFace = 0.9;               // cosine between normals before and after a change
constexpr int mostPasses = 8;

using Triangle = TriangleEdits::Triangle;

double angleOf(const TriangleMesh& m, const Triangle& t) {
  return smallestAngle(m.vertices[t[0]], m.vertices[t[1]], m.vertices[t[2]]);
}

Vec3d areaOf(const TriangleMesh& m, const Triangle& t) {
  return cross(m.vertices[t[1]] - m.vertices[t[0]], m.vertices[t[2]] - m.vertices[t[0]]);
}

/// Returns true if a triangle has nearly the normal of another one, or the other one has no area.
bool staysInPlace(const Vec3d& now, const Vec3d& before) {
  const double a = length(now), b = length(before);
  return a > 0 && (!(b > 1e-3 * a) || dot(now, before) > sameFace * a * b);
}

/// Collapses the side from a to b if the triangles around a stay in place, without a smaller angle than now.
bool tryCollapse(TriangleEdits& edits, std::uint32_t from, std::uint32_t to, double worst) {
  if (!edits.mayCollapse(from, to)) return false;
  const TriangleMesh& m = edits.mesh();
  for (const std::uint32_t t : edits.around(from)) {
    const Triangle before = edits.triangle(t);
    if (std::find(before.begin(), before.end(), to) != before.end()) continue;
    Triangle after = before;
    std::replace(after.begin(), after.end(), from, to);
    const bool wasSliver = angleOf(m, before) < sliver;
    if (!(angleOf(m, after) > worst) || (!wasSliver && !staysInPlace(areaOf(m, after), areaOf(m, before))))
      return false;
  }
  edits.collapse(from, to);
  return true;
}

/// Replaces the longest side of a flat triangle by the other diagonal, if the smaller of both angles grows.
bool tryFlip(TriangleEdits& edits, std::uint32_t a, std::uint32_t b) {
  const TriangleEdits::Edge e = edits.edge(a, b);
  if (!e.found() || !edits.mayFlip(a, b, e)) return false;
  const TriangleMesh& m = edits.mesh();
  const Triangle first = edits.triangle(e.first), second = edits.triangle(e.second);
  const Triangle one{a, e.right, e.left}, other{e.right, b, e.left};
  const double now = std::min(angleOf(m, first), angleOf(m, second)),
               then = std::min(angleOf(m, one), angleOf(m, other));
  const Vec3d face = areaOf(m, first) + areaOf(m, second);
  if (!(then > now) || !staysInPlace(areaOf(m, one), face) || !staysInPlace(areaOf(m, other), face))
    return false;
  edits.flip(a, b, e);
  return true;
}

/// Mends a sliver by its shortest side, or else by its longest one.
bool mend(TriangleEdits& edits, std::uint32_t t, const std::vector<std::uint8_t>& onEdge) {
  const TriangleMesh& m = edits.mesh();
  const Triangle corners = edits.triangle(t);
  const double worst = angleOf(m, corners);
  if (!(worst < sliver)) return false;
  std::array<double, 3> side{};
  for (std::size_t k = 0; k < 3; k++)
    side[k] = length(m.vertices[corners[(k + 1) % 3]] - m.vertices[corners[k]]);
  const auto at = [&](auto found) { return static_cast<std::size_t>(found - side.begin()); };
  const std::size_t shortest = at(std::min_element(side.begin(), side.end())),
                    longest = at(std::max_element(side.begin(), side.end()));
  const std::uint32_t a = corners[shortest], b = corners[(shortest + 1) % 3];
  if (onEdge[a] <= onEdge[b] && tryCollapse(edits, a, b, worst)) return true;
  if (onEdge[b] <= onEdge[a] && tryCollapse(edits, b, a, worst)) return true;
  return tryFlip(edits, corners[longest], corners[(longest + 1) % 3]);
}

}  // namespace

void removeSlivers(TriangleMesh& mesh, const std::vector<std::uint8_t>& onEdge) {
  TriangleEdits edits(mesh);
  for (int pass = 0, changes = 1; pass < mostPasses && changes > 0; pass++) {
    changes = 0;
    for (std::uint32_t t = 0; t < mesh.triangles.size(); t++)
      if (edits.exists(t)) changes += mend(edits, t, onEdge);
  }
  edits.compact();
}

}  // namespace thaw
