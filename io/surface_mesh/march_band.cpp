// SPDX-License-Identifier: Apache-2.0
#include "io/surface_mesh/march_band.hpp"

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "core/geometry/marching/cube_triangles.hpp"
#include "core/math/disjoint_sets.hpp"
#include "core/math/hash_random.hpp"

namespace thaw {

namespace {

using Corner = BandGrid::Corner;

struct KeyHash {
  std::size_t operator()(std::uint64_t key) const { return mixBits(key); }
};

/// Marches the cubes that have a corner with a value, and those at a cut.
struct BandMarcher {
  const BandGrid& grid;
  const BandHeights& heights;
  const PlaneField& planes;
  const Vec3f deep;
  const bool projectedLater;
  MarchedBand out;
  std::unordered_map<std::uint64_t, std::uint32_t, KeyHash> onEdge;

  static Corner cornerOf(const Corner& low, int c) {
    return {low[0] + (c & 1), low[1] + (c >> 1 & 1), low[2] + (c >> 2)};
  }

  /// Edge of a cube from p, and the values at its ends.
  struct EdgeValues {
    Vec3d p, along;
    double from, to;
    double linear() const { return crossing(from, to); }
  };

  /// Returns the surface between two corners, interpolated. It is unknown if a corner has no slot, or normals
  /// disagree.
  PlaneHeight between(const Corner& a, const Corner& b, float t) const {
    const std::int32_t i = grid.at(a), j = grid.at(b);
    if (i < 0 || j < 0) return {};
    const std::size_t from = static_cast<std::size_t>(i), to = static_cast<std::size_t>(j);
    if (!(dot(heights.normals[from], heights.normals[to]) > 0)) return {};
    return {0, mixed(heights.normals[from], heights.normals[to], t),
            mixed(heights.colours[from], heights.colours[to], t), true};
  }
  static Vec3f mixed(const Vec3f& a, const Vec3f& b, float t) { return (1 - t) * a + t * b; }

  /// Returns the crossing of the surface along an edge, 0 to 1, and the surface near it, if that is not known
  /// yet. It iterates, since values are not linear where the surface is curved.
  double zeroOn(const EdgeValues& edge, int iterations, PlaneHeight& here) {
    const Vec3d &p = edge.p, &along = edge.along;
    double from = edge.from, to = edge.to, low = 0, high = 1, t = edge.linear();
    for (int k = 0; k < iterations; k++) {
      here = planes.at(p + t * along);
      if (!here.known) break;
      if ((here.value < 0) == (from < 0)) low = t, from = here.value;
      else high = t, to = here.value;
      t = awayFromCorners(low + (high - low) * (from != to ? from / (from - to) : 0.5));
    }
    if (!here.known) here = planes.at(p);  // one of the ends has surfels in reach
    if (!here.known) here = planes.at(p + along);
    return t;
  }

  std::pair<std::uint32_t, bool> numberOf(const Corner& c, int what) {
    const auto [place, fresh] = onEdge.try_emplace(grid.key(c) * 8 + static_cast<std::uint64_t>(what),
                                                   static_cast<std::uint32_t>(out.mesh.mesh.vertices.size()));
    return {place->second, fresh};
  }

  void add(const Vec3d& x, const Vec3f& normal, const Vec3f& colour, int fixedAxes) {
    out.mesh.mesh.vertices.push_back(x);
    const float l = std::sqrt(dot(normal, normal));
    out.mesh.normals.push_back(l > 0 ? normal / l : Vec3f{0, 0, 1});
    out.mesh.colours.push_back(colour);
    out.fixedAxes.push_back(static_cast<std::uint8_t>(fixedAxes));
  }

  /// Returns the vertex of a cap at an inside corner, the same for all edges that lead beyond the cut.
  std::uint32_t onCap(const Corner& c) {
    const auto [number, fresh] = numberOf(c, 7);
    if (!fresh) return number;
    const int cuts = grid.onCut(c);
    Vec3f normal{};
    for (int a = 0; a < 3; a++)
      if (cuts >> a & 1) normal[a] = c[static_cast<std::size_t>(a)] == 1 ? -1.0f : 1.0f;
    const PlaneHeight here = planes.at(grid.place(c));
    add(grid.place(c), normal, here.known ? here.colour : deep, cuts | MarchedBand::onCap);
    return number;
  }

  std::uint32_t vertex(const Corner& low, const double (&value)[8], const AxisEdge& e) {
    const Corner from = cornerOf(low, e.from), to = cornerOf(low, e.to());
    if (grid.beyond(to)) return onCap(from);
    if (grid.beyond(from)) return onCap(to);
    const auto [number, fresh] = numberOf(from, e.axis);
    if (!fresh) return number;
    const Vec3d p = grid.place(from), along = grid.place(to) - p;
    PlaneHeight here;
    const int fixedAxes = grid.onCut(from) & grid.onCut(to);
    const EdgeValues edge{p, along, value[e.from], value[e.to()]};
    if (projectedLater && fixedAxes == 0) here = between(from, to, static_cast<float>(edge.linear()));
    const double t = zeroOn(edge, fixedAxes != 0 ? 3 : here.known ? 0 : 1, here);
    add(p + t * along, here.normal, here.colour, fixedAxes);
    return number;
  }

  double valueOf(std::int32_t slot) const {
    return slot >= 0                  ? heights.values[static_cast<std::size_t>(slot)]
           : slot == BandGrid::inside ? -grid.spacing()
                                      : grid.spacing();
  }

  /// own: corner with the first slot of the cube, so that each cube is marched once. 8: cube without slots.
  void marchCubeOf(const Corner& low, int own) {
    double value[8];
    for (int c = 0; c < 8; c++) {
      const std::int32_t slot = grid.at(cornerOf(low, c));
      if (slot >= 0 && c < own) return;
      value[c] = valueOf(slot);
    }
    const auto vertexOn = [&](const AxisEdge& e) { return vertex(low, value, e); };
    marchCube(value, vertexOn, out.mesh.mesh.triangles);  // triangles along a cut are left out
  }

  /// Cubes beyond a cut, where the inside may be far from all surfels.
  void marchCaps() {
    for (std::size_t axis = 0; axis < 3; axis++) {
      if (!grid.cut(static_cast<int>(axis))) continue;
      const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
      const auto isCap = [&](const Corner& c, std::size_t a) {
        return grid.cut(static_cast<int>(a)) && (c[a] == 0 || c[a] == grid.count()[a] - 2);
      };
      for (const std::int64_t layer : {std::int64_t{0}, grid.count()[axis] - 2})
        for (std::int64_t j = 0; j + 1 < grid.count()[v]; j++)
          for (std::int64_t i = 0; i + 1 < grid.count()[u]; i++) {
            Corner low;
            low[axis] = layer, low[u] = i, low[v] = j;
            bool before = false;  // marched for another axis
            for (std::size_t a = 0; a < axis; a++) before = before || isCap(low, a);
            if (!before) marchCubeOf(low, 8);
          }
    }
  }

  void march() {
    for (std::size_t s = 0; s < grid.slots(); s++)
      for (int c = 0; c < 8; c++) {
        const Corner& at = grid.corner(s);
        marchCubeOf({at[0] - (c & 1), at[1] - (c >> 1 & 1), at[2] - (c >> 2)}, c);
      }
    marchCaps();
  }
};

}  // namespace

MarchedBand marchBand(const BandGrid& grid, const BandHeights& heights, const PlaneField& planes,
                      const Vec3f& deep, bool projectedLater) {
  BandMarcher marcher{grid, heights, planes, deep, projectedLater, {}, {}};
  marcher.onEdge.reserve(grid.slots());
  marcher.march();
  return std::move(marcher.out);
}

void removeFragments(MarchedBand& band, const PlaneField& planes, double spacing) {
  ComponentMesh& m = band.mesh;
  TriangleMesh& mesh = m.mesh;
  DisjointSets sets(mesh.vertices.size());
  for (const auto& t : mesh.triangles) sets.join(t[0], t[1]), sets.join(t[1], t[2]);
  std::vector<double> volume(mesh.vertices.size(), 0.0);  // signed volume of the shell, at its root vertex
  const Vec3d from = mesh.vertices.empty() ? Vec3d{} : mesh.vertices[0];
  for (const auto& t : mesh.triangles)
    volume[sets.find(t[0])] += dot(mesh.vertices[t[0]] - from,
                                   cross(mesh.vertices[t[1]] - from, mesh.vertices[t[2]] - from)) /
                               6;
  double largest = 0;
  for (const double v : volume) largest = std::max(largest, std::abs(v));
  const auto isLargest = [&](std::uint32_t shell) { return !(std::abs(volume[shell]) < largest); };
  std::vector<std::uint8_t> onDisc(volume.size());  // the largest shell is kept without it
  for (std::uint32_t v = 0; v < onDisc.size(); v++)
    if (!isLargest(sets.find(v))) onDisc[v] = planes.onDisc(mesh.vertices[v], m.normals[v]);
  std::vector<double> area(volume.size(), 0.0), onDiscs(volume.size(), 0.0);
  for (const auto& t : mesh.triangles) {
    if (band.fixedAxes[t[0]] & band.fixedAxes[t[1]] & band.fixedAxes[t[2]]) continue;  // on a cut
    const std::uint32_t shell = sets.find(t[0]);
    const double size = length(
        cross(mesh.vertices[t[1]] - mesh.vertices[t[0]], mesh.vertices[t[2]] - mesh.vertices[t[0]]));
    area[shell] += 3 * size;
    for (const std::uint32_t v : t)
      if (onDisc[v]) onDiscs[shell] += size;
  }
  const double least = std::min(largest, 2 * spacing * spacing * spacing);
  const auto isFragment = [&](std::uint32_t v) {
    const std::uint32_t shell = sets.find(v);
    return std::abs(volume[shell]) < least || (!isLargest(shell) && onDiscs[shell] < 0.5 * area[shell]);
  };
  std::vector<std::uint32_t> number(mesh.vertices.size());
  std::uint32_t kept = 0;
  for (std::uint32_t v = 0; v < number.size(); v++) {
    if (isFragment(v)) continue;
    mesh.vertices[kept] = mesh.vertices[v], m.colours[kept] = m.colours[v], m.normals[kept] = m.normals[v],
    band.fixedAxes[kept] = band.fixedAxes[v];
    number[v] = kept++;
  }
  std::erase_if(mesh.triangles, [&](const auto& t) { return isFragment(t[0]); });
  for (auto& t : mesh.triangles)
    for (std::uint32_t& v : t) v = number[v];
  mesh.vertices.resize(kept), m.colours.resize(kept), m.normals.resize(kept), band.fixedAxes.resize(kept);
}

}  // namespace thaw
