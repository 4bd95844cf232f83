// The vertex update: one linear map of place and velocity for all vertices of a law, as fast as memory gives
// and takes them.
#pragma once
#include <cstdint>
#include <span>

#include "core/math/vec3.hpp"
#include "core/sheet/exact_step.hpp"

namespace thaw {

/// A law over a step, as the update wants it.
struct VertexMap {
  double hold, keep, yield, push;  ///< ExactStep
  double stiffness;                ///< N/m^3
  double before, after;            ///< SplitPush
};
VertexMap vertexMap(const SpringLaw& law, double dt);

struct VertexArrays {
  Vec3d* position;
  Vec3d* velocity;
  const Vec3d* rest;         ///< of the spring, plastic flow included
  const Vec3d* load;         ///< N/m^2
  const std::uint16_t* law;  ///< index into maps; may be null where there is one map
};

/// Place of all, and velocity but for `after` times the load after the step: x += hold v + yield r, v = keep
/// v - push K z + before f, where z = x - rest, r = f - K z. Each vertex by itself: any order, any bits of a
/// vector unit give the same.
void moveVertices(std::span<const VertexMap> maps, const VertexArrays& a, std::size_t begin, std::size_t end);

}  // namespace thaw
