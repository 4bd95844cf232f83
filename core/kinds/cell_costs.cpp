#include "core/kinds/cell_costs.hpp"

#include <algorithm>

#include "core/sleep/sleep.hpp"

namespace thaw {
namespace {

struct CellCost { std::uint64_t key; double cost; };

/// Of owned rows alone, whatever ghost cells were merged into `cells`. count(c): what the rows of cell c count.
template<class Count> void addCells(const Table& rows, const CellTable& cells, double perRow, Count count, std::vector<CellCost>& list) {
  for (std::size_t c = 0; c < cells.key.size(); c++)
    if (cells.first[c] < rows.owned) list.push_back({cells.key[c], perRow * count(c)});
}

/// What sleeps costs about a tenth.
double wakeful(const Continuum& p, std::size_t first, std::size_t count) {
  if (!p.sleep.active) return static_cast<double>(count);
  double sum = 0;
  for (std::size_t i = first; i < first + count; i++) sum += p.sleep[i] == asleep ? 0.1 : 1;
  return sum;
}

}  // namespace

CellCosts costOfCells(const World& w, double perParticle, const std::array<double, kindCount>& perRow) {
  std::vector<CellCost> list;
  addCells(w.particles, w.cells, perParticle, [&](std::size_t c) { return wakeful(w.particles, w.cells.first[c], w.cells.count[c]); }, list);
  eachKind(w, [&](std::size_t kind, const KindRows& r, const CellTable& cells) { addCells(r, cells, perRow[kind], [&](std::size_t c) { return static_cast<double>(cells.count[c]); }, list); });
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
