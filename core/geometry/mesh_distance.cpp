#include "core/geometry/mesh_distance.hpp"

#include <algorithm>
#include <cmath>

namespace thaw {
namespace {

constexpr int deepestCube = 6;

double distanceToBox(const Bounds& b, const Vec3d& x) {
  Vec3d d;
  for (int a = 0; a < 3; a++) d[a] = std::max(std::max(b.min[a] - x[a], x[a] - b.max[a]), 0.0);
  return length(d);
}

/// The mesh without the triangles that have the solid on both sides, where several shells overlap.
TriangleMesh withoutBuried(const TriangleMesh& m, const TriangleBvh& surface) {
  const Bounds b = surface.bounds();
  const double offset = 1e-6 * length(b.max - b.min);
  TriangleMesh kept{m.vertices, {}};
  for (const auto& t : m.triangles) {
    const Vec3d corners[] = {m.vertices[t[0]], m.vertices[t[1]], m.vertices[t[2]]};
    const Vec3d middle = (corners[0] + corners[1] + corners[2]) / 3.0, normal = normalized(cross(corners[1] - corners[0], corners[2] - corners[0]));
    // Its inner side is inside anyway. Corners are looked at from a little within the triangle, off its neighbours.
    bool buried = true;
    for (const Vec3d& x : {middle, corners[0] + (middle - corners[0]) * 0.05, corners[1] + (middle - corners[1]) * 0.05, corners[2] + (middle - corners[2]) * 0.05})
      buried = buried && surface.winding(x + normal * offset) > 0.5 && surface.winding(x - normal * offset) > 0.5;
    if (!buried) kept.triangles.push_back(t);
  }
  return kept;
}

Vec3d childMiddle(const Vec3d& middle, double half, int child) {
  const double h = 0.5 * half;
  return {middle.x + (child & 1 ? h : -h), middle.y + (child & 2 ? h : -h), middle.z + (child & 4 ? h : -h)};
}

}  // namespace

DistanceOctree::DistanceOctree(const TriangleBvh& near, const TriangleBvh& all) {
  const Bounds b = all.bounds();
  middle_ = 0.5 * (b.min + b.max);
  const Vec3d size = b.max - b.min;
  half_ = 0.51 * std::max({size.x, size.y, size.z});
  const double diagonal = std::sqrt(3.0) * (1 + 1e-9);
  struct Task { std::int32_t cube; Vec3d middle; double half, bound; int depth; };  // bound: a little more than the distance
  std::vector<Task> tasks{{0, middle_, half_, 4 * half_, 0}};
  cubes_.resize(1);
  while (!tasks.empty()) {
    const Task t = tasks.back();
    tasks.pop_back();
    const ClosestPoint closest = near.closest(t.middle, t.bound);
    const double d = std::sqrt(closest.distance2);
    Cube& cube = cubes_[static_cast<std::size_t>(t.cube)];
    cube.clear = d > diagonal * t.half;
    if (cube.clear) cube.distance = all.winding(t.middle) > 0.5 ? -d : d;
    if (cube.clear || t.depth == deepestCube) continue;
    const auto children = static_cast<std::int32_t>(cubes_.size());
    cube.children = children;
    cubes_.resize(cubes_.size() + 8);
    for (int c = 0; c < 8; c++) {
      const Vec3d middle = childMiddle(t.middle, t.half, c);
      tasks.push_back({children + c, middle, 0.5 * t.half, length(middle - closest.point) * (1 + 1e-9) + 1e-9 * t.half, t.depth + 1});  // that point is as near
    }
  }
}

bool DistanceOctree::covers(const Vec3d& x) const {
  return !cubes_.empty() && std::abs(x.x - middle_.x) <= half_ && std::abs(x.y - middle_.y) <= half_ && std::abs(x.z - middle_.z) <= half_;
}

DistanceOctree::Leaf DistanceOctree::leafAt(const Vec3d& x) const {
  Vec3d middle = middle_;
  double half = half_;
  const Cube* cube = &cubes_[0];
  while (cube->children >= 0) {
    const int child = (x.x >= middle.x) | (x.y >= middle.y) << 1 | (x.z >= middle.z) << 2;
    middle = childMiddle(middle, half, child);
    half *= 0.5;
    cube = &cubes_[static_cast<std::size_t>(cube->children + child)];
  }
  return {middle, cube->distance, cube->clear};
}

MeshDistance::MeshDistance(const TriangleMesh& mesh, std::string name) : name_(std::move(name)) {
  const TriangleMesh solid = repairMesh(mesh, report_);
  surface_ = std::make_unique<const TriangleBvh>(solid);
  corners_ = solid.vertices;
  if (report_.closed && report_.shells > 1) {
    TriangleMesh outside = withoutBuried(solid, *surface_);
    if (outside.triangles.size() < solid.triangles.size() && !outside.triangles.empty()) visible_ = std::make_unique<const TriangleBvh>(outside);
  }
  if (report_.closed) octree_ = DistanceOctree(visible(), *surface_);
}

double MeshDistance::signedFrom(const ClosestPoint& c, const Vec3d& x, bool inside, Vec3d* gradient) const {
  const double d = std::sqrt(c.distance2);
  if (gradient) {
    const Vec3d away = x - c.point;
    const Bounds b = surface_->bounds();
    // On the surface the direction to it is noise: the triangle's own normal serves.
    if (d > 1e-9 * length(b.max - b.min)) *gradient = away * ((inside ? -1 : 1) / d);
    else *gradient = dot(c.normal, c.normal) > 0 ? c.normal : Vec3d{0, 0, 1};
  }
  return inside ? -d : d;
}

double MeshDistance::distance(const Vec3d& x, Vec3d* gradient) const { return signedFrom(visible().closest(x), x, inside(x), gradient); }

double MeshDistance::distanceWithin(const Vec3d& x, double reach, Vec3d* gradient) const {
  if (gradient) *gradient = {};
  const double box = distanceToBox(surface_->bounds(), x);
  if (box >= reach) return box;
  bool in = false;
  if (box == 0) {
    const bool covered = octree_.covers(x);
    const DistanceOctree::Leaf leaf = covered ? octree_.leafAt(x) : DistanceOctree::Leaf{};
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
  if (octree_.covers(x)) {
    const DistanceOctree::Leaf leaf = octree_.leafAt(x);
    if (leaf.clear) return leaf.distance < 0;
  }
  return surface_->winding(x) > 0.5;
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
