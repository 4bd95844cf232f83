// SPDX-License-Identifier: Apache-2.0
#include "core/domain/body_lattices.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/geometry/trees/box_tree.hpp"
#include "core/scene/modules.hpp"

namespace thaw {
namespace {

bool isRigid(const Scene& s, const Body& body) {
  return solidAtStart(s, body) && s.materials[static_cast<std::size_t>(body.material)].isRigid();
}

/// Returns the lattice of a body on its own.
SampleLattice ownLattice(const Scene& s, const Body& body, const SignedDistance& shape) {
  const Layers layers = solidAtStart(s, body) ? Layers::Cover : Layers::Fit;
  // Steps in the faces of a liquid box would grow into jets when the liquid is decelerated. Rigid pieces
  // touch at their particles, so faces and edges need particles at a uniform depth.
  return isRigid(s, body) || body.shape.kind == ShapeKind::Box ? turnedLattice(shape, s.spacing, layers)
                                                               : sampleLattice(shape, s.spacing, layers);
}

bool overlap(const Bounds& a, const Bounds& b) {
  for (int k = 0; k < 3; k++)
    if (!(std::min(a.max[k], b.max[k]) > std::max(a.min[k], b.min[k]))) return false;
  return true;
}

/// Sets of bodies: each points to a body of its set, and one of them to itself.
struct Sets {
  std::vector<std::size_t> parent;
  explicit Sets(std::size_t n) : parent(n) { std::iota(parent.begin(), parent.end(), std::size_t{0}); }
  std::size_t of(std::size_t k) {
    while (parent[k] != k) k = parent[k] = parent[parent[k]];
    return k;
  }
  void join(std::size_t a, std::size_t b) {
    a = of(a), b = of(b);
    parent[std::max(a, b)] = std::min(a, b);
  }
};

/// Returns true if cells end at all faces of a box.
bool endsAtFaces(const SampleLattice& l, const Bounds& box) {
  for (int a = 0; a < 3; a++)
    if (std::max(std::abs(l.faces[a].front() - box.min[a]), std::abs(l.faces[a].back() - box.max[a])) >
        1e-6 * l.cell[a])
      return false;
  return true;
}

/// Returns the sets of bodies that can share a lattice and overlap, liquids first.
std::vector<std::vector<std::size_t>> overlappingBodies(const Scene& s,
                                                        const std::vector<SampleLattice>& lattices,
                                                        const std::vector<Bounds>& boxes) {
  const auto shares = [&](std::size_t b) {
    return !lattices[b].turned && s.bodies[b].packing == Packing::Lattice;
  };
  const BoxTree tree(boxes);
  Sets sets(boxes.size());
  for (std::size_t b = 0; b < boxes.size(); b++) {
    if (!shares(b)) continue;
    std::vector<std::size_t> near;
    tree.addIntersecting(boxes[b], near);
    for (const std::size_t other : near)
      if (other < b && shares(other) && overlap(boxes[b], boxes[other])) sets.join(b, other);
  }
  std::vector<std::vector<std::size_t>> found(boxes.size());
  for (const bool solid : {false, true})
    for (std::size_t b = 0; b < boxes.size(); b++)
      if (solidAtStart(s, s.bodies[b]) == solid) found[sets.of(b)].push_back(b);
  std::erase_if(found, [](const std::vector<std::size_t>& set) { return set.size() < 2; });
  return found;
}

}  // namespace

std::vector<SampleLattice> bodyLattices(const Scene& s, const Shapes& shapes) {
  std::vector<SampleLattice> lattices;
  std::vector<Bounds> boxes;
  for (std::size_t b = 0; b < shapes.size(); b++) {
    lattices.push_back(ownLattice(s, s.bodies[b], *shapes[b]));
    boxes.push_back(shapes[b]->bounds());
  }
  const OverlapRule rule = s.numerics.overlap;
  if (rule != OverlapRule::RemoveLater && rule != OverlapRule::RemoveEarlier) return lattices;
  for (const std::vector<std::size_t>& set : overlappingBodies(s, lattices, boxes)) {
    std::vector<Bounds> together;
    for (const std::size_t b : set) together.push_back(boxes[b]);
    const SampleLattice common = commonLattice(together, s.spacing);
    for (const std::size_t b : set) {
      const SampleLattice part = partOf(common, boxes[b]);
      if (!isRigid(s, s.bodies[b]) || endsAtFaces(part, boxes[b])) lattices[b] = part;
    }
  }
  return lattices;
}

}  // namespace thaw
