// SPDX-License-Identifier: Apache-2.0
// Vertex update: one linear map of position and velocity for all vertices of a law. Memory bandwidth limits
// its speed.
#pragma once
#include <cstdint>
#include <span>

#include "core/math/vec3.hpp"
#include "core/sheet/data/exact_step.hpp"

namespace thaw {

/// Coefficients of a law for one step.
struct VertexMap {
  double qv, vv, qr, vr;  ///< ExactStep
  double stiffness;       ///< N/m^3
  double before, after;   ///< SplitForce
};
VertexMap vertexMap(const SpringLaw& law, double dt);

struct VertexArrays {
  Vec3d* position;
  Vec3d* velocity;
  const Vec3d* rest;         ///< rest position of the spring, plastic flow included
  const Vec3d* load;         ///< N/m^2
  const std::uint16_t* law;  ///< index into maps; may be null with one map
};

/// Updates positions, and velocities except for the load after the step. With z = x - rest and r = f - K z: x
/// += qv v + qr r, v = vv v - vr K z + before f. Vertices are independent, so order and vectorisation do not
/// change bits.
void moveVertices(std::span<const VertexMap> maps, const VertexArrays& a, std::size_t begin, std::size_t end);

}  // namespace thaw
