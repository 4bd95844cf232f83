// One time step: the page to read first.
#pragma once
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "core/domain/emit.hpp"
#include "core/fluid/implicit_viscosity/viscous_work.hpp"
#include "core/fluid/incompressible/pressure_work.hpp"
#include "core/fluid/records.hpp"
#include "core/fluid/surface_energy.hpp"
#include "core/geometry/signed_distance.hpp"
#include "core/halo/halo.hpp"
#include "core/ledger/energy_left.hpp"
#include "core/neighbours/search.hpp"
#include "core/neighbours/sort.hpp"
#include "core/oriented/oriented_work.hpp"
#include "core/simd/pair_kernels.hpp"
#include "core/sleep/sleep.hpp"
#include "core/solid/elastic.hpp"
#include "core/time/limits.hpp"
#include "core/time/phase_times.hpp"
#include "core/walls/wall_forces.hpp"
#include "core/watch/watch.hpp"
#include "core/world.hpp"

namespace thaw {

/// The other ranks, seen from the step.
struct Halos {
  Reducer& all;
  CellHalo& cells;
  BondHalo& bonds;
  CellHalo* kinds[2] = {nullptr, nullptr};  ///< of the further kinds (core/kinds/kinds.hpp), over the same
                                            ///< grid; null for those that the scene has not
  BondHalo* edges = nullptr;                ///< of the sheets
};

/// What a step works with; made once (makeTools), reused in every step. Nothing of it is part of the state.
struct StepTools {
  const PairKernels* kernels = nullptr;
  std::vector<LiquidMaterial> liquids;
  StepLimits fixedLimits;  ///< of materials
  WatchBounds watch;
  std::vector<EmitterPlan> emitters;
  std::vector<std::shared_ptr<const SignedDistance>> shapes;  ///< of the bodies, until they have been
                                                              ///< sampled: those of meshes take long to make
  WallTables wallTables;
  ViscousWeight viscousWeight;   ///< of the pairwise viscosity
  double perLatticeSum = 1;      ///< what sums over V W are multiplied by to be fillings
  SurfaceMeasure surface;        ///< of surface tension as an energy
  double selfExcess = 0;         ///< taken from the filling of a particle, per V0 / h^3 of its own
                                 ///< (terms/density.hpp)
  double stableViscousStep = 0;  ///< dt nu / h^2 that is just stable on the lattice
  double conductionScale = 1;    ///< of heat conduction, see kernels/lattice.hpp
  double fillingScale = 1;       ///< the same / h^3
  SortBuffers sort;
  SearchBuffers search;
  PairRecords records;
  std::vector<std::uint8_t> inner, liquidCells;
  std::size_t ghostRoom = 1024;  ///< rows kept for ghosts between the owned rows and the dummy
  ClosePairs closePairs;
  std::vector<ContactResistance> contactResistance;
  WallContacts wallContacts;
  std::vector<WallContact> substepContacts;  ///< of the solids that may touch a wall in this step
  double longestContact = never;  ///< s, of a substep: contact of solids with walls where substeps do it, of
                                  ///< materials
  PressureWork pressure;
  ElasticWork elastic;
  ViscousWork viscous;
  OrientedWork oriented;
  SleepWork sleep;
  std::vector<BondRequest> requests;
  std::vector<std::uint32_t> rebonded;  ///< rows of particles that took new bonds
  std::vector<std::uint32_t> leaving;
  std::vector<Leaver> leavers;  ///< from all ranks; empty without surface tension
  PhaseTimes times;
  // from one step to the next; found again after a restart
  bool bondsAtStart = false;  ///< the next evaluation bonds the solids of the scene
  bool mayLeave = true;  ///< a particle may be beyond an open side; false: the drift has seen that none is
  bool newPartition = true;  ///< cells may have other owners than at the last evaluation
  bool looseMemory = false;  ///< the last evaluation had a new partition: what it needed for once is free
  bool emitFirst = false;    ///< the next evaluation also emits what leaves at time 0
  bool phaseChangedHere = false;  ///< on this rank, since the last relink
  bool frozeAnywhere = false;     ///< some particle of some rank has just frozen
  bool meltedAnywhere = false;    ///< some solid of some rank has melted in this step
  double mass = 0;                ///< kg, of all ranks
  double maxStretch2 = 1;         ///< square of the largest stretch of this rank
};

/// What a rank would like to happen after a step; if one asks, all do it.
struct Requests {
  bool stop = false, report = false, checkpoint = false;
};

/// What all ranks agree on after a step.
struct StepOutcome {
  Limit limitedBy = Limit::Scene;
  Requests wanted;            ///< by some rank
  Alarm alarm = Alarm::None;  ///< what the watch saw
  bool finite = true;         ///< false: some value is not; on the rank that has it `bad` is its row
  bool badHere = false;
  std::size_t bad = 0;
  std::optional<LargestRates> largest;  ///< of this rank, where the kick has found them
  double surfaceMove2 = 0;  ///< m^2, farthest that a particle has come since the last update of the surface,
                            ///< squared; 0 without one
};

/// Everything that a scene needs, made ready. Throws std::runtime_error (one sentence) for what cannot be
/// simulated.
StepTools makeTools(const World& world);

/// Forces, heat flows and all else that follows from positions, velocities and temperatures; migrates, sorts
/// and finds neighbours first. dt (s) is the step that led here, 0 at the start. Needs: particles in any
/// order, on any rank. Guarantees: each on the rank that owns its cell, sorted by (cell, id), where anybody
/// asks for cells (needsOrder).
void evaluate(World& world, Halos halos, StepTools& tools, double dt);

/// The next step's dt, from all ranks' limits, into the clock. Collective.
StepOutcome vote(World& world, Halos halos, StepTools& tools, StepOutcome here, Requests wanted);

/// One leap-frog step of Clock::dt, cut to hit the next frame time. Needs accelerations: evaluate and vote
/// once before the first step. Collective; the same bits on any number of ranks.
StepOutcome step(World& world, Halos halos, StepTools& tools, Requests wanted);

/// kg of all ranks, exact. Collective.
double totalMass(const World& world, Reducer& all);

}  // namespace thaw
