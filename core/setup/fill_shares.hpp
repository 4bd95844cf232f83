// Initial fill of particles by their body, for the colour field of the surface.
#pragma once
#include <span>

#include "core/particles/continuum.hpp"
#include "core/scene/scene.hpp"

namespace thaw {

/// Returns true if the surface of body b is grown from particles cut from a lattice. Its particles then have
/// Continuum::surfaceFill.
bool bodyFills(const Scene& scene, std::size_t b);
bool anyBodyFills(const Scene& scene);

/// Converts surfaceFill from 64ths of a cell (cellShares) to fractions of the body's mean. parts: sum of
/// 64ths by body; particles: their number. The result is clamped to the range of a cut cell: thin bodies have
/// few points, which may hold the rest.
void finishFill(const Scene& scene, Continuum& p, std::span<const std::int64_t> parts,
                std::span<const std::int64_t> particles);

}  // namespace thaw
