// SPDX-License-Identifier: Apache-2.0
#include "core/simulation/setup/packing_sums.hpp"

#include <algorithm>

#include "core/halo/exchange.hpp"
#include "core/simulation/sums/particle_sums.hpp"

namespace thaw {
namespace {

/// Returns the modules for the packing of bodies, independent of the scene's modules.
Modules packingModules(Modules m) {
  m.fluid = m.neighbours = true;
  m.heat = m.melting = m.uniform = false;
  return m;
}

PairSums packingSums(World& w, const PairSumWork& work) {
  PairSums s = pairSumsOf(w, work);
  s.heat = s.uniform = s.carried = s.relief = false;
  s.pressureForm = PairForm::Consistent;
  s.concentrationGradient = nullptr;
  return s;
}

}  // namespace

void sumUnitPressure(World& w, const std::vector<LiquidMaterial>& liquids, PairSumWork& work) {
  Continuum& p = w.particles;
  const Modules modules = packingModules(w.modules);
  const RecordContext x{w.scene, modules, w.grid, liquids};
  resizeRecords(x, p.size(), work.records);
  packRecords(x, p, 0, p.size(), work.records);
  setUnitPressure(x, p.size(), work.records);
  clearLists(w.neighbours, static_cast<std::uint32_t>(p.owned), static_cast<std::uint32_t>(p.size()));
  std::fill(work.inner.begin(), work.inner.end(), std::uint8_t{1});
  SearchInput in;
  in.x = work.records.coarse[0].data(), in.y = work.records.coarse[1].data(),
  in.z = work.records.coarse[2].data();
  in.cells = &w.cells;
  in.inner = work.inner.data();
  in.owned = static_cast<std::uint32_t>(p.owned);
  work.kernels->search(in, Part::Inner, work.search, w.neighbours);
  PairSums s = packingSums(w, work);
  s.relativeDensityScale = 1 / (w.grid.support * w.grid.support * w.grid.support);
  work.kernels->forces(s, {0, w.neighbours.groups});
}

void sumExcessPressure(World& w, CellHalo& halo, const std::vector<LiquidMaterial>& liquids,
                       PairSumWork& work) {
  Continuum& p = w.particles;
  const GroupRange all{0, w.neighbours.groups};
  const PairSums s = packingSums(w, work);
  work.kernels->density(s, all);
  refresh(halo, p, ColumnList{&p.relativeDensity}).wait();
  const Modules modules = packingModules(w.modules);
  setExcessPressure({w.scene, modules, w.grid, liquids}, p, work.records);
  std::fill_n(p.force.data(), p.owned, Vec3d{});
  work.kernels->forces(s, all);
}

}  // namespace thaw
