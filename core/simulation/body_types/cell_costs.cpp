// SPDX-License-Identifier: Apache-2.0
#include "core/simulation/body_types/cell_costs.hpp"

#include <algorithm>

#include "core/particles/sleep_stage.hpp"

namespace thaw {
namespace {

struct CellCost {
  std::uint64_t key;
  double cost;
};

/// Appends the cost of cells with owned rows. `cells` may contain merged ghost cells. costOf(c): cost of the
/// rows of cell c.
template<class CostOf>
void addCells(const Table& rows, const CellTable& cells, CostOf costOf, std::vector<CellCost>& list) {
  for (std::size_t c = 0; c < cells.key.size(); c++)
    if (cells.first[c] < rows.owned) list.push_back({cells.key[c], costOf(c)});
}

/// Returns the cost of a particle. Sleeping particles cost about a tenth of awake ones.
double costOfParticle(const Continuum& p, std::size_t i, const RowCosts& costs) {
  return (p.sleep.active && p.sleep[i] == sleeping ? 0.1 : 1) *
         (p.phase[i] == Solid ? costs.solid : costs.liquid);
}

}  // namespace

CellCosts costOfCells(const World& w, const RowCosts& costs) {
  std::vector<CellCost> list;
  const auto ofParticles = [&](std::size_t c) {
    double sum = 0;
    for (std::size_t i = w.cells.first[c], end = i + w.cells.count[c]; i < end; i++)
      sum += costOfParticle(w.particles, i, costs);
    return sum;
  };
  addCells(w.particles, w.cells, ofParticles, list);
  forEachBodyType(w, [&](std::size_t type, const BodyTypeRows& r, const CellTable& cells) {
    addCells(
        r, cells, [&](std::size_t c) { return costs.bodyType[type] * static_cast<double>(cells.count[c]); },
        list);
  });
  const auto before = [](const CellCost& a, const CellCost& b) { return a.key < b.key; };
  if (!std::is_sorted(list.begin(), list.end(), before)) std::stable_sort(list.begin(), list.end(), before);
  CellCosts all;
  for (const CellCost& c : list) {
    if (all.cells.key.empty() || all.cells.key.back() != c.key) {
      all.cells.key.push_back(c.key);
      all.cost.push_back(0);
    }
    all.cost.back() += c.cost;
  }
  all.cells.ownedCells = all.cells.key.size();
  return all;
}

}  // namespace thaw
