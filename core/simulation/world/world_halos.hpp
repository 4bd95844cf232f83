// SPDX-License-Identifier: Apache-2.0
// The halos of all tables of a world, over MPI or in a single process.
#pragma once
#include <memory>

#include "core/halo/halos.hpp"
#include "core/simulation/world/body_types.hpp"

namespace thaw {

/// Cells and Bonds implement CellHalo and BondHalo. Absent tables have no halos.
template<class Cells, class Bonds> struct WorldHalos {
  std::unique_ptr<Cells> cells;
  std::unique_ptr<Bonds> bonds;
  std::unique_ptr<Cells> bodyTypes[bodyTypeCount];
  std::unique_ptr<Bonds> edges;  ///< between vertices of sheets

  /// Makes new halos for the tables of a prepared world. `ranks` are the first arguments of the constructors:
  /// a communicator, or nothing. Collective.
  template<class... Ranks> void make(const World& w, const Ranks&... ranks) {
    cells = std::make_unique<Cells>(ranks..., w.grid);
    bonds = std::make_unique<Bonds>(ranks...);
    forEachBodyType(w, [&](std::size_t type, const BodyTypeRows&, const CellTable&) {
      bodyTypes[type] = std::make_unique<Cells>(ranks..., w.grid);
    });
    if (w.modules.sheet) edges = std::make_unique<Bonds>(ranks...);
  }

  /// Requires: make was called.
  Halos with(Reducer& all) {
    Halos halos{all, *cells, *bonds, {}, edges.get()};
    for (std::size_t type = 0; type < bodyTypeCount; type++) halos.bodyTypes[type] = bodyTypes[type].get();
    return halos;
  }
};

}  // namespace thaw
