// SPDX-License-Identifier: Apache-2.0
#include "core/simulation/sums/particle_sums.hpp"

#include <algorithm>
#include <cstring>
#include <optional>

#include "core/contact/solid_contact.hpp"
#include "core/flow/curvature/tension_interval.hpp"
#include "core/flow/density/carried_density.hpp"
#include "core/flow/implicit_viscosity/implicit_viscosity.hpp"
#include "core/flow/incompressible/pressure_solver.hpp"
#include "core/flow/rheology/apparent_viscosity.hpp"
#include "core/halo/exchange.hpp"
#include "core/heat/exposed_area.hpp"
#include "core/materials/enthalpy.hpp"
#include "core/math/hash_random.hpp"
#include "core/rigid/piece_joint.hpp"
#include "core/scene/tension_form.hpp"
#include "core/simulation/views/views.hpp"
#include "core/terms/extensions.hpp"

namespace thaw {
ColumnList ghostColumns(const Modules& m, Continuum& p) {
  ColumnList c{&p.position, &p.velocity, &p.mass, &p.material, &p.phase};
  if (m.solid) c.push_back(&p.id);
  if (m.solid || m.contactConductance) c.push_back(&p.body);
  for (AnyColumn* column :
       std::initializer_list<AnyColumn*>{&p.piece, &p.faceNormal, &p.faceOffset, &p.faceRadius})
    if (column->active) c.push_back(column);
  if (p.liquid.active) c.push_back(&p.liquid);
  if (p.temperature.active) c.push_back(&p.temperature);
  if (p.restDensity.active) c.push_back(&p.restDensity);
  if (p.compression.active) c.push_back(&p.compression);
  if (p.stepMeanVelocity.active) c.push_back(&p.stepMeanVelocity);
  const bool carriedPaths = p.compression.active && p.shiftingVelocity.active;
  if (carriedPaths) c.push_back(&p.shiftingVelocity);
  if (p.atSurface.active) c.push_back(&p.atSurface);
  if (m.bodyContact) c.push_back(&p.contactDepth);
  if (p.viscosityCorrection.active) c.push_back(&p.viscosityCorrection);
  if (p.conductionCorrection.active) c.push_back(&p.conductionCorrection);
  if ((m.incompressible || p.relief.active || carriedPaths) && p.clamped.active) c.push_back(&p.clamped);
  if (m.sleep) c.push_back(&p.restTime);
  if (m.sleep) c.push_back(&p.sleep);
  for (const auto& added : p.added)
    if (added->active && added->ghosts) c.push_back(added.get());
  return c;
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
    const double dx = w.scene.spacing, h = w.grid.support;
    s.volume = m.density * dx * dx * dx * (1 / (m.density * h * h * h));  // the same rounding as in
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
    for (const RowSpan& rows : rowsToSee(w.modules, p, t.sleep))
      packRecords(x, p, rows.begin, rows.end, t.sums.records);
    searchInner(w, t.sums, t.times);
  } else {
    if (p.ghosts > t.sums.ghostRoom) {
      // More ghosts than ever: the padding of the inner lists points to rows of ghosts now.
      t.sums.ghostRoom = p.ghosts + p.ghosts / 8;
      resizeRecords(x, p.owned + t.sums.ghostRoom, t.sums.records);
      searchInner(w, t.sums, t.times);  // the sums of inner particles are done
    }
    packRecords(x, p, p.owned, p.size(), t.sums.records);
    search(w, t.sums, Part::Boundary);
    t.times.lap(StepPhase::Search);
  }
}

void sumDensities(World& w, StepTools& t, const PassRows& rows) {
  t.sums.kernels->density(pairSumsOf(w, t.sums), rows.groups);
}

void sumCarriedDensities(World& w, StepTools& t, const PassRows& rows, double elapsed) {
  PairSums sums = pairSumsOf(w, t.sums);
  const CarryContext context = carryContext(w, t, elapsed);
  CarryStep carry = carryStepOf(context);
  sums.carry = &carry;
  sums.positionVolume = t.sums.records.middle.data();
  t.sums.kernels->density(sums, rows.groups);
}

namespace {

/// Sends a sum to the forces that do not depend on the pressure of this step.
PairSums withExplicitForces(World& w, const PairSumWork& work) {
  PairSums s = pairSumsOf(w, work);
  if (w.particles.drag.active) s.force = w.particles.drag.data();
  return s;
}

}  // namespace

void sumForces(World& w, StepTools& t, const PassRows& rows) {
  const RecordContext x = recordContext(w, t.liquids);
  if (w.modules.fluid && !w.modules.incompressible) {  // else the pressure is computed at the end of the step
    packPressure(x, w.particles, rows.begin, rows.end, t.sums.records);
    w.compressionKnown = !w.modules.uniform;
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

namespace {

/// Records the energy that particles emitted in this step bring: that of pairs with at least one of them.
void recordEntry(World& w, const PairSums& sums, PairForceWork& work, const AddedColumn& newborn) {
  const Continuum& p = w.particles;
  bool any = false;
  for (std::size_t i = 0; i < p.size(); i++) any = any || newborn.row(i)[0] > 0;
  if (!any) return;
  clearPairRecords(w.scene.numerics.precision, newborn, p.size(), work);
  for (std::size_t i = 0; i < p.owned; i++) w.ledger.entered.potential.add(work.energy[i]);
  work.energy.assign(p.owned, 0);
  PairSums others = sums;
  std::vector<Vec3d> force(p.owned);
  std::vector<double> dissipation(p.owned);
  others.force = force.data(), others.dissipation = dissipation.data();
  work.force->kernels.sum(others,
                          {work.records.data(), constantsOf(w.scene, w.grid, work), work.energy.data()},
                          {0, w.neighbours.groups});
  for (std::size_t i = 0; i < p.owned; i++) w.ledger.entered.potential.add(-work.energy[i]);
}

}  // namespace

void sumPairForces(World& w, StepTools& t) {
  Continuum& p = w.particles;
  PairSums sums = pairSumsOf(w, t.sums);
  if (p.positionForce.active) sums.force = p.positionForce.data();
  const AddedColumn* newborn = newbornOf(p);
  for (PairForceWork& work : t.terms.pairForces) {
    resizePairForce(sums.precision, p.owned + t.sums.ghostRoom, work);
    packPairForce(w.scene, p, 0, p.size(), work);
    work.energy.assign(p.owned, 0);
    work.force->kernels.sum(sums,
                            {work.records.data(), constantsOf(w.scene, w.grid, work), work.energy.data()},
                            {0, w.neighbours.groups});
    for (std::size_t i = 0; i < p.owned; i++) p.interaction[i] += work.energy[i];
    for (std::size_t i = 0; w.modules.melting && i < p.owned; i++)
      t.phaseChange.energy.inPairs[i] += work.energy[i];
    if (newborn) recordEntry(w, sums, work, *newborn);
  }
  t.times.lap(StepPhase::Forces);
}

void addPositionForces(Continuum& p) {
  for (std::size_t i = 0; i < p.owned; i++) p.force[i] += p.positionForce[i];
}

void addExplicitForces(Continuum& p) {
  for (std::size_t i = 0; i < p.owned; i++) p.force[i] += p.drag[i];
}

PairConstants constantsOf(const Scene& scene, const CellGrid& grid, const PairForceWork& work) {
  return {work.values.data(), grid.support, scene.spacing};
}

bool viscosityCorrectionDue(const Modules& modules, const Clock& clock) {
  constexpr std::int64_t everySteps = 8;  // explicit steps are much shorter than the flow takes for a spacing
  return modules.viscosityCorrection && (modules.implicitViscosity || clock.step % everySteps == 0);
}

namespace {

/// Finds WallWork::shares, which no-slip walls have, of all owned rows. support: m.
void findWallShares(const Walls& walls, double support, std::size_t owned, WallWork& work) {
  work.shares.assign(owned, {});
  for (const WallContact& c : work.contacts.list) {
    if (walls.list[c.wall].properties.slip) continue;
    const WallIntegrals at = work.tables(c.distance / support);
    work.shares[c.row].density += static_cast<float>(at.space * c.share);
    work.shares[c.row].shear += static_cast<float>(at.shear * c.share);
  }
}

}  // namespace

void correctViscosity(World& w, const PairSumWork& work, WallWork& walls) {
  PairSums s = pairSumsOf(w, work);
  if (!walls.contacts.list.empty()) {
    findWallShares(w.walls, w.grid.support, w.particles.owned, walls);
    s.viscosityWalls = walls.shares.data();
  }
  s.viscosityCorrection = w.particles.viscosityCorrection.data();
  s.largestViscosityFactor = w.modules.implicitViscosity ? 2 : 1.25;
  work.kernels->viscosityCorrection(s, {0, w.neighbours.groups});
}

namespace {

std::optional<PieceJoint> jointOf(World& w, Halos& halos, RigidWork& rigid) {
  std::optional<PieceJoint> joint;
  if (w.modules.rigid) joint.emplace(rigidView(w, rigid), halos.all);
  return joint;
}

}  // namespace

void solveViscosity(World& w, Halos halos, StepTools& t, const WallContext& walls) {
  std::optional<PieceJoint> joint = jointOf(w, halos, t.rigid);
  addImplicitViscosity({w.neighbours, *t.sums.kernels, t.sums.ghostRoom, t.walls.contacts, t.viscous, t.times,
                        joint ? &*joint : nullptr},
                       halos, pairSumsOf(w, t.sums), walls);
}

void solvePressure(World& w, Halos halos, StepTools& t, double dt) {
  std::optional<PieceJoint> joint = jointOf(w, halos, t.rigid);
  findPressure({w.scene,
                w.modules,
                w.grid,
                w.particles,
                w.neighbours,
                w.walls,
                w.clock,
                w.ledger,
                w.counters,
                w.lastIterations,
                halos,
                pairSumsOf(w, t.sums),
                *t.sums.kernels,
                t.liquids,
                t.sums.records,
                t.walls.tables,
                t.sums.scales.inverseLatticeSum,
                t.walls.contacts,
                t.pressure,
                t.times,
                joint ? &*joint : nullptr},
               dt);
}

namespace {

/// Modules for the packing of bodies, independent of the scene's.
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

void markInner(const CellTable& cells, std::size_t owned, const CellHalo& halo,
               std::vector<std::uint8_t>& inner) {
  inner.resize(cells.key.size());
  for (std::size_t c = 0; c < inner.size(); c++)
    inner[c] = cells.first[c] < owned && halo.inner(cells.key[c]);
}

void separateCoincident(World& w, const PairRecords& records, std::int64_t before) {
  if (w.counters.coincidentPairs == before) return;
  Continuum& p = w.particles;
  const NeighbourLists& lists = w.neighbours;
  const std::uint32_t* positionVolume = reinterpret_cast<const std::uint32_t*>(records.fixed.data());
  for (std::size_t g = 0; g < lists.groups; g++)
    for (std::size_t l = 0; l < 8; l++) {
      const std::uint32_t i = lists.self[8 * g + l];
      if (i == lists.dummy) continue;
      bool together = false;
      for (std::uint32_t k = 0; k < lists.count[g] && !together; k++) {
        const std::uint32_t j = lists.row(g, k, l);
        together = j != lists.dummy &&
                   std::memcmp(positionVolume + 4ull * i, positionVolume + 4ull * j, 12) == 0;
      }
      if (!together) continue;
      Vec3d d;
      for (int a = 0; a < 3; a++)
        d[a] = randomUniform(w.scene.seed, Purpose::Separate, p.id[i], static_cast<std::uint64_t>(a)) - 0.5;
      p.position[i] += d * (1e-5 * w.scene.spacing);
      if (p.restTime.active) p.restTime[i] = 0;
    }
}

}  // namespace thaw
