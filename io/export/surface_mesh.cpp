#include "io/export/surface_mesh.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <unordered_map>

#include "core/geometry/marching_tetrahedra.hpp"
#include "core/geometry/mesh_edges.hpp"
#include "core/math/hash_random.hpp"
#include "io/export/band_grid.hpp"
#include "io/export/plane_field.hpp"
#include "io/export/straddle.hpp"

namespace thaw {

namespace {

using Corner = BandGrid::Corner;

/// Cubes of a component are no longer than this share of its size: drops of a few surfels are round.
constexpr double mostOfSize = 0.15;

/// Surfels that make a mesh.
struct Patch {
  const SurfaceFrame& frame;
  std::vector<std::uint32_t> rows;  // finite ones
  const std::vector<Rgb>& colours;
  Vec3d low{1e300, 1e300, 1e300}, high{-1e300, -1e300, -1e300};
  double radius = 0;                // m, mean
};

/// What a corner of the grid knows: its nearest surfel, and weighted sums over those around.
struct Field {
  std::vector<float> nearest2;      // m^2
  std::vector<std::uint32_t> nearest;
  std::vector<float> weight, value;
  std::vector<Vec3f> offset, normal, colour;
};

bool usable(const SurfaceFrame& f, std::size_t i) {
  const Vec3d& x = f.positions[i];
  const Vec3f& n = f.normals[i];
  return std::isfinite(x.x) && std::isfinite(x.y) && std::isfinite(x.z) && std::isfinite(n.x) && std::isfinite(n.y) && std::isfinite(n.z) && dot(n, n) > 0 &&
         std::isfinite(f.radii[i]) && f.radii[i] > 0;
}

double reachOf(const Patch& p, std::uint32_t i, double spacing) { return planeReach * p.frame.radii[i] + spacing; }

BandGrid gridAround(const Patch& p, double spacing) {
  double reach = 0;
  for (const std::uint32_t i : p.rows) reach = std::max(reach, reachOf(p, i, spacing));
  // Two cubes beyond all that surfels reach: the border is outside.
  const Vec3d margin{reach + 2 * spacing, reach + 2 * spacing, reach + 2 * spacing}, origin = p.low - margin;
  Corner count;
  double blocks = 1;
  for (int a = 0; a < 3; a++) {
    const double n = std::ceil((p.high[a] + margin[a] - origin[a]) / spacing) + 1;
    blocks *= std::ceil(n / BandGrid::side);
    if (!(n < 1e6) || !(blocks < 1e9)) throw std::runtime_error("a component is too far spread for a mesh at the spacing of its surfels: remove surfels that flew away, or raise --cell");
    count[a] = static_cast<std::int64_t>(n);
  }
  return BandGrid(origin, spacing, count);
}

void findNearest(const Patch& p, BandGrid& grid, Field& field) {
  for (const std::uint32_t i : p.rows) {
    const Vec3d& x = p.frame.positions[i];
    grid.forCornersNear(x, reachOf(p, i, grid.spacing()), [&](const Corner& c) {
      const std::size_t slot = static_cast<std::size_t>(grid.makeSlot(c));
      if (slot == field.nearest.size()) {
        field.nearest.push_back(i);
        field.nearest2.push_back(std::numeric_limits<float>::infinity());
      }
      const Vec3d d = grid.place(c) - x;
      const float d2 = static_cast<float>(dot(d, d));
      if (d2 < field.nearest2[slot]) field.nearest2[slot] = d2, field.nearest[slot] = i;
    });
  }
}

void addPlanes(const Patch& p, const BandGrid& grid, Field& field) {
  const std::size_t slots = grid.slots();
  field.weight.assign(slots, 0);
  field.value.assign(slots, 0);
  field.offset.assign(slots, {});
  field.normal.assign(slots, {});
  field.colour.assign(slots, {});
  for (const std::uint32_t i : p.rows) {
    const Vec3d& x = p.frame.positions[i];
    const Vec3f& n = p.frame.normals[i];
    const Vec3f colour{static_cast<float>(p.colours[i].r), static_cast<float>(p.colours[i].g), static_cast<float>(p.colours[i].b)};
    const float over = static_cast<float>(0.5 / (planeSharpness * planeSharpness * p.frame.radii[i] * p.frame.radii[i]));
    grid.forCornersNear(x, reachOf(p, i, grid.spacing()), [&](const Corner& c) {
      const std::size_t slot = static_cast<std::size_t>(grid.at(c));
      if (dot(n, p.frame.normals[field.nearest[slot]]) < planeAgreement) return;
      const Vec3d d = grid.place(c) - x;
      // Relative to the nearest one: far from the surface the weights do not vanish.
      const float w = std::exp(std::max(-60.0f, (field.nearest2[slot] - static_cast<float>(dot(d, d))) * over));
      field.weight[slot] += w;
      const Vec3f away{static_cast<float>(d.x), static_cast<float>(d.y), static_cast<float>(d.z)};
      field.value[slot] += w * dot(away, n);
      field.offset[slot] += w * away;
      field.normal[slot] += w * n;
      field.colour[slot] += w * colour;
    });
  }
  for (std::size_t s = 0; s < slots; s++) {
    const float over = 1 / field.weight[s];  // the nearest one agrees with itself: 1 at least
    const float l = std::sqrt(dot(field.normal[s], field.normal[s]));
    const float along = l > 0 ? dot(field.normal[s], field.offset[s]) / l : field.value[s];
    field.value[s] = 0.5f * over * (field.value[s] + along);
    field.colour[s] = over * field.colour[s];
  }
}

struct KeyHash { std::size_t operator()(std::uint64_t key) const { return mixBits(key); } };

/// Marches the cubes that have a corner with a value.
struct BandMarcher {
  const BandGrid& grid;
  const Field& field;
  const PlaneField& planes;
  ComponentMesh out;
  std::unordered_map<std::uint64_t, std::uint32_t, KeyHash> onEdge;

  static Corner cornerOf(const Corner& low, int c) { return {low[0] + (c & 1), low[1] + (c >> 1 & 1), low[2] + (c >> 2)}; }

  /// Where the surface crosses an edge, as a share of it: the values at its ends are far from straight lines where the surface is curved.
  double zeroOn(const Vec3d& p, const Vec3d& along, double from, double to, PlaneHeight& here) {
    double low = 0, high = 1, t = crossing(from, to);
    for (int k = 0; k < 3; k++) {
      here = planes.at(p + t * along);
      if (!here.known) break;
      if ((here.value < 0) == (from < 0)) low = t, from = here.value;
      else high = t, to = here.value;
      t = std::clamp(low + (high - low) * (from != to ? from / (from - to) : 0.5), nearestToCorner, 1 - nearestToCorner);
    }
    return t;
  }

  std::uint32_t vertex(const Corner& low, const std::int32_t (&slot)[8], const double (&value)[8], const CubeEdge& e) {
    const Corner from = cornerOf(low, e.from);
    const auto [place, fresh] = onEdge.try_emplace(grid.key(from) * 7 + static_cast<std::uint64_t>(e.direction()), static_cast<std::uint32_t>(out.mesh.vertices.size()));
    if (!fresh) return place->second;
    const Vec3d p = grid.place(from), along = grid.place(cornerOf(low, e.to)) - p;
    PlaneHeight here;
    const double t = zeroOn(p, along, value[e.from], value[e.to], here);
    out.mesh.vertices.push_back(p + t * along);
    // Of an end without a value the other's counts; one of them has one.
    const std::int32_t a = slot[e.from] >= 0 ? slot[e.from] : slot[e.to], b = slot[e.to] >= 0 ? slot[e.to] : a;
    const float u = static_cast<float>(t);
    const auto between = [&](const std::vector<Vec3f>& of) { return (1 - u) * of[static_cast<std::size_t>(a)] + u * of[static_cast<std::size_t>(b)]; };
    const Vec3f n = here.known ? here.normal : between(field.normal);
    const float l = std::sqrt(dot(n, n));
    out.normals.push_back(l > 0 ? n / l : Vec3f{0, 0, 1});
    out.colours.push_back(between(field.colour));
    return place->second;
  }

  void marchCube(const Corner& low, std::int32_t own) {
    std::int32_t slot[8];
    double value[8];
    int inside = 0, first = -1;
    for (int c = 0; c < 8; c++) {
      slot[c] = grid.at(cornerOf(low, c));
      if (slot[c] >= 0 && first < 0) first = slot[c];
      value[c] = slot[c] >= 0 ? field.value[static_cast<std::size_t>(slot[c])] : slot[c] == BandGrid::inside ? -grid.spacing() : grid.spacing();
      inside += value[c] < 0;
    }
    if (first != own || inside == 0 || inside == 8) return;  // a cube is looked at from each of its corners with a slot
    marchTetrahedra(value, [&](const CubeEdge& e, const CubeEdge& f, const CubeEdge& g, const Vec3d& outward) {
      std::uint32_t a = vertex(low, slot, value, e), b = vertex(low, slot, value, f), c = vertex(low, slot, value, g);
      const auto& v = out.mesh.vertices;
      if (dot(cross(v[b] - v[a], v[c] - v[a]), outward) < 0) std::swap(b, c);
      out.mesh.triangles.push_back({a, b, c});
    });
  }

  void march() {
    for (std::size_t s = 0; s < grid.slots(); s++)
      for (int c = 0; c < 8; c++) {
        const Corner& at = grid.corner(s);
        marchCube({at[0] - (c & 1), at[1] - (c >> 1 & 1), at[2] - (c >> 2)}, static_cast<std::int32_t>(s));
      }
  }
};

/// Leaves out closed shells of less than two cubes' volume beside a larger one: at sharp edges nearest surfels may disagree for a corner or two.
void dropCrumbs(ComponentMesh& m, double spacing) {
  TriangleMesh& mesh = m.mesh;
  DisjointSets sets(mesh.vertices.size());
  for (const auto& t : mesh.triangles) sets.join(t[0], t[1]), sets.join(t[1], t[2]);
  std::vector<double> volume(mesh.vertices.size(), 0.0);  // of the shell whose smallest vertex it is
  const Vec3d from = mesh.vertices.empty() ? Vec3d{} : mesh.vertices[0];
  for (const auto& t : mesh.triangles)
    volume[sets.find(t[0])] += dot(mesh.vertices[t[0]] - from, cross(mesh.vertices[t[1]] - from, mesh.vertices[t[2]] - from)) / 6;
  double largest = 0;
  for (const double v : volume) largest = std::max(largest, std::abs(v));
  const double least = std::min(largest, 2 * spacing * spacing * spacing);
  std::vector<std::uint32_t> number(mesh.vertices.size());
  std::uint32_t kept = 0;
  for (std::uint32_t v = 0; v < number.size(); v++) {
    if (std::abs(volume[sets.find(v)]) < least) continue;
    mesh.vertices[kept] = mesh.vertices[v], m.colours[kept] = m.colours[v], m.normals[kept] = m.normals[v];
    number[v] = kept++;
  }
  std::erase_if(mesh.triangles, [&](const auto& t) { return std::abs(volume[sets.find(t[0])]) < least; });
  for (auto& t : mesh.triangles)
    for (std::uint32_t& v : t) v = number[v];
  mesh.vertices.resize(kept), m.colours.resize(kept), m.normals.resize(kept);
}

ComponentMesh meshAt(const Patch& p, double spacing) {
  BandGrid grid = gridAround(p, spacing);
  Field field;
  findNearest(p, grid, field);
  addPlanes(p, grid, field);
  std::vector<std::uint8_t> isInside(grid.slots());
  for (std::size_t s = 0; s < isInside.size(); s++) isInside[s] = field.value[s] < 0;
  grid.settle(isInside);
  const PlaneField planes(p.frame, p.rows, spacing);
  BandMarcher marcher{grid, field, planes, {}, {}};
  marcher.march();
  dropCrumbs(marcher.out, spacing);
  straddle(marcher.out, 0.1 * spacing);
  return std::move(marcher.out);
}

}  // namespace

std::vector<ComponentRows> rowsByComponent(const SurfaceFrame& frame) {
  std::vector<std::uint32_t> order(frame.positions.size());
  std::iota(order.begin(), order.end(), 0u);
  std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) { return frame.components[a] < frame.components[b]; });
  std::vector<ComponentRows> all;
  for (const std::uint32_t i : order) {
    if (all.empty() || all.back().component != frame.components[i]) all.push_back({frame.components[i], {}});
    all.back().rows.push_back(i);
  }
  return all;
}

ComponentMesh meshOfComponent(const SurfaceFrame& frame, const ComponentRows& component, const std::vector<Rgb>& colours, double cell) {
  Patch p{frame, {}, colours};
  for (const std::uint32_t i : component.rows) {
    if (!usable(frame, i)) continue;
    p.rows.push_back(i);
    p.radius += frame.radii[i];
    for (int a = 0; a < 3; a++) p.low[a] = std::min(p.low[a], frame.positions[i][a]), p.high[a] = std::max(p.high[a], frame.positions[i][a]);
  }
  ComponentMesh mesh;
  if (!p.rows.empty()) {
    p.radius /= static_cast<double>(p.rows.size());
    const Vec3d size = p.high - p.low;
    const double largest = std::max({size.x, size.y, size.z});
    double spacing = std::min(cell * p.radius, mostOfSize * largest);
    for (int n = 0; n < 4 && spacing > 0.01 * p.radius && mesh.mesh.triangles.empty(); n++, spacing *= 0.5) mesh = meshAt(p, spacing);
  }
  mesh.component = component.component;
  return mesh;
}

}  // namespace thaw
