// SPDX-License-Identifier: Apache-2.0
#include "core/simulation/sums/particle_sums.hpp"

#include <algorithm>

#include "core/flow/rheology/apparent_viscosity.hpp"
#include "core/materials/enthalpy.hpp"
#include "core/scene/tension_form.hpp"
#include "core/simulation/views/views.hpp"

namespace thaw {

ColumnList recordColumns(Continuum& p) {
  ColumnList columns{&p.position, &p.velocity, &p.mass, &p.material, &p.phase};
  for (AnyColumn* c : std::initializer_list<AnyColumn*>{&p.liquid, &p.temperature, &p.restDensity})
    if (c->active) columns.push_back(c);
  return columns;
}

void clearRates(Continuum& p, bool pairsSet) {
  std::fill_n(p.interaction.data(), p.owned, 0.0);
  if (!pairsSet) {
    std::fill_n(p.force.data(), p.owned, Vec3d{});
    std::fill_n(p.dissipation.data(), p.owned, 0.0);
    if (p.heatFlow.active) std::fill_n(p.heatFlow.data(), p.owned, 0.0);
  }
  if (p.fastAcceleration.active) std::fill_n(p.fastAcceleration.data(), p.owned, Vec3d{});
  if (p.softening.active) std::fill_n(p.softening.data(), p.owned, 0.0);
  if (p.drag.active) std::fill_n(p.drag.data(), p.owned, Vec3d{});
  if (p.positionForce.active) std::fill_n(p.positionForce.data(), p.owned, Vec3d{});
}

PairSums pairSumsOf(World& w, const PairSumWork& work) {
  Continuum& p = w.particles;
  const Numerics& n = w.scene.numerics;
  PairSums s;
  s.lists = &w.neighbours;
  s.kernel = n.kernel;
  s.precision = n.precision;
  s.pressureForm = n.pressure;
  s.viscosityForm = n.viscosity;
  s.viscous = !w.modules.implicitViscosity;
  s.viscousWeight = work.scales.viscousWeight;
  s.printedTension = n.tension == TensionForm::ColourField;
  s.heat = w.modules.heat;
  s.uniform = w.modules.uniform;
  if (s.uniform) {
    const Material& m = w.scene.materials[0];
    const double h = w.grid.support;
    if (p.owned > 0)
      s.volume = p.mass[0] * (1 / (m.density * h * h * h));  // the same rounding as in
                                                             // packRecords
    s.viscosity = viscosityAt(m, 1, 293);
    s.conductivity = conductivityOf(n.heat, m, 1);
    s.artificial = work.artificialViscosity;
  }
  s.conductionScale = work.scales.conductionScale;
  s.support = w.grid.support;
  s.relativeDensityScale = work.scales.relativeDensityScale;
  s.selfExcess = work.scales.selfExcess;
  s.positionVolume = n.precision == Precision::Single ? work.records.fixed.data()
                                                      : work.records.positionVolume.data();
  s.velocityViscosity = work.records.velocityViscosity.data();
  s.pressurePhaseHeat = work.records.pressurePhaseHeat.data();
  s.surface = work.records.surface.data();
  s.closeDistance = (w.modules.rareContact ? contactSight : contactDistance) * w.scene.spacing /
                    w.grid.support;
  s.freeSurfaceIndicatorScale = 2 * w.scene.spacing;
  s.relativeDensity = p.relativeDensity.data();
  s.force = p.force.data();
  s.heatFlow = p.heatFlow.data();
  s.dissipation = p.dissipation.data();
  s.interaction = p.interaction.data();
  s.freeSurfaceIndicator = p.freeSurfaceIndicator.data();
  s.smoothed = p.shiftingVelocity.data();
  s.coincident = &w.counters.coincidentPairs;
  s.carried = w.modules.continuity;
  s.relief = p.relief.active;
  s.surfaceEnergyDerivatives = work.records.surfaceEnergyDerivatives.data();
  s.surfaceGradient = p.surfaceGradient.data();
  s.surfaceColour = p.surfaceColour.data();
  s.pressureDiagonal = work.records.pressureDiagonal.data();
  s.pressureOffDiagonal = work.records.pressureOffDiagonal.data();
  if (p.concentrationGradient.active) s.concentrationGradient = p.concentrationGradient.data();
  return s;
}

namespace {

void search(World& w, PairSumWork& work, Part part) {
  const Continuum& p = w.particles;
  const std::size_t n = w.cells.key.size();
  const bool mixed = w.modules.fluid && w.modules.solid;
  if (mixed) {
    work.liquidCells.assign(n, 0);
    for (std::size_t c = 0; c < n; c++)
      for (std::uint32_t k = 0; k < w.cells.count[c]; k++) {
        const std::size_t i = w.cells.first[c] + k;
        if (p.phase[i] == Liquid || (p.liquid.active && p.liquid[i] > 0)) work.liquidCells[c] = 1;
      }
  } else if (!w.modules.fluid) {
    work.liquidCells.assign(n, 0);
  }
  SearchInput in;
  in.x = work.records.coarse[0].data(), in.y = work.records.coarse[1].data(),
  in.z = work.records.coarse[2].data();
  in.cells = &w.cells;
  in.inner = work.inner.data();
  in.liquid = mixed || !w.modules.fluid ? work.liquidCells.data() : nullptr;
  in.owned = static_cast<std::uint32_t>(p.owned);
  work.kernels->search(in, part, work.search, w.neighbours);
}

/// Searches the neighbours of rows that need no ghosts.
void searchInner(World& w, PairSumWork& work, PhaseTimes& times) {
  const Continuum& p = w.particles;
  clearLists(w.neighbours, static_cast<std::uint32_t>(p.owned),
             static_cast<std::uint32_t>(p.owned + work.ghostRoom));
  search(w, work, Part::Inner);
  times.lap(StepPhase::Search);
}

}  // namespace

void searchNeighbours(World& w, StepTools& t, Part part, double elapsed) {
  const Continuum& p = w.particles;
  RecordContext x = recordContext(w, t.liquids);
  x.elapsed = elapsed;
  if (part == Part::Inner) {
    resizeRecords(x, p.owned + t.sums.ghostRoom, t.sums.records);
    for (const RowSpan& rows : visibleRows(w.modules, p, t.sleep))
      packRecords(x, p, rows.begin, rows.end, t.sums.records);
    searchInner(w, t.sums, t.times);
  } else {
    if (p.ghosts > t.sums.ghostRoom) {
      // There are more ghosts than rows reserved for them, so the padding of the inner lists now points to
      // rows of ghosts.
      t.sums.ghostRoom = p.ghosts + p.ghosts / 8;
      resizeRecords(x, p.owned + t.sums.ghostRoom, t.sums.records);
      searchInner(w, t.sums, t.times);  // the sums of inner particles are done
    }
    packRecords(x, p, p.owned, p.size(), t.sums.records);
    search(w, t.sums, Part::Boundary);
    t.times.lap(StepPhase::Search);
  }
}

namespace {

/// Redirects the sums to the forces that do not depend on the pressure of this step.
PairSums withExplicitForces(World& w, const PairSumWork& work) {
  PairSums s = pairSumsOf(w, work);
  if (w.particles.drag.active) s.force = w.particles.drag.data();
  return s;
}

}  // namespace

void sumForces(World& w, StepTools& t, const PassRows& rows) {
  const RecordContext x = recordContext(w, t.liquids);
  if (w.modules.fluid && !w.modules.incompressible) {  // otherwise the pressure is computed at the end of the
                                                       // step
    packPressure(x, w.particles, rows.begin, rows.end, t.sums.records);
    w.interactionHasCompression = !w.modules.uniform;
  }
  if (w.modules.flowLaw) packApparentViscosity(x, w.particles, rows.begin, rows.end, t.sums.records);
  t.sums.kernels->forces(withExplicitForces(w, t.sums), rows.groups);
}

void sumTerms(World& w, StepTools& t, const PassRows& rows) {
  Continuum& p = w.particles;
  const RecordContext x = recordContext(w, t.liquids);
  for (const PairSweep* sweep : t.terms.sweeps) {
    if (sweep->pack) sweep->pack(x, p, rows.begin, rows.end, t.sums.records);
    PairSums s = sweep->onto == PairTarget::ExplicitForce ? withExplicitForces(w, t.sums)
                                                          : pairSumsOf(w, t.sums);
    if (sweep->onto == PairTarget::PositionForce && p.positionForce.active) s.force = p.positionForce.data();
    (t.sums.kernels->*sweep->sum)(s, rows.groups);
  }
}

void addPositionForces(Continuum& p) {
  for (std::size_t i = 0; i < p.owned; i++) p.force[i] += p.positionForce[i];
}

void addExplicitForces(Continuum& p) {
  for (std::size_t i = 0; i < p.owned; i++) p.force[i] += p.drag[i];
}

void markInner(const CellTable& cells, std::size_t owned, const CellHalo& halo,
               std::vector<std::uint8_t>& inner) {
  inner.resize(cells.key.size());
  for (std::size_t c = 0; c < inner.size(); c++)
    inner[c] = cells.first[c] < owned && halo.inner(cells.key[c]);
}

}  // namespace thaw
