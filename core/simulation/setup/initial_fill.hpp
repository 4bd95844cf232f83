// SPDX-License-Identifier: Apache-2.0
// Initial fill of particles by their body, for the colour field of the surface.
#pragma once
#include <span>

#include "core/particles/continuum.hpp"
#include "core/scene/scene.hpp"

namespace thaw {

/// Returns true if the surface of body b is grown from particles cut from a lattice. Its particles then have
/// Continuum::initialFill.
bool hasInitialFill(const Scene& scene, std::size_t b);
bool anyInitialFill(const Scene& scene);

/// Converts initialFill from 64ths of a cell (cellFractions) to fractions of the body's mean. parts: sum of
/// 64ths by body; particles: their number. The result is clamped to the range of a cut cell, since the few
/// points of a thin body may contain more.
void normaliseInitialFill(const Scene& scene, Continuum& p, std::span<const std::int64_t> parts,
                          std::span<const std::int64_t> particles);

}  // namespace thaw
