// SPDX-License-Identifier: Apache-2.0
// Buffers for the topology of a surface, kept between updates. They are not part of the state.
#pragma once
#include <algorithm>
#include <cstdint>
#include <vector>

#include "core/surface/measures/surfel_area.hpp"
#include "core/surface/search/bins.hpp"
#include "core/surface/search/inside.hpp"

namespace thaw {

/// Buffers, kept between updates.
struct ComponentTools {
  Bins surfelBins, particleBins;
  std::vector<std::uint32_t> parent;  ///< union-find: rows of surfels, then of particles
  std::vector<std::uint64_t> least;   ///< smallest label of each root's set
  std::vector<std::uint8_t> dead;
  struct Near {
    double d2;  // m^2
    std::uint32_t row;
  };
  RowBlock block;
  std::vector<Near> near;
  struct Piece {
    std::uint64_t from, part;
    friend auto operator<=>(const Piece&, const Piece&) = default;
  };
  std::vector<Piece> pieces;  ///< previous component of each part of the last split, ascending, the same on
                              ///< all ranks
  /// Returns whether there are several parts, which may come into contact.
  bool several() const {
    return std::any_of(pieces.begin(), pieces.end(),
                       [&](const Piece& p) { return p.part != pieces.front().part; });
  }
};

struct MergeTools {
  InsideTools inside;
  std::vector<SurfaceSide> sides, touching;
  std::vector<Vec3d> moved;         ///< m, positions after contact
  std::vector<std::uint8_t> open;   ///< flags of surfels that resampling must inspect
  std::vector<std::uint64_t> into;  ///< joined labels of surfels, ghosts included
};

/// Buffers of updateComponents, kept between updates.
struct TopologyTools {
  ComponentTools components;
  MergeTools merge;
  AreaLists areas;
};

}  // namespace thaw
