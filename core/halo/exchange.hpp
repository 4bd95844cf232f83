// SPDX-License-Identifier: Apache-2.0
// Exchanges as handles: `auto ghosts = refresh(...); …; ghosts.wait();`. The sums of inner particles run
// between these two calls.
#pragma once
#include <utility>

#include "core/halo/halo.hpp"

namespace thaw {

/// An exchange in flight. Copies are valid after wait(). Call wait() before the handle is destroyed or
/// overwritten. A default-constructed handle has nothing in flight.
class [[nodiscard]] Exchange {
 public:
  Exchange() = default;
  Exchange(Exchange&& other) noexcept { *this = std::move(other); }
  Exchange& operator=(Exchange&& other) noexcept {
    finish_ = std::exchange(other.finish_, nullptr);
    halo_ = other.halo_, table_ = other.table_, cells_ = other.cells_;
    return *this;
  }

  /// Blocks until the copies have arrived. Returns at once if nothing is in flight. Collective.
  void wait() {
    if (finish_) std::exchange(finish_, nullptr)(*this);
  }

  friend Exchange sendGhosts(CellHalo& halo, Table& rows, CellTable& cells,
                             std::span<AnyColumn* const> columns) {
    halo.beginGhosts(rows, cells, columns);
    return {&halo, &rows, &cells,
            [](Exchange& e) { static_cast<CellHalo*>(e.halo_)->finishGhosts(*e.table_, *e.cells_); }};
  }
  friend Exchange refresh(CellHalo& halo, Table& rows, std::span<AnyColumn* const> columns) {
    halo.beginRefresh(rows, columns);
    return {&halo, &rows, nullptr,
            [](Exchange& e) { static_cast<CellHalo*>(e.halo_)->finishRefresh(*e.table_); }};
  }
  friend Exchange refresh(BondHalo& halo, Solids& ends, std::span<AnyColumn* const> columns) {
    halo.begin(ends, columns);
    return {&halo, &ends, nullptr,
            [](Exchange& e) { static_cast<BondHalo*>(e.halo_)->finish(*static_cast<Solids*>(e.table_)); }};
  }

 private:
  using Finish = void (*)(Exchange&);
  Exchange(void* halo, Table* table, CellTable* cells, Finish finish)
      : halo_(halo), table_(table), cells_(cells), finish_(finish) {}

  void* halo_ = nullptr;
  Table* table_ = nullptr;
  CellTable* cells_ = nullptr;
  Finish finish_ = nullptr;
};

/// Sends copies of the particles in surrounding cells (CellHalo::beginGhosts). Collective.
Exchange sendGhosts(CellHalo& halo, Table& rows, CellTable& cells, std::span<AnyColumn* const> columns);

/// Sends these columns to the existing ghosts again (CellHalo::beginRefresh). At most one refresh per halo
/// may be in flight. Collective.
Exchange refresh(CellHalo& halo, Table& rows, std::span<AnyColumn* const> columns);

/// Sends columns of solids to the remote ends of bonds (BondHalo::begin). Collective.
Exchange refresh(BondHalo& halo, Solids& ends, std::span<AnyColumn* const> columns);

}  // namespace thaw
