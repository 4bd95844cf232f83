// SPDX-License-Identifier: Apache-2.0
// Work data of a step.
#pragma once
#include <cstdint>
#include <memory>
#include <vector>

#include "core/contact/body_contact.hpp"
#include "core/contact/solid_contact.hpp"
#include "core/domain/emit.hpp"
#include "core/domain/field_update.hpp"
#include "core/domain/model_part.hpp"
#include "core/domain/outside_forces.hpp"
#include "core/flow/density/carry_work.hpp"
#include "core/flow/implicit_viscosity/viscous_work.hpp"
#include "core/flow/incompressible/pressure_work.hpp"
#include "core/fluid/laws/surface_energy.hpp"
#include "core/fluid/pair_sums/extension_pair_force.hpp"
#include "core/fluid/pair_sums/pair_kernels.hpp"
#include "core/fluid/pair_sums/pair_sums.hpp"
#include "core/fluid/pair_sums/records.hpp"
#include "core/geometry/basic/signed_distance.hpp"
#include "core/halo/halo.hpp"
#include "core/heat/conduction_correction.hpp"
#include "core/heat/contact_heat.hpp"
#include "core/kernels/viscous_weight.hpp"
#include "core/ledger/leaver.hpp"
#include "core/materials/liquid_materials.hpp"
#include "core/neighbours/search.hpp"
#include "core/neighbours/sort.hpp"
#include "core/oriented/data/oriented_work.hpp"
#include "core/rigid/data/rigid_work.hpp"
#include "core/simulation/time/monitor_limits.hpp"
#include "core/simulation/time/step_limits.hpp"
#include "core/simulation/workspace/phase_energy.hpp"
#include "core/simulation/workspace/step_hooks.hpp"
#include "core/simulation/workspace/step_phases.hpp"
#include "core/sleep/sleep.hpp"
#include "core/solid/elasticity/elastic.hpp"
#include "core/time/phase_times.hpp"
#include "core/walls/tables.hpp"

namespace thaw {

/// Work data of a step, made once (core/simulation/setup/) and reused. Not part of the state.
struct StepTools {
  const PairKernels* kernels = nullptr;
  std::vector<LiquidMaterial> liquids;
  StepLimits fixedLimits;  ///< from materials
  MonitorLimits watch;
  std::vector<EmitterPlan> emitters;
  std::vector<std::shared_ptr<const SignedDistance>> shapes;  ///< shapes of the bodies until they are
                                                              ///< sampled; meshes are slow to make
  WallTables wallTables;
  ViscousWeight viscousWeight;   ///< for pairwise viscosity
  double inverseLatticeSum = 1;  ///< factor that turns sums over V W into relative densities
  SurfaceMeasure surface;        ///< for surface tension as an energy
  double tensionInterval = 0;    ///< s, tensionInterval
  double selfExcess = 0;         ///< subtracted from a particle's relative density, per V0 / h^3 of its own
                                 ///< (terms/density.hpp)
  double stableViscousStep = 0;  ///< largest stable dt nu / h^2 on the lattice
  double conductionScale = 1;    ///< for heat conduction, see kernels/lattice.hpp
  double relativeDensityScale = 1;  ///< inverseLatticeSum / h^3
  SortBuffers sort;
  SearchBuffers search;
  PairRecords records;
  std::vector<std::uint8_t> inner, liquidCells;
  std::size_t ghostRoom = 1024;  ///< rows reserved for ghosts between the owned rows and the dummy row
  ClosePairs closePairs;
  BodyContactWork bodyContact;
  std::vector<WallShare> wallShares;  ///< by owned row, with corrected viscosity
  CarryWork carry;
  std::vector<DissipativeForce> contactResistance;
  WallContacts wallContacts;
  PhaseEnergyWork phaseEnergy;
  std::vector<WallContact> substepContacts;  ///< solids that may touch a wall in this step
  double longestContact = never;  ///< s, limit of a substep by wall contacts of solids, from materials
  PressureWork pressure;
  ElasticWork elastic;
  ViscousWork viscous;
  OrientedWork oriented;
  SleepWork sleep;
  RigidWork rigid;
  ContactHeatWork contactHeat;
  ConductionWork conduction;
  std::vector<BondRequest> requests;
  std::vector<std::uint32_t> rebonded;  ///< rows of particles with new bonds
  std::vector<OutsideSource> outside;   ///< with Continuum::outsideForce
  std::vector<ActiveTerm> terms;        ///< terms of the scene, in the order of their list
  std::vector<PairForceWork> pairForces;
  std::vector<const PairSweep*> sweeps;  ///< sums of the scene's terms, in their order
  std::vector<FieldUpdate> fieldUpdates;
  StepPhases phases;  ///< calls of the scene's modules
  StepHooks hooks;
  std::vector<std::uint32_t> leaving;
  std::vector<Leaver> leavers;  ///< from all ranks; empty without surface tension
  PhaseTimes times;
  // Carried from one step to the next; recomputed after a restart.
  bool bondsAtStart = false;  ///< the next evaluation makes the initial bonds
  bool mayLeave = true;       ///< a particle may be beyond an open side; false: the drift found none
  bool newPartition = true;   ///< cell owners may differ from the last evaluation
  bool looseMemory = false;   ///< the last evaluation had a new partition, and its temporary memory is free
  bool emitFirst = false;     ///< the next evaluation also emits layers that leave at time 0
  bool phaseChangedHere = false;  ///< on this rank, since the last bond update
  bool frozeAnywhere = false;     ///< some particle just froze on some rank
  bool meltedAnywhere = false;    ///< some solid melted in this step on some rank
  double mass = 0;                ///< kg, of all ranks
  double maxStretch2 = 1;         ///< squared largest stretch of this rank
};

}  // namespace thaw
