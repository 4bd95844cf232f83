// What of its body is around a particle at the start, for the colour field of the surface.
#pragma once
#include <span>

#include "core/particles/continuum.hpp"
#include "core/scene/scene.hpp"

namespace thaw {

/// Is the surface of body b grown from particles that are cut from a lattice? Then its particles have
/// Continuum::surfaceFill.
bool bodyFills(const Scene& scene, std::size_t b);
bool anyBodyFills(const Scene& scene);

/// From 64ths of a cell (cellShares) in surfaceFill to shares of the mean of the particle's body, of which
/// `parts` says the sum of 64ths by body and `particles` the number. Not further off 1 than a cut cell can
/// be: thin bodies, whose points are few, may have the rest of them.
void finishFill(const Scene& scene, Continuum& p, std::span<const std::int64_t> parts,
                std::span<const std::int64_t> particles);

}  // namespace thaw
