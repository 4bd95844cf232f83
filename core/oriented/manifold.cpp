#include "core/oriented/manifold.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <unordered_set>

#include "core/scene/shape.hpp"

namespace thaw {
namespace {

using Side = std::uint64_t;  // a directed edge
Side sideOf(std::uint32_t from, std::uint32_t to) { return static_cast<Side>(from) << 32 | to; }

/// Directed sides of triangles that are in the surface. Each at most once: that is all a manifold needs along its edges.
struct Sides {
  std::unordered_set<Side> taken;
  bool has(std::uint32_t a, std::uint32_t b) const { return taken.contains(sideOf(a, b)); }
  bool takes(const Corners& t) const { return !has(t[0], t[1]) && !has(t[1], t[2]) && !has(t[2], t[0]); }
  void add(const Corners& t) {
    for (std::size_t k = 0; k < 3; k++) taken.insert(sideOf(t[k], t[(k + 1) % 3]));
  }
};

/// Square of the radius of the circle through the corners, over that of the spacing; 0 for a line.
double roundness(const OrientedPoints& p, const Corners& t) {
  const Vec3d u = p.positions[t[1]] - p.positions[t[0]], v = p.positions[t[2]] - p.positions[t[0]], w = v - u, n = cross(u, v);
  const double area2 = dot(n, n);
  return area2 > 0 ? dot(u, u) * dot(v, v) * dot(w, w) / (4 * area2 * p.spacings[t[0]] * p.spacings[t[0]]) : never;
}

/// Does it face as its particles do?
bool facesAlike(const OrientedPoints& p, const Corners& t) {
  const Vec3d n = cross(p.positions[t[1]] - p.positions[t[0]], p.positions[t[2]] - p.positions[t[0]]);
  return dot(n, p.normals[t[0]] + p.normals[t[1]] + p.normals[t[2]]) > 0;
}

/// Border sides of the surface, seen from the hole: of each particle where they lead. More than one only where the surface meets itself in that particle.
std::map<std::uint32_t, std::vector<std::uint32_t>> bordersOf(const Sides& sides) {
  std::map<std::uint32_t, std::vector<std::uint32_t>> next;
  for (const Side side : sides.taken) {
    const auto from = static_cast<std::uint32_t>(side >> 32), to = static_cast<std::uint32_t>(side);
    if (!sides.has(to, from)) next[to].push_back(from);
  }
  for (auto& [from, list] : next) std::sort(list.begin(), list.end());
  return next;
}

/// Of several ways on from `at`, having come from `from`, the first one clockwise: the hole is to the left.
std::uint32_t wayOn(const OrientedPoints& p, const std::vector<std::uint32_t>& ways, std::uint32_t from, std::uint32_t at) {
  if (ways.size() == 1) return ways[0];
  const Vec3d n = p.normals[at], back = p.positions[from] - p.positions[at], u = back - dot(back, n) * n, v = cross(n, u);
  std::uint32_t best = ways[0];
  double least = never;
  for (const std::uint32_t way : ways) {
    const Vec3d d = p.positions[way] - p.positions[at];
    double turn = -std::atan2(dot(d, v), dot(d, u));  // clockwise
    if (turn <= 0) turn += 6.283185307179586;
    if (turn < least) least = turn, best = way;
  }
  return best;
}

/// Does the hole as a whole face as its particles do? The rim around a small patch does not.
bool facesAlike(const OrientedPoints& p, const std::vector<std::uint32_t>& hole) {
  Vec3d area{}, normal{};
  for (std::size_t k = 0; k < hole.size(); k++) {
    const Vec3d x = p.positions[hole[k]] - p.positions[hole[0]], y = p.positions[hole[(k + 1) % hole.size()]] - p.positions[hole[0]];
    area += cross(x, y);
    normal += p.normals[hole[k]];
  }
  return dot(area, normal) > 0;
}

/// Cuts ears off a hole until nothing is left; facing: only such as face as their particles do. False where a last ear would not do.
bool closeHole(const OrientedPoints& p, std::vector<std::uint32_t> hole, const Sides& sides, bool facing, std::vector<Corners>& made) {
  made.clear();
  Sides fresh;
  while (hole.size() >= 3) {
    double best = never;
    std::size_t ear = hole.size();
    for (std::size_t k = 0; k < hole.size(); k++) {
      const Corners t{hole[k], hole[(k + 1) % hole.size()], hole[(k + 2) % hole.size()]};
      const bool last = hole.size() == 3;
      // its third side must be free on both sides, or, of the last one, be that of the hole
      if ((facing && !facesAlike(p, t)) || !sides.takes(t) || !fresh.takes(t) || (!last && (sides.has(t[0], t[2]) || fresh.has(t[0], t[2])))) continue;
      if (const double r = roundness(p, t); r < best) best = r, ear = k;
    }
    if (ear == hole.size()) return false;
    made.push_back({hole[ear], hole[(ear + 1) % hole.size()], hole[(ear + 2) % hole.size()]});
    fresh.add(made.back());
    if (hole.size() == 3) break;
    hole.erase(hole.begin() + static_cast<std::ptrdiff_t>((ear + 1) % hole.size()));
  }
  return true;
}

}  // namespace

std::vector<Corners> keepManifold(const OrientedPoints& p, std::vector<Corners> triangles) {
  std::vector<double> round;
  for (const Corners& t : triangles) round.push_back(roundness(p, t));
  std::vector<std::uint32_t> order(triangles.size());
  std::iota(order.begin(), order.end(), 0u);
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) { return round[a] != round[b] ? round[a] < round[b] : triangles[a] < triangles[b]; });
  Sides sides;
  std::vector<Corners> kept;
  for (const std::uint32_t k : order) {
    if (!sides.takes(triangles[k])) continue;
    sides.add(triangles[k]);
    kept.push_back(triangles[k]);
  }
  return kept;
}

void fillHoles(const OrientedPoints& p, std::vector<Corners>& triangles, std::size_t mostSides, double longest) {
  Sides sides;
  for (std::size_t k = 0; k < triangles.size(); k++) sides.add(triangles[k]);
  const auto next = bordersOf(sides);
  std::vector<Corners> made;
  for (const auto& [start, ways] : next)
    for (const std::uint32_t first : ways) {
      if (sides.has(start, first)) continue;  // filled by now
      std::vector<std::uint32_t> hole{start};
      bool small = true;
      for (std::uint32_t from = start, at = first; small && at != start;) {
        hole.push_back(at);
        const auto on = next.find(at);
        const double length2 = dot(p.positions[at] - p.positions[from], p.positions[at] - p.positions[from]);
        small = hole.size() <= mostSides && on != next.end() && length2 < longest * longest * p.spacings[at] * p.spacings[at];
        if (!small) break;
        const std::uint32_t then = wayOn(p, on->second, from, at);
        from = at;
        at = then;
      }
      if (!small || hole.size() < 3 || !facesAlike(p, hole)) continue;
      if (!closeHole(p, hole, sides, true, made) && !closeHole(p, hole, sides, false, made)) continue;  // in a sharp fold no ear may face alike
      for (const Corners& t : made) {
        sides.add(t);
        triangles.push_back(t);
      }
    }
}

}  // namespace thaw
