// Bodies whose particles begin in several pieces: thin ones, aslant on the lattice.
#pragma once
#include <cstdint>
#include <vector>

#include "core/halo/surface_halos.hpp"
#include "core/world.hpp"

namespace thaw {

struct SurfaceTools;

struct BodyPieces {
  std::size_t body = 0;
  std::int64_t pieces = 0;
};

/// Bodies, ascending, with particles that no chain of links (surface.link_length) joins though they are less
/// than two spacings apart, so that no layer of the lattice is missing between them; and how many pieces they
/// are of that are so near to others. Needs gathered particles without components, and leaves them so.
/// Collective.
std::vector<BodyPieces> findStartPieces(World& world, SurfaceHalos halos, SurfaceTools& tools);

}  // namespace thaw
