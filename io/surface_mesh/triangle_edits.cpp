// SPDX-License-Identifier: Apache-2.0
#include "io/surface_mesh/triangle_edits.hpp"

#include <algorithm>

namespace thaw {

TriangleEdits::TriangleEdits(TriangleMesh& mesh) : mesh_(&mesh), around_(mesh.vertices.size()) {
  for (std::uint32_t t = 0; t < mesh.triangles.size(); t++)
    for (const std::uint32_t v : mesh.triangles[t]) around_[v].push_back(t);
}

void TriangleEdits::neighboursOf(std::uint32_t vertex, std::vector<std::uint32_t>& list) const {
  list.clear();
  for (const std::uint32_t t : around_[vertex]) {
    const Triangle& c = triangle(t);
    list.push_back(c[0] == vertex ? c[1] : c[1] == vertex ? c[2] : c[0]);
  }
}

TriangleEdits::Edge TriangleEdits::edge(std::uint32_t a, std::uint32_t b) const {
  Edge e;
  for (const std::uint32_t t : around_[a]) {
    const Triangle& c = triangle(t);
    const std::size_t k = c[0] == a   ? 0
                          : c[1] == a ? 1
                                      : 2,
                      next = k == 2 ? 0 : k + 1, last = k == 0 ? 2 : k - 1;
    if (c[next] == b) e.first = t, e.left = c[last];
    if (c[last] == b) e.second = t, e.right = c[next];
  }
  return e;
}

bool TriangleEdits::mayCollapse(std::uint32_t from, std::uint32_t to) {
  const Edge e = edge(from, to);
  if (!e.found() || e.left == e.right) return false;
  // A vertex of three triangles would be left with two.
  if (around_[e.left].size() <= 3 || around_[e.right].size() <= 3) return false;
  neighboursOf(from, near_);
  neighboursOf(to, other_);
  std::size_t common = 0;
  for (const std::uint32_t v : near_) common += std::find(other_.begin(), other_.end(), v) != other_.end();
  return common == 2;
}

void TriangleEdits::drop(std::uint32_t vertex, std::uint32_t t) { around_[vertex].erase(t); }

void TriangleEdits::collapse(std::uint32_t from, std::uint32_t to) {
  for (const std::uint32_t t : around_[from]) {
    Triangle& c = mesh_->triangles[t];
    if (std::find(c.begin(), c.end(), to) != c.end()) {
      for (const std::uint32_t v : c)
        if (v != from) drop(v, t);
      c = {removed, removed, removed};
    } else {
      std::replace(c.begin(), c.end(), from, to);
      around_[to].push_back(t);
    }
  }
  around_[from].clear();
}

bool TriangleEdits::mayFlip(std::uint32_t a, std::uint32_t b, const Edge& e) const {
  if (!e.found() || e.left == e.right) return false;
  if (around_[a].size() <= 3 || around_[b].size() <= 3) return false;
  const Edge other = edge(e.left, e.right);
  return other.first == removed && other.second == removed;
}

void TriangleEdits::flip(std::uint32_t a, std::uint32_t b, const Edge& e) {
  mesh_->triangles[e.first] = {e.left, a, e.right};
  mesh_->triangles[e.second] = {e.right, b, e.left};
  drop(b, e.first);
  drop(a, e.second);
  around_[e.right].push_back(e.first);
  around_[e.left].push_back(e.second);
}

std::uint32_t TriangleEdits::neckAt(std::uint32_t a, std::uint32_t b) {
  const Edge e = edge(a, b);
  neighboursOf(a, near_);
  neighboursOf(b, other_);
  for (const std::uint32_t v : near_)
    if (v != b && v != e.left && v != e.right && std::find(other_.begin(), other_.end(), v) != other_.end())
      return v;
  return removed;
}

bool TriangleEdits::sector(std::uint32_t vertex, std::uint32_t first, std::uint32_t last,
                           std::vector<std::uint32_t>& list) const {
  list.clear();
  std::uint32_t at = first;
  while (at != last) {
    const Edge e = edge(vertex, at);
    if (!e.found() || list.size() >= around_[vertex].size()) return false;
    list.push_back(e.first);
    at = e.left;
  }
  return true;
}

bool TriangleEdits::cutNeck(const Triangle& neck) {
  std::array<std::vector<std::uint32_t>, 3> sectors;
  for (std::size_t k = 0; k < 3; k++) {
    const std::uint32_t next = neck[(k + 1) % 3], before = neck[(k + 2) % 3];
    if (!sector(neck[k], next, before, sectors[k]) || sectors[k].size() < 2 ||
        around_[neck[k]].size() - sectors[k].size() < 2)
      return false;
  }
  Triangle copies;
  for (std::size_t k = 0; k < 3; k++) {
    copies[k] = static_cast<std::uint32_t>(mesh_->vertices.size());
    mesh_->vertices.push_back(Vec3d(mesh_->vertices[neck[k]]));
    for (const std::uint32_t t : sectors[k]) {
      Triangle& c = mesh_->triangles[t];
      std::replace(c.begin(), c.end(), neck[k], copies[k]);
      drop(neck[k], t);
    }
    around_.emplace_back();
    for (const std::uint32_t t : sectors[k]) around_.back().push_back(t);
  }
  const auto close = [&](const Triangle& cap) {
    for (const std::uint32_t v : cap)
      around_[v].push_back(static_cast<std::uint32_t>(mesh_->triangles.size()));
    mesh_->triangles.push_back(cap);
  };
  close(neck);
  close({copies[0], copies[2], copies[1]});
  return true;
}

std::vector<std::uint32_t> TriangleEdits::compact() {
  std::erase_if(mesh_->triangles, [](const Triangle& t) { return t[0] == removed; });
  std::vector<std::uint32_t> number(mesh_->vertices.size(), removed), kept;
  for (const Triangle& t : mesh_->triangles)
    for (const std::uint32_t v : t) number[v] = 0;
  for (std::uint32_t v = 0; v < number.size(); v++)
    if (number[v] == 0) {
      number[v] = static_cast<std::uint32_t>(kept.size());
      mesh_->vertices[kept.size()] = mesh_->vertices[v];
      kept.push_back(v);
    }
  mesh_->vertices.resize(kept.size());
  for (Triangle& t : mesh_->triangles)
    for (std::uint32_t& v : t) v = number[v];
  return kept;
}

}  // namespace thaw
