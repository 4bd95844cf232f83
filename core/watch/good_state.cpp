#include "core/watch/good_state.hpp"

#include <algorithm>
#include <cstring>
#include <stdexcept>

#include "core/kinds/place_kinds.hpp"
#include "core/solid/bond_records.hpp"
#include "core/surface/resume_surface.hpp"

namespace thaw {
namespace {

/// State columns (and this one) of `from`'s first rows, into the columns of the same names. Both tables list the same columns in the same order.
void copyState(const Table& from, Table& to, std::size_t owned, std::size_t ghosts, const AnyColumn* also) {
  const std::size_t n = owned + ghosts;
  if (to.size() != n) {
    to.resize(to.owned, 0);
    to.resize(0, 0);
    to.resize(owned, ghosts);
  }
  to.owned = owned;
  to.ghosts = ghosts;
  for (std::size_t c = 0; c < from.columns.size(); c++) {
    const AnyColumn& column = *from.columns[c];
    if (!column.active || (column.keep != Keep::State && &column != also)) continue;
    to.activate(*to.columns[c]);
    if (n > 0) std::memcpy(to.columns[c]->bytes.data(), column.bytes.data(), n * column.elementBytes);
  }
}

void copyBooks(const World& from, World& to) {
  to.clock = from.clock;
  to.ledger = from.ledger;
  to.counters = from.counters;
  to.watch = from.watch;
}

void copySurface(const Surface& from, Surface& to) {
  if (!from.surfels.id.active) return;
  copyState(from.surfels, to.surfels, from.surfels.owned, 0, nullptr);
  to.components = from.components;
  to.events = from.events;
  to.counters = from.counters;
  to.lastStep = from.lastStep;
}

void copyKinds(const World& from, World& to) {
  if (from.oriented.rows.id.active) copyState(from.oriented.rows, to.oriented.rows, from.oriented.rows.owned, 0, nullptr);
  if (from.sheets.rows.id.active) copyState(from.sheets.rows, to.sheets.rows, from.sheets.rows.owned, 0, nullptr);
}

}  // namespace

void keepState(const World& w, World& kept) {
  if (!w.solids.energyKnown || !w.compressionKnown) throw std::logic_error("stored energies are to be found before a state is kept");
  copyState(w.particles, kept.particles, w.particles.owned, 0, &w.particles.slot);
  copyState(w.solids, kept.solids, w.solids.owned, w.solids.ghosts, nullptr);  // remote rows: bonds name them, and they have an id
  kept.bonds = w.bonds;
  copySurface(w.surface, kept.surface);
  copyKinds(w, kept);
  copyBooks(w, kept);
}

void emptyWorld(World& w, StepTools& t) {
  for (Table* table : {static_cast<Table*>(&w.particles), static_cast<Table*>(&w.solids)}) {
    table->resize(table->owned, 0);
    table->resize(0, 0);
  }
  w.bonds.clear();
  w.cells = {};
  emptySurface(w.surface);
  emptyKinds(w);
  t.elastic.capacity = 0;  // everything that is derived from bonds is computed anew
  t.requests.clear();
  t.leaving.clear();
  t.bondsAtStart = t.emitFirst = t.phaseChangedHere = t.frozeAnywhere = t.meltedAnywhere = false;
  t.maxStretch2 = 1;
}

std::vector<std::byte> bringBack(const World& kept, World& w) {
  Continuum& p = w.particles;
  copyState(kept.particles, p, kept.particles.owned, 0, nullptr);
  if (p.slot.active) std::fill_n(p.slot.data(), p.owned, noSlot);
  copySurface(kept.surface, w.surface);
  copyKinds(kept, w);
  copyBooks(kept, w);
  SolidRecords records;
  for (std::size_t i = 0; kept.particles.slot.active && i < p.owned; i++)
    if (kept.particles.slot[i] != noSlot) appendRecord(kept.solids, kept.bonds, kept.particles.slot[i], records);
  return std::move(records.bytes);
}

}  // namespace thaw
