// SPDX-License-Identifier: Apache-2.0
// Lattices on which the particles of bodies are sampled.
#pragma once
#include <memory>
#include <vector>

#include "core/geometry/sampling/lattice.hpp"
#include "core/scene/scene.hpp"

namespace thaw {

/// Shapes of bodies, by body.
using Shapes = std::vector<std::shared_ptr<const SignedDistance>>;

/// Returns the lattices of bodies, by body. The ids of particles contain the numbers of lattice points.
/// Bodies that remove each other's particles where they overlap (Numerics::overlap) have one lattice, with
/// faces of cells at the faces of their bounding boxes. A solid thus fills the hole that it makes in a
/// liquid, and the pressures on it are in balance.
std::vector<SampleLattice> bodyLattices(const Scene& scene, const Shapes& shapes);

}  // namespace thaw
