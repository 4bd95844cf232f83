// SPDX-License-Identifier: Apache-2.0
// The elastic step: displacement gradient by moving least squares over bonds (MKN04), stress, and forces
// gathered from both ends of each bond. With u_ij = x_ij - X_ij, A_i = sum_j w_ij X_ij X_ij^T:
//   grad u_i = (sum_j w_ij u_ij X_ij^T) A_i^-1,  F_i = 1 + grad u_i
//   energy of i: V_i psi(F_i) + k_i/2 sum_j w_ij |x_ij - F_i X_ij|^2,  k_i = alpha E_i V_i / tr A_i
// The second term is the hourglass control (G15), with the full error vector instead of its component along
// x_ij. F_i minimises that term, so its derivative through F_i is zero. The forces below are thus the exact
// derivative of the energy, which conserves momentum, angular momentum and energy. With flux_i = V_i P_i
// A_i^-1 - k_i grad u_i the force on i is
//   sum_j w_ij [ flux_i X_ij - flux_j X_ji + k_i (x_ij - X_ij) + k_j (x_ij + X_ji) ].
// The gradient alone is too soft for short waves, by a fraction (k dx)^2/6 with bonds of up to 2 spacings. It
// is also too soft for bending, since neighbourhoods at a surface are one-sided. The hourglass term is of the
// same order in dx. With alpha = 1.5, S waves along an axis have no second-order error. With bonds of 1.7
// spacings and alpha = 1.25, bending has almost none (benchmarks/accuracy: p_wave, cantilever). Bonds of 1.5
// spacings need alpha = 1, but halve the step of unevenly frozen solids.
#pragma once
#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "core/ledger/ledger.hpp"
#include "core/particles/continuum.hpp"
#include "core/particles/solids.hpp"
#include "core/scene/modules.hpp"
#include "core/scene/scene.hpp"
#include "core/solid/bonds/weight.hpp"
#include "core/solid/laws/elastic_constants.hpp"

namespace thaw {

struct ElasticKernels;
struct ReferenceKernels;

/// Inner: groups of 8 solids without bonds to remote rows, whose sums need no data of other ranks. Boundary:
/// the other groups.
enum class SolidPart { Inner, Boundary };

/// Work data of the elastic step. It is not part of the state: everything follows from the bonds.
struct ElasticWork {
  const ElasticKernels* kernels = nullptr;  ///< the bond loops; nullptr: the best set for this processor
  const ReferenceKernels* referenceKernels = nullptr;  ///< loops over bonds for reference data
  /// Loops with laws of extensions (LawKernels::deformation). There is one loop if all solids have the same
  /// law, else one per material. Empty without such laws.
  std::vector<LawLoop> lawLoops;
  // From the scene.
  std::vector<Material> materials;
  std::vector<ElasticConstants> solidConstants;  ///< by material, liquid fraction 0
  Precision precision = Precision::Single;
  double support = 0;          ///< m, upper limit of bond lengths
  double rereference = never;  ///< Numerics::plasticRereference
  Periods periods;
  double minBreakStretch = never;  ///< smallest value over all materials
  double touch = 0;  ///< m, distance below which unbonded solids repel each other; 0: no repulsion
  bool damping = false, plastic = false, periodic = false;
  bool energyInSteps = true, deformationInSteps = true;  ///< true: every evaluation computes Solids::energy
                                                         ///< and Solids::deformation; false:
                                                         ///< findElasticEnergy (solid_step.hpp) computes both
                                                         ///< on demand
  // From the bonds, by refreshReference.
  int capacity = 0;                            ///< capacity of the bonds described below
  std::vector<std::uint8_t> remoteGroup;       ///< by group: 1 if a bond has a remote end
  std::vector<std::uint32_t> inner, boundary;  ///< groups of owned solids
  std::vector<std::uint16_t> bondCount;        ///< by group: number of bonds of its longest row
  std::vector<std::uint8_t> ownFrames;  ///< by group: 1 if a bond has different references at its ends, X_ji
                                        ///< != -X_ij (only if bonds have vectors)
  std::vector<std::uint8_t> rank;       ///< by owned solid: rank of A
  std::vector<std::uint8_t> singularLanes;    ///< by group: bit l is set if the rank of solid l is < 3
  std::vector<std::uint8_t> flows;            ///< by owned solid, from phase 1: 1 if plastic strain changed
                                              ///< (rereference.hpp)
  std::vector<std::uint8_t> stretched;        ///< by group, from phase 1: 1 if a bond may exceed its stretch
                                              ///< limit (fracture.hpp)
  AlignedVector<double> perTrace, perWeight;  ///< by owned solid: 1/tr A (1/m^2) and 1/sum w; 0 without bonds
  AlignedVector<double> strainBound;  ///< by owned solid, 1/m: bound of the strain-displacement operator
                                      ///< (elasticStepLimit)
  // Sleep (core/sleep/sleep.hpp).
  bool sleeping = false;  ///< active groups are innerAwake and boundaryAwake
  std::vector<std::uint32_t> innerAwake, boundaryAwake;
  std::vector<std::uint8_t> plasticFixed;  ///< by owned solid: 1 if plastic strain is fixed; with
                                           ///< numerics.rigidify: 1 if the solid is passive
                                           ///< (active_solids.hpp)
  std::vector<double> groupStretch2;       ///< by group: largest squared stretch of the last evaluation
  // Velocity and drag by row, if bonds are damped; float or double by precision.
  AlignedVector<float> velocityDrag;
  AlignedVector<double> velocityDragDouble;
};

/// Calls work(first, last) for ranges of active owned solids: all solids, or the solids of awake groups.
template<class Work> void forEachAwake(const ElasticWork& elastic, const Solids& solids, const Work& work) {
  if (!elastic.sleeping) return work(std::size_t{0}, solids.owned);
  for (const std::vector<std::uint32_t>* groups : {&elastic.innerAwake, &elastic.boundaryAwake})
    for (const std::uint32_t g : *groups)
      work(std::size_t{g} * lanes, std::min<std::size_t>((std::size_t{g} + 1) * lanes, solids.owned));
}

struct ElasticStep {
  double dt = 0;            ///< s, for plastic flow and damping; 0: neither
  bool energy = true;       ///< also compute Solids::energy; needs deformation
  bool deformation = true;  ///< also store Solids::deformation
};

struct ElasticResult {
  std::int64_t inverted = 0;           ///< particles with det F <= 0
  std::int64_t softenedParticles = 0;  ///< particles without volume stiffness whose law weakens in
                                       ///< compression (core/solid/laws/law_point.hpp)
  double maxStretch2 = 1;  ///< upper bound of the squared principal elastic stretches (|Fe|^2 - 2)
  ElasticResult& operator+=(const ElasticResult& o) {
    inverted += o.inverted;
    softenedParticles += o.softenedParticles;
    if (o.maxStretch2 > maxStretch2) maxStretch2 = o.maxStretch2;
    return *this;
  }
};

/// Data that decide which fields and constants solids need.
struct SolidSetup {
  const Scene& scene;
  const Modules& modules;
  const CellGrid& grid;
};

/// Activates the fields of Solids, Bonds and Continuum that the scene's solids need, and sets the
/// constants of `work`. Call it once, before the first bond is made.
void activateSolidFields(Continuum& particles, Solids& solids, Bonds& bonds, ElasticWork& work,
                         const SolidSetup& setup);
/// Returns the fields that each step recomputes from positions and bonds. They have two thirds of the bytes,
/// and are unused before bonds exist.
std::vector<AnyColumn*> columnsOfSteps(Solids& solids, const ElasticWork& work);

/// Columns that remote rows need at three times:
/// - after rebuildBonds and before refreshReference (data that is constant as long as bonds are),
/// - before phase 1 (computeDeformationAndStress),
/// - before phase 2 (computeElasticForces).
/// A step is:
///   copyToSolids; begin(BeforeDeformation); phase 1 Inner; finish; phase 1 Boundary;
///   breakBonds (fracture.hpp); rereference (rereference.hpp); begin(BeforeForces); phase 2 Inner; finish;
///   phase 2 Boundary; addSolidForces.
ColumnList remoteColumnsAfterRebuild(Solids& solids);
ColumnList remoteColumnsBeforeDeformation(Solids& solids);
ColumnList remoteColumnsBeforeForces(Solids& solids);

/// Sets the reference configuration to the current positions, if all bonds share one configuration. Call it
/// before the initial bonds are made.
void takeReferences(const Continuum& particles, Solids& solids);
/// Copies positions (and velocities and liquid fractions, if active) from the particles to their owned
/// solids.
void copyToSolids(const Continuum& particles, Solids& solids);
/// Sets the rest volume (m^3, mass over the material's density) of owned solids that have none. These are
/// newly solid particles.
void fillNewSolids(const Continuum& particles, Solids& solids, const ElasticWork& work, bool atStart);
/// Adds the elastic force, and the dissipation of the step divided by dt, to the particles of owned solids.
/// Sleeping groups are skipped.
void addSolidForces(const ElasticWork& work, const Solids& solids, Continuum& particles, double dt);

/// Updates A^-1 and the other bond data in `work` for solids with `changed` set. all: updates all solids, for
/// bonds made without bond updates. Call it after every bond update and the exchange of
/// remoteColumnsAfterRebuild. A bond update also sets `changed` for renumbered solids. It sets it as well for
/// solids with a bond whose other end became remote or owned. The bits do not depend on which solids are
/// recomputed. Clears `changed`. Returns the number of owned solids with rank < 3.
std::int64_t refreshReference(ElasticWork& work, Solids& solids, Bonds& bonds, bool all);

/// Phase 1: F, plastic flow, stress and flux of the groups of this part. Requires: Solids::position of owned
/// rows; for Boundary also of remote rows, and a previous call for Inner.
ElasticResult computeDeformationAndStress(ElasticWork& work, Solids& solids, const Bonds& bonds,
                                          const ElasticStep& step, SolidPart part);

/// Repeats phase 1 for some groups after their bonds or references changed, without plastic flow;
/// Solids::dissipated stays.
void repeatDeformation(ElasticWork& work, Solids& solids, const Bonds& bonds, const ElasticStep& step,
                       std::span<const std::uint32_t> groups);

/// Phase 2: Solids::force (overwritten), hourglass energy and damping of the groups of this part. Requires:
/// phase 1 of both parts on this rank; for Boundary remoteColumnsBeforeForces on remote rows.
void computeElasticForces(ElasticWork& work, Solids& solids, Bonds& bonds, const ElasticStep& step,
                          SolidPart part);

/// Computes the Cauchy stress of all owned solids into Solids::stress (activated here) from F of the last
/// phase 1. For output.
void computeCauchyStress(const ElasticWork& work, Solids& solids);

/// The strain bound of a solid is sum_j |w_j A^-1 X_j| + |sum_j w_j A^-1 X_j|, in 1/m. It bounds the strain
/// per metre of neighbour displacement. The largest frequency of a body is below sqrt(0.45) c_p times the
/// strain bound. (Measured values of the square: 0.21 on a lattice, 0.25-0.35 in disorder, 0.45 in a crumpled
/// sheet.) At faces and corners of a lattice it is up to latticeStrainBound / spacing for bonds of at least
/// 1.5 spacings.
inline constexpr double latticeStrainBound = 4.75;
inline constexpr double flatStrainFactor = 1.4;  ///< factor for rows and sheets of particles: the
                                                 ///< frequency of a pair is c_p times the bound
/// Largest product, over the owned solids, of the strain bound (1/m) and the largest stretch of Fp^-1.
/// Plastic flow changed the reference by that stretch.
double largestStrainBound(const ElasticWork& work, const Solids& solids);
/// Returns the number of owned solids whose moment matrix has rank < 3.
std::int64_t countSingular(const ElasticWork& work, const Solids& solids);

/// Largest stable time step (s) of all materials that can be solid, and of bond damping: cflElastic * d /
/// c_p. d is the spacing, or latticeStrainBound / strainBound for neighbourhoods less regular than a lattice.
/// c_p is the wave speed of the stiffest state, with hourglass control, volume force and, for Green strain,
/// stiffening at the squared stretch maxStretch2.
double elasticStepLimit(const Scene& scene, double maxStretch2 = 1, double strainBound = 0);

}  // namespace thaw
