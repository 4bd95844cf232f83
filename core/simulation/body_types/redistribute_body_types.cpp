// SPDX-License-Identifier: Apache-2.0
#include "core/simulation/body_types/redistribute_body_types.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/domain/sides.hpp"
#include "core/simulation/body_types/type_actions.hpp"
#include "core/simulation/ledger/ledger_rows.hpp"
#include "core/simulation/world/body_types.hpp"

namespace thaw {

namespace {

/// Migrates and sorts one body type; rows in `leaving` (ascending, with noCell as their next cell) are
/// dropped.
void redistributeRows(World& w, Halos& halos, RedistributionWork& work, std::size_t type, BodyTypeRows& r,
                      CellTable& cells) {
  const std::size_t before = r.owned;
  Migration m = halos.bodyTypes[type]->migrate(r, {r.nextCell.data(), r.owned});
  computeCellKeys(w.grid, r, before, r.owned);
  if (const auto& migrateMore = typeActions()[type].migrateMore) migrateMore(w, halos, m);
  if (!work.leaving.empty()) {
    std::vector<std::uint32_t> gone;
    std::merge(m.departed.begin(), m.departed.end(), work.leaving.begin(), work.leaving.end(),
               std::back_inserter(gone));
    m.departed = std::move(gone);
  }
  sortByCell(r, m, work.sort, cells);
}

}  // namespace

void redistributeBodyTypes(World& w, Halos halos, RedistributionWork& work, double dt) {
  forEachBodyType(w, [&](std::size_t type, BodyTypeRows& r, CellTable& cells) {
    const TypeActions& actions = typeActions()[type];
    halos.bodyTypes[type]->follow(halos.cells);
    if (r.ghosts > 0) r.resize(r.owned, 0);
    for (std::size_t i = 0; i < r.owned; i++)
      if (const double more = wrapPlace(w.grid, w.scene.domain, r.position[i]); more != 0)
        w.ledger.entered.potential.add(r.mass[i] * more);
    computeCellKeys(w.grid, r);
    work.leaving.clear();
    if (actions.leavesAtSides) findLeaving(w.scene.domain, r, 0, r.owned, work.leaving);
    if (actions.beforeRemoval) actions.beforeRemoval(w, work.leaving, dt);
    for (const std::uint32_t i : work.leaving) {
      addBodyTypeRow(w, type, i, w.ledger.left);
      w.ledger.dissipated.add(r.dissipated[i]);
      countLeaving(w.scene.domain, r.position[i], w.counters);
    }
    if (actions.afterRemoval) actions.afterRemoval(w, !work.leaving.empty());
    redistributeRows(w, halos, work, type, r, cells);
  });
}

void activateBodyTypes(World& w) {
  for (const TypeActions& actions : typeActions())
    if (actions.isOn(w)) actions.activate(w);
}

std::vector<std::vector<Vec3d>> sampleBodyTypes(World& w, Halos halos, SortBuffers& sort,
                                                const MeshLoader& load, std::vector<SceneWarning>& warnings) {
  SamplingOfTypes sampling{halos, load, warnings, {}};
  for (const TypeActions& actions : typeActions())
    if (actions.isOn(w)) actions.sample(w, sampling);
  forEachBodyType(w, [&](std::size_t, BodyTypeRows& r, CellTable& cells) {
    for (std::size_t i = 0; i < r.owned; i++) wrapPlace(w.grid, w.scene.domain, r.position[i]);
    computeCellKeys(w.grid, r);
    Migration all;
    all.arrivals = r.owned;
    sortByCell(r, all, sort, cells);
  });
  return std::move(sampling.positions);
}

bool bodyTypesAreFinite(const World& w) {
  bool finite = true;
  forEachBodyType(w, [&](std::size_t, const BodyTypeRows& r, const CellTable&) {
    for (std::size_t i = 0; i < r.owned; i++) {
      const Vec3d &x = r.position[i], &v = r.velocity[i];
      finite = finite && std::isfinite(x.x + x.y + x.z + v.x + v.y + v.z);
    }
  });
  return finite;
}

void clearBodyTypes(World& w) {
  forEachBodyType(w, [](std::size_t, BodyTypeRows& r, CellTable& cells) {
    r.resize(r.owned, 0);
    r.resize(0, 0);
    cells = {};
  });
  for (const TypeActions& actions : typeActions())
    if (actions.clear && actions.isOn(w)) actions.clear(w);
}

}  // namespace thaw
