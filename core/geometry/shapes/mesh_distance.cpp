// SPDX-License-Identifier: Apache-2.0
#include "core/geometry/shapes/mesh_distance.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>

namespace thaw {
namespace {

constexpr int deepestCube = 6;

double distanceToBox(const Bounds& b, const Vec3d& x) {
  Vec3d d;
  for (int a = 0; a < 3; a++) d[a] = std::max(std::max(b.min[a] - x[a], x[a] - b.max[a]), 0.0);
  return length(d);
}

/// Returns the mesh without triangles that have the solid on both sides, because shells overlap there.
TriangleMesh withoutBuried(const TriangleMesh& m, const TriangleBvh& surface) {
  const Bounds b = surface.bounds();
  const double offset = 1e-6 * length(b.max - b.min);
  TriangleMesh kept{m.vertices, {}};
  for (const auto& t : m.triangles) {
    const Vec3d corners[] = {m.vertices[t[0]], m.vertices[t[1]], m.vertices[t[2]]};
    const Vec3d middle = (corners[0] + corners[1] + corners[2]) / 3.0,
                normal = normalized(cross(corners[1] - corners[0], corners[2] - corners[0]));
    // The inner side is always inside the solid. Corners are tested slightly within the triangle, away from
    // adjacent triangles.
    bool buried = true;
    for (const Vec3d& x :
         {middle, corners[0] + (middle - corners[0]) * 0.05, corners[1] + (middle - corners[1]) * 0.05,
          corners[2] + (middle - corners[2]) * 0.05})
      buried = buried && surface.winding(x + normal * offset) > 0.5 &&
               surface.winding(x - normal * offset) > 0.5;
    if (!buried) kept.triangles.push_back(t);
  }
  return kept;
}

Vec3d childMiddle(const Vec3d& middle, double half, int child) {
  const double h = 0.5 * half;
  return {middle.x + (child & 1 ? h : -h), middle.y + (child & 2 ? h : -h), middle.z + (child & 4 ? h : -h)};
}

}  // namespace

struct DistanceOctree::Cube {
  enum State : std::uint8_t { Unknown, Clear, Passed };
  std::atomic<State> state{Unknown};              // written last; the other members are constant from then on
  double distance = 0;                            // m, at the middle; signed if clear
  Vec3d closest{};                                // m, surface point closest to the middle
  std::unique_ptr<std::array<Cube, 8>> children;  // null for the smallest cubes, and for cubes that the
                                                  // surface does not cross
};

DistanceOctree::DistanceOctree(const TriangleBvh& near, const TriangleBvh& all)
    : near_(near), all_(all), root_(std::make_unique<Cube>()) {
  const Bounds b = all.bounds();
  middle_ = 0.5 * (b.min + b.max);
  const Vec3d size = b.max - b.min;
  half_ = 0.51 * std::max({size.x, size.y, size.z});
}

DistanceOctree::~DistanceOctree() = default;

void DistanceOctree::look(Cube& cube, const Vec3d& middle, double half, double bound, int depth) const {
  const std::lock_guard lock(looking_);
  if (cube.state.load(std::memory_order_relaxed) != Cube::Unknown) return;  // another thread has set it
  const ClosestPoint closest = near_.closest(middle, bound);
  cube.closest = closest.point;
  cube.distance = std::sqrt(closest.distance2);
  const bool clear = cube.distance > std::sqrt(3.0) * (1 + 1e-9) * half;
  if (clear && all_.winding(middle) > 0.5) cube.distance = -cube.distance;
  if (!clear && depth < deepestCube) cube.children = std::make_unique<std::array<Cube, 8>>();
  cube.state.store(clear ? Cube::Clear : Cube::Passed, std::memory_order_release);
}

bool DistanceOctree::covers(const Vec3d& x) const {
  return std::abs(x.x - middle_.x) <= half_ && std::abs(x.y - middle_.y) <= half_ &&
         std::abs(x.z - middle_.z) <= half_;
}

DistanceOctree::Leaf DistanceOctree::leafAt(const Vec3d& x) const {
  Vec3d middle = middle_;
  double half = half_, bound = 4 * half_;
  Cube* cube = root_.get();
  for (int depth = 0;; depth++) {
    if (cube->state.load(std::memory_order_acquire) == Cube::Unknown) look(*cube, middle, half, bound, depth);
    if (!cube->children)
      return {middle, cube->distance, cube->state.load(std::memory_order_relaxed) == Cube::Clear};
    const int child = (x.x >= middle.x) | (x.y >= middle.y) << 1 | (x.z >= middle.z) << 2;
    middle = childMiddle(middle, half, child);
    half *= 0.5;
    bound = length(middle - cube->closest) * (1 + 1e-9) + 2e-9 * half;  // the closest point of the parent
                                                                        // bounds the distance
    cube = &(*cube->children)[static_cast<std::size_t>(child)];
  }
}

MeshDistance::MeshDistance(const TriangleMesh& mesh, std::string name) : name_(std::move(name)) {
  const TriangleMesh solid = repairMesh(mesh, report_);
  surface_ = std::make_unique<const TriangleBvh>(solid);
  corners_ = solid.vertices;
  area_ = areaOf(solid);
  if (report_.closed && report_.shells > 1) {
    TriangleMesh outside = withoutBuried(solid, *surface_);
    if (outside.triangles.size() < solid.triangles.size() && !outside.triangles.empty()) {
      visible_ = std::make_unique<const TriangleBvh>(outside);
      area_ = areaOf(outside);
    }
  }
  if (report_.closed) octree_ = std::make_unique<const DistanceOctree>(visible(), *surface_);
}

double MeshDistance::signedFrom(const ClosestPoint& c, const Vec3d& x, bool inside, Vec3d* gradient) const {
  const double d = std::sqrt(c.distance2);
  if (gradient) {
    const Vec3d away = x - c.point;
    const Bounds b = surface_->bounds();
    // On the surface, rounding errors dominate the direction, so the triangle's normal is used.
    if (d > 1e-9 * length(b.max - b.min)) *gradient = away * ((inside ? -1 : 1) / d);
    else *gradient = dot(c.normal, c.normal) > 0 ? c.normal : Vec3d{0, 0, 1};
  }
  return inside ? -d : d;
}

double MeshDistance::distance(const Vec3d& x, Vec3d* gradient) const {
  return signedFrom(visible().closest(x), x, inside(x), gradient);
}

double MeshDistance::distanceWithin(const Vec3d& x, double reach, Vec3d* gradient) const {
  if (gradient) *gradient = {};
  const double box = distanceToBox(surface_->bounds(), x);
  if (box >= reach) return box;
  bool in = false;
  if (box == 0) {
    const DistanceOctree::Leaf leaf = octree_ && octree_->covers(x) ? octree_->leafAt(x)
                                                                    : DistanceOctree::Leaf{};
    if (leaf.clear) {
      const double least = std::abs(leaf.distance) - length(x - leaf.middle);
      in = leaf.distance < 0;
      if (least >= reach) return in ? -least : least;
    } else {
      in = surface_->winding(x) > 0.5;
    }
  }
  const ClosestPoint c = visible().closest(x, reach);
  if (c.distance2 < never) return signedFrom(c, x, in, gradient);
  return in ? -reach : reach;
}

bool MeshDistance::inside(const Vec3d& x) const {
  if (distanceToBox(surface_->bounds(), x) > 0) return false;
  if (octree_ && octree_->covers(x)) {
    const DistanceOctree::Leaf leaf = octree_->leafAt(x);
    if (leaf.clear) return leaf.distance < 0;
  }
  return surface_->winding(x) > 0.5;
}

/// The sign changes only across a triangle. Two points have the same sign if no triangle touches their
/// bounding box. Bisection finds the change. A known point of the previous line mostly gives the sign of a
/// stretch without triangles.
void MeshDistance::insideAlong(std::span<const Vec3d> points, std::span<std::uint8_t> in,
                               KnownSides& known) const {
  if (!report_.closed) return SignedDistance::insideAlong(points, in, known);
  const std::size_t n = points.size();
  const Bounds b = surface_->bounds();
  const double margin = 1e-9 * length(b.max - b.min);
  const auto divided = [&](const Vec3d& from, const Vec3d& to) {
    Bounds box;
    for (int a = 0; a < 3; a++)
      box.min[a] = std::min(from[a], to[a]) - margin, box.max[a] = std::max(from[a], to[a]) + margin;
    return surface_->meets(box);
  };
  const auto sideOf = [&](const Vec3d& x) {
    if (distanceToBox(b, x) > 0) return false;
    const KnownSides::Place* nearest = nullptr;
    const auto away2 = [&](const KnownSides::Place& p) { return dot(p.x - x, p.x - x); };
    for (std::size_t k = 0; k < std::min(known.count, known.place.size()); k++)
      if (!nearest || away2(known.place[k]) < away2(*nearest)) nearest = &known.place[k];
    return nearest && !divided(nearest->x, x) ? nearest->in : surface_->winding(x) > 0.5;
  };
  for (std::size_t k = 0; k < n;) {
    std::size_t same = k, other = n - 1;  // last point of equal sign; point with a triangle in between
    if (!divided(points[k], points[other])) same = other;
    while (other - same > 1) {
      const std::size_t middle = same + (other - same) / 2;
      (divided(points[same], points[middle]) ? other : same) = middle;
    }
    bool here = false;
    if (same > k) {
      const Vec3d& middle = points[k + (same - k) / 2];
      here = sideOf(middle);
      known.note(middle, here);
    } else {  // the point may lie on a triangle
      here = sideOf(points[k]) && visible().closest(points[k], margin).distance2 > 0;
    }
    for (; k <= same; k++) in[k] = here;
  }
}

double MeshDistance::extent(const Vec3d& direction) const {
  double e = -never;
  for (const Vec3d& v : corners_) e = std::max(e, dot(direction, v));
  return e;
}

void MeshDistance::addNotes(std::vector<std::string>& notes) const {
  const std::string s = describeRepairs(name_, report_);
  if (!s.empty()) notes.push_back(s);
}

}  // namespace thaw
