// SPDX-License-Identifier: Apache-2.0
#include "core/rigid/surface_elements.hpp"

#include <cmath>
#include <vector>

#include "core/neighbours/rows_around.hpp"
#include "core/rigid/contact/edge_code.hpp"
#include "core/rigid/contact/surface_element.hpp"

namespace thaw {
namespace {

constexpr double elementNeighbours = 1.8;  // spacings

void setElement(Continuum& p, std::size_t i, const SurfaceElement& e) {
  p.faceNormal[i] = e.normal;
  p.faceOffset[i] = e.offset;
  p.faceRadius[i] = e.radius;
}

/// Particles of a piece around one of its particles, before and after a change.
struct Surroundings {
  std::vector<Vec3d> now;  ///< m, relative positions
  bool changed = false;
};

void look(const RigidView& v, std::size_t i, std::span<const RowSpan> ranges, Surroundings& s) {
  const Continuum& p = v.particles;
  const double reach = elementNeighbours * v.scene.spacing;
  s.now.clear();
  s.changed = p.piece[i] == notRigid;
  for (const RowSpan& r : ranges)
    for (std::uint32_t j = r.begin; j < r.end; j++) {
      if (j == i) continue;
      const Vec3d to = p.position[j] - p.position[i];
      if (dot(to, to) > reach * reach) continue;
      const bool before = p.piece[j] != notRigid && p.piece[j] == p.piece[i],
                 after = p.setLabel[j] != notRigid && p.setLabel[j] == p.setLabel[i];
      s.changed = s.changed || before != after;
      if (after) s.now.push_back(to);
    }
}

/// Returns the periodic image of x (m) that is nearest to the centre of a shape.
Vec3d imageIn(const SignedDistance& shape, const Domain& d, Vec3d x) {
  const auto box = shape.bounds();
  for (int a = 0; a < 3; a++) {
    const double period = d.max[a] - d.min[a], middle = 0.5 * (box.min[a] + box.max[a]);
    if (d.side[a][0] == Side::Periodic && std::isfinite(middle))
      x[a] -= period * std::round((x[a] - middle) / period);
  }
  return x;
}

}  // namespace

void elementsOfShapes(const Scene& scene, std::span<const std::shared_ptr<const SignedDistance>> bodyShapes,
                      Continuum& p) {
  for (std::size_t i = 0; i < p.owned; i++)
    if (p.piece[i] != notRigid && p.body[i] < bodyShapes.size())
      setElement(p, i,
                 elementOfShape(*bodyShapes[p.body[i]],
                                imageIn(*bodyShapes[p.body[i]], scene.domain, p.position[i]), scene.spacing));
}

void turnElement(Continuum& p, std::size_t i, const Quat& rotation) {
  setElement(p, i, turned({p.faceNormal[i], p.faceOffset[i], p.faceRadius[i]}, rotation));
}

void renewElements(const RigidView& v) {
  Continuum& p = v.particles;
  Surroundings around;
  eachSurrounded(
      v.cells, p.owned, v.cells, [&](std::uint32_t i) { return p.setLabel[i] != notRigid; },
      [&](std::uint32_t i, std::span<const RowSpan> ranges) {
        look(v, i, ranges, around);
        if (!around.changed) return;
        setElement(p, i, elementOfNeighbours(around.now, v.scene.spacing));
        if (p.exposed.active) p.exposed[i] = 1;
      });
}

}  // namespace thaw
