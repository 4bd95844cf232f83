// SPDX-License-Identifier: Apache-2.0
#include "core/simulation/monitor/snapshot.hpp"

#include <algorithm>
#include <cstring>
#include <stdexcept>

#include "core/rigid/link_pieces.hpp"
#include "core/simulation/body_types/redistribute_body_types.hpp"
#include "core/solid/bonds/bond_records.hpp"
#include "core/surface/resume_surface.hpp"

namespace thaw {
namespace {

void setRows(Table& to, std::size_t owned, std::size_t ghosts) {
  if (to.size() != owned + ghosts) {
    to.resize(to.owned, 0);
    to.resize(0, 0);
    to.resize(owned, ghosts);
  }
  to.owned = owned;
  to.ghosts = ghosts;
}

/// Copies the State columns of the first rows of `from` into the columns of the same names. Both tables list
/// the same columns in the same order.
void copyState(const Table& from, Table& to, std::size_t owned, std::size_t ghosts) {
  const std::size_t n = owned + ghosts;
  setRows(to, owned, ghosts);
  for (std::size_t c = 0; c < from.columns.size(); c++) {
    const AnyColumn& column = *from.columns[c];
    if (!column.active || column.keep != Keep::State) continue;
    to.activate(*to.columns[c]);
    if (n > 0) std::memcpy(to.columns[c]->bytes.data(), column.bytes.data(), n * column.elementBytes);
  }
}

void copyLedger(const World& from, World& to) {
  to.clock = from.clock;
  to.ledger = from.ledger;
  to.counters = from.counters;
  to.monitor = from.monitor;
}

void copySurface(const Surface& from, Surface& to) {
  if (!from.surfels.id.active) return;
  copyState(from.surfels, to.surfels, from.surfels.owned, 0);
  to.components = from.components;
  to.events = from.events;
  to.counters = from.counters;
  to.lastStep = from.lastStep;
}

/// Copies the owned rows of a body type.
template<class Rows> void copyOwned(const Rows& from, Rows& to) {
  if (from.id.active) copyState(from, to, from.owned, 0);
}

}  // namespace

void takeSnapshot(const World& w, WorldSnapshot& good) {
  if (!w.solids.energyKnown || !w.interactionHasCompression)
    throw std::logic_error("stored energies must be computed before a snapshot");
  World& kept = good.world;
  kept.particles.declareLike(w.particles);
  packState(w.particles, good.particles);
  setRows(kept.particles, w.particles.owned, 0);
  if (w.particles.solidIndex.active) {
    kept.particles.activate(kept.particles.solidIndex);
    std::copy_n(w.particles.solidIndex.data(), w.particles.owned, kept.particles.solidIndex.data());
  }
  // Remote rows are kept because bonds refer to them by id.
  copyState(w.solids, kept.solids, w.solids.owned, w.solids.ghosts);
  kept.bonds = w.bonds;
  copySurface(w.surface, kept.surface);
  copyOwned(w.oriented.rows, kept.oriented.rows);
  copyOwned(w.sheets.rows, kept.sheets.rows);
  copyLedRows(w.pieces, kept.pieces);
  copyLedger(w, kept);
}

void emptyWorld(World& w, StepTools& t) {
  for (Table* table : {static_cast<Table*>(&w.particles), static_cast<Table*>(&w.solids)}) {
    table->resize(table->owned, 0);
    table->resize(0, 0);
  }
  w.bonds.clear();
  w.cells = {};
  emptySurface(w.surface);
  clearBodyTypes(w);
  w.pieces.resize(0, 0);
  t.solid.elastic.capacity = 0;  // everything derived from bonds is recomputed
  t.solid.requests.clear();
  t.redistribution.leaving.clear();
  t.solid.bondsAtStart = t.sources.emitFirst = t.phaseChange.here = t.phaseChange.frozeAnywhere =
      t.phaseChange.meltedAnywhere = false;
  t.solid.maxStretch2 = 1;
}

std::vector<std::byte> restoreSnapshot(const WorldSnapshot& good, World& w) {
  const World& kept = good.world;
  Continuum& p = w.particles;
  unpackState(good.particles, p);
  if (p.solidIndex.active) std::fill_n(p.solidIndex.data(), p.owned, noSolid);
  copySurface(kept.surface, w.surface);
  copyOwned(kept.oriented.rows, w.oriented.rows);
  copyOwned(kept.sheets.rows, w.sheets.rows);
  copyLedRows(kept.pieces, w.pieces);
  copyLedger(kept, w);
  SolidRecords records;
  for (std::size_t i = 0; kept.particles.solidIndex.active && i < p.owned; i++)
    if (kept.particles.solidIndex[i] != noSolid)
      appendRecord(kept.solids, kept.bonds, kept.particles.solidIndex[i], records);
  return std::move(records.bytes);
}

}  // namespace thaw
