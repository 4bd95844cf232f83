// The elastic step: displacement gradient by moving least squares over bonds (MKN04), stress, and forces by
// gather from both ends of each bond. With u_ij = x_ij - X_ij, A_i = sum_j w_ij X_ij X_ij^T:
//   grad u_i = (sum_j w_ij u_ij X_ij^T) A_i^-1,  F_i = 1 + grad u_i
//   energy of i: V_i psi(F_i) + k_i/2 sum_j w_ij |x_ij - F_i X_ij|^2,  k_i = alpha E_i V_i / tr A_i
// The second term is the hourglass control (Ganzenmueller 2015, "An hourglass control algorithm for
// Lagrangian smooth particle hydrodynamics") with the whole error vector in place of its length along x_ij.
// F_i minimises that term, so its derivative through F_i is zero and the forces below are the exact
// derivative of the energy, which conserves momentum, angular momentum and energy. With flux_i = V_i P_i
// A_i^-1 - k_i grad u_i the force on i is
//   sum_j w_ij [ flux_i X_ij - flux_j X_ji + k_i (x_ij - X_ij) + k_j (x_ij + X_ji) ].
// The gradient alone is too soft for short waves, by a share (k dx)^2/6 at bonds of up to 2 spacings, and for
// bending, since at a surface the neighbourhood lies to one side. The penalty is of the same order in dx:
// with alpha = 1.5 S waves along an axis have no error of second order, and with bonds of 1.7 spacings and
// alpha = 1.25 bending has next to none (benchmarks/accuracy: p_wave, cantilever). With bonds of 1.5 spacings
// alpha = 1 does, but what froze unevenly then needs steps half as long.
#pragma once
#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "core/ledger/ledger.hpp"
#include "core/particles/continuum.hpp"
#include "core/scene/modules.hpp"
#include "core/scene/scene.hpp"
#include "core/solid/elastic_constants.hpp"
#include "core/solid/solids.hpp"
#include "core/solid/weight.hpp"

namespace thaw {

struct ElasticKernels;
struct ReferenceKernels;

/// Inner groups of 8 slots have no bonds to remote rows: their sums need nothing from other ranks.
enum class SolidPart { Inner, Boundary };

/// What the elastic step keeps between calls beside the tables. Not part of the state: all of it is
/// recomputed from bonds.
struct ElasticWork {
  const ElasticKernels* kernels = nullptr;  ///< the loops over bonds; nullptr: the best for this processor
  const ReferenceKernels* referenceKernels = nullptr;  ///< the same of what is found from bonds alone
  // of the scene
  std::vector<Material> materials;
  std::vector<ElasticConstants> solidConstants;  ///< by material, liquid fraction 0
  Precision precision = Precision::Single;
  double support = 0;          ///< m, of bonds
  double rereference = never;  ///< Numerics::plasticRereference
  Periods periods;
  double minBreakStretch = never;  ///< the smallest of all materials
  double touch = 0;  ///< m, distance below which solids without a bond push each other (0: they do not)
  bool damping = false, plastic = false, periodic = false;
  bool energyInSteps = true, deformationInSteps = true;  ///< every evaluation finds Solids::energy and
                                                         ///< Solids::deformation; else findElasticEnergy
                                                         ///< (solid_step.hpp), where they are asked for
  // of the bonds, by refreshReference
  int capacity = 0;                            ///< of the bonds that the rest is of
  std::vector<std::uint8_t> remoteGroup;       ///< by group: some bond has a remote end
  std::vector<std::uint32_t> inner, boundary;  ///< groups of owned slots
  std::vector<std::uint16_t> bondCount;        ///< by group: bonds of its longest row
  std::vector<std::uint8_t> ownFrames;  ///< by group: of some bond each end has a reference of its own, X_ji
                                        ///< != -X_ij (only where bonds have vectors)
  std::vector<std::uint8_t> rank;       ///< by owned slot: rank of A
  std::vector<std::uint8_t> singularLanes;    ///< by group: bit l: rank of slot l < 3
  std::vector<std::uint8_t> flows;            ///< by owned slot, by phase 1: its plastic strain has changed
                                              ///< (rereference.hpp)
  std::vector<std::uint8_t> stretched;        ///< by group, by phase 1: some bond may be beyond its limit
                                              ///< (fracture.hpp)
  AlignedVector<double> perTrace, perWeight;  ///< by owned slot: 1/tr A (1/m^2) and 1/sum w; 0 without bonds
  AlignedVector<double> grip;  ///< by owned slot, 1/m: how hard the strain of its neighbourhood grips
                               ///< (elasticStepLimit)
  // where solids sleep (core/sleep/sleep.hpp)
  bool sleeping = false;  ///< groups are innerAwake and boundaryAwake
  std::vector<std::uint32_t> innerAwake, boundaryAwake;
  std::vector<std::uint8_t> held;     ///< by owned slot: its plastic strain does not change
  std::vector<double> groupStretch2;  ///< by group: the largest square of a stretch, as last found
  // velocity and drag by row, where bonds are damped; float or double by precision
  AlignedVector<float> motion4;
  AlignedVector<double> motion4d;
};

/// Calls work(first, last) for owned slots that are worked on: all, or those of groups that are awake.
template<class Work> void forEachAwake(const ElasticWork& elastic, const Solids& solids, const Work& work) {
  if (!elastic.sleeping) return work(std::size_t{0}, solids.owned);
  for (const std::vector<std::uint32_t>* groups : {&elastic.innerAwake, &elastic.boundaryAwake})
    for (const std::uint32_t g : *groups)
      work(std::size_t{g} * lanes, std::min<std::size_t>((std::size_t{g} + 1) * lanes, solids.owned));
}

struct ElasticStep {
  double dt = 0;            ///< s, for plastic flow and damping; 0: none
  bool energy = true;       ///< also sum Solids::energy; needs deformation
  bool deformation = true;  ///< also keep Solids::deformation
};

struct ElasticResult {
  std::int64_t inverted = 0;  ///< particles with det F <= 0
  std::int64_t squeezed = 0;  ///< of Green strain without volume stiffness: with a principal stretch below
                              ///< sqrt(1/3), where the law weakens
  double maxStretch2 = 1;     ///< upper bound of the square of the principal elastic stretches (|Fe|^2 - 2)
  ElasticResult& operator+=(const ElasticResult& o) {
    inverted += o.inverted;
    squeezed += o.squeezed;
    if (o.maxStretch2 > maxStretch2) maxStretch2 = o.maxStretch2;
    return *this;
  }
};

/// Switches on the fields of Solids, Bonds and Continuum that the scene's solids need, and fills the
/// constants of `work`. Once, before the first bond is made.
void activateSolidFields(Continuum& particles, Solids& solids, Bonds& bonds, ElasticWork& work,
                         const Scene& scene, const Modules& modules, const CellGrid& grid);
/// Of these fields those that each step finds anew from places and bonds, two thirds of the bytes: nobody
/// asks for them before there are bonds.
std::vector<AnyColumn*> columnsOfSteps(Solids& solids, const ElasticWork& work);

/// Columns that remote rows need: after relink and before refreshReference (what does not change while bonds
/// stay), before phase 1 (computeDeformationAndStress), and before phase 2 (computeElasticForces). A step is:
///   copyToSolids; begin(BeforeDeformation); phase 1 Inner; finish; phase 1 Boundary;
///   breakBonds (fracture.hpp); rereference (rereference.hpp); begin(BeforeForces); phase 2 Inner; finish;
///   phase 2 Boundary; addSolidForces.
ColumnList remoteColumnsAfterRelink(Solids& solids);
ColumnList remoteColumnsBeforeDeformation(Solids& solids);
ColumnList remoteColumnsBeforeForces(Solids& solids);

/// The reference configuration, where all bonds are of one: the places of now. Before the bonds of the start
/// are made.
void takeReferences(const Continuum& particles, Solids& solids);
/// Copies position (and velocity, liquid fraction where they are active) of the owned slots' particles.
void copyToSolids(const Continuum& particles, Solids& solids);
/// Volume at rest (mass over the material's density) of owned slots that have none: of particles that have
/// just become solid.
void fillNewSlots(const Continuum& particles, Solids& solids, const ElasticWork& work, bool atStart);
/// Adds the elastic force (and what was dissipated in the step, divided by dt) to the particles of the owned
/// slots; of groups that sleep nothing.
void addSolidForces(const ElasticWork& work, const Solids& solids, Continuum& particles, double dt);

/// A^-1 of slots with `changed` set (of all slots if all: where bonds were made by hand), and what else
/// `work` keeps of bonds. After every relink and the exchange of remoteColumnsAfterRelink, which sets
/// `changed` also where a slot got another number, or a bond's other end became remote or owned. The same
/// bits whether a slot is recomputed or not. Clears `changed`. Returns how many owned slots have rank < 3.
std::int64_t refreshReference(ElasticWork& work, Solids& solids, Bonds& bonds, bool all);

/// Phase 1: F, plastic flow, stress and flux of the groups of this part. Inner needs Solids::position of
/// owned rows and must come before Boundary, which needs it of remote rows too.
ElasticResult computeDeformationAndStress(ElasticWork& work, Solids& solids, const Bonds& bonds,
                                          const ElasticStep& step, SolidPart part);

/// Phase 1 again for some groups, after their bonds or references changed; no plastic flow,
/// Solids::dissipated stays.
void repeatDeformation(ElasticWork& work, Solids& solids, const Bonds& bonds, const ElasticStep& step,
                       std::span<const std::uint32_t> groups);

/// Phase 2: Solids::force (overwritten), hourglass energy and damping of the groups of this part. Needs phase
/// 1 of both parts on this rank; Boundary needs remoteColumnsBeforeForces on remote rows.
void computeElasticForces(ElasticWork& work, Solids& solids, Bonds& bonds, const ElasticStep& step,
                          SolidPart part);

/// Solids::energy of all owned slots at the current positions of owned and remote rows, without plastic flow;
/// overwrites deformation and force. Where bonds are made or dropped (freezing, melting) the jump of elastic
/// energy is the exact sum of energy over owned slots before relink minus that after relink,
/// refreshReference, an exchange of positions and this.
void evaluateElasticEnergy(ElasticWork& work, Solids& solids, const Bonds& bonds);

/// Cauchy stress of all owned slots into Solids::stress (activates it), from F of the last phase 1; for
/// output.
void computeCauchyStress(const ElasticWork& work, Solids& solids);

/// The neighbourhoods that bound the time step: grip of a slot is sum_j |w_j A^-1 X_j| + |sum_j w_j A^-1
/// X_j|, 1/m, what one metre of its neighbours' displacement makes of strain. The largest frequency of a body
/// is below sqrt(.45) c_p grip (measured: .21 of the square on a lattice, .25-.35 in disorder, .45 in a
/// crumpled sheet); a lattice's faces and corners have up to latticeGrip / spacing at bonds of 1.5 spacings
/// and more.
inline constexpr double latticeGrip = 4.75;
inline constexpr double flatGrip = 1.4;  ///< factor of the grip of rows and sheets: a pair's frequency is c_p
                                         ///< grip, with nothing below
/// 1/m, of the owned slots; times the largest stretch of Fp^-1 of each, which plastic flow has added to the
/// reference.
double largestGrip(const ElasticWork& work, const Solids& solids);
/// owned slots whose moment matrix has rank < 3
std::int64_t countSingular(const ElasticWork& work, const Solids& solids);

/// Largest stable time step (s) of all materials that can be solid: cflElastic * d / c_p, where d is the
/// spacing, or latticeGrip / grip where neighbourhoods are less even than on a lattice, with c_p of the
/// stiffest state, hourglass control, volume force and (Green strain) stiffening by the given square of
/// stretch included; and of bond damping.
double elasticStepLimit(const Scene& scene, double maxStretch2 = 1, double grip = 0);

}  // namespace thaw
