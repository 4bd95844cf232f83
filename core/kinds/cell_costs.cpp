#include "core/kinds/cell_costs.hpp"

#include <algorithm>

namespace thaw {
namespace {

struct CellCost { std::uint64_t key; double cost; };

/// Of owned rows alone, whatever ghost cells were merged into `cells`.
void addCells(const Table& rows, const CellTable& cells, double perRow, std::vector<CellCost>& list) {
  for (std::size_t c = 0; c < cells.key.size(); c++)
    if (cells.first[c] < rows.owned) list.push_back({cells.key[c], perRow * cells.count[c]});
}

}  // namespace

CellCosts costOfCells(const World& w, double perParticle, const std::array<double, kindCount>& perRow) {
  std::vector<CellCost> list;
  addCells(w.particles, w.cells, perParticle, list);
  const std::size_t continuum = list.size();
  eachKind(w, [&](std::size_t kind, const KindRows& r, const CellTable& cells) { addCells(r, cells, perRow[kind], list); });
  if (list.size() != continuum) std::stable_sort(list.begin(), list.end(), [](const CellCost& a, const CellCost& b) { return a.key < b.key; });
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
