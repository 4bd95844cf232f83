// SPDX-License-Identifier: Apache-2.0
// Contact of solids of different bodies. Each solid particle has a kernel sum phi over the particles of other
// bodies. The kernel is wide enough to smooth their lattice. A particle is in contact if phi exceeds phi_0,
// the sum at one spacing from a flat surface:
//
//   phi_i = sum_j s_i s_j w(r_ij),   E_i = 1/2 c k_i (phi_i - phi_0)^2,   k_i = sum_j s_i s_j w k_ij / phi_i
//
// Here k_ij is the harmonic mean of E * spacing of the two particles. The factor c is such that two flat
// faces act as springs of stiffness k_ij per pair of facing particles. The share s of a particle is 1 if it
// lies half a spacing below the surface of its body. It is smaller at smaller depths
// (Continuum::contactDepth). Faces thus touch where the surfaces of the bodies meet. These forces are
// central: energy, momentum and angular momentum are conserved. Friction is a spring along the surface
// (CS79), limited by Coulomb's law, so it includes static friction. The spring's displacement is part of the
// state.
#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/contact/contact_pair.hpp"
#include "core/fluid/pair_sums/pair_sums.hpp"
#include "core/math/exact_sum.hpp"
#include "core/neighbours/grid.hpp"
#include "core/neighbours/mixed_cells.hpp"
#include "core/particles/continuum.hpp"
#include "core/particles/solids.hpp"
#include "core/scene/scene.hpp"

namespace thaw {

/// Distance (in spacings) below which solids of different bodies weld. The distance of touching faces is one
/// spacing. A particle above the middle of four particles of a face is 1.22 spacings from each of the four.
inline constexpr double weldDistance = 1.25;

/// Kernel of the sum over other bodies, and its value at a flat surface of a cubic lattice.
struct ContactKernel {
  /// Fraction of the radius at which (1 - r^2 / radius^2)^6 is steepest. At smaller distances the weight is
  /// linear, so that coincident particles separate.
  static constexpr double steepestAt = 0.30151134457776363;
  double radius = 0;        ///< m
  double touch = 0;         ///< 1, sum at one spacing from a flat surface
  double overlap = 0;       ///< 1, sum at half a spacing: the largest sum without force (contactRest)
  double slope = 0;         ///< 1/m, increase of the sum per distance towards the surface, at one spacing
  double overlapSlope = 0;  ///< 1/m, the same at half a spacing
  static constexpr int depths = 16;
  std::array<double, depths + 1> shares{};  ///< 1, shares of particles at depths of k / depths * 1/2 spacing

  /// Slope (1/m) of the sum where contact begins at the sum `rest`.
  double slopeAt(double rest) const;
  /// Share (1) of a particle with this Continuum::contactDepth.
  double share(float depth) const;
  /// Weight (1) at a distance r (m).
  double weight(double r) const;
  /// Minus the derivative of the weight (1/m) at a distance r (m).
  double steepness(double r) const;
};

/// Returns the kernel for a spacing (m) and a support radius (m). Its radius is two spacings, or the support
/// radius if that is smaller.
ContactKernel contactKernel(double spacing, double support);

/// A solid particle that has other bodies within reach.
struct BodyTouch {
  std::uint32_t row;
  std::uint32_t first, last;    ///< its pairs in BodyContactWork::pairs
  double energy = 0, rate = 0;  ///< J, W: its contact energy without friction, and its rate
  double sheared = 0;           ///< J, energy of its friction spring
  double lost = 0;              ///< W, loss by friction
  double shearStiffness = 0;    ///< N/m, of its friction spring
  Vec3d motion{};               ///< m/s, relative to the other bodies
  float liquid = 0;             ///< liquid fraction
  bool inContact = false;       ///< the particle or a neighbour has a contact force
  bool soon = false;            ///< it touches another body, or will touch one within two steps
};

struct BodyContactWork {
  ContactKernel kernel;
  MixedCells mixed;              ///< temporary
  std::vector<double> closing;   ///< m/s, approach velocity of each pair in the evaluation
  std::vector<ClosePair> pairs;  ///< solids of different bodies, by own row
  std::vector<BodyTouch> rows;
  std::vector<DissipativeForce> resistance;  ///< N, by row
};

struct BodyContactView {
  const Scene& scene;
  const CellGrid& grid;
  const CellTable& cells;
  const Solids& solids;
  const Bonds& bonds;
  Continuum& particles;
  BodyContactWork& work;
  double step;   ///< s, current step; dashpots remove at most a fifth of a pair's velocity in it
  double dt;     ///< s, length of the step that ends now; 0 for an evaluation without a step
  bool welding;  ///< particles of different bodies may have bonds
};

/// Sets the kernel. Call it once, before the functions below.
void prepareBodyContact(const Scene& scene, const CellGrid& grid, BodyContactWork& work);

/// Finds the solids that have other bodies within reach. Sets Continuum::bodyContact, contactRest and
/// contactShear; all rows are owned. frozen: Ledger::phaseJump if a particle just froze on any rank, else
/// null. It receives the contact energy (J) that freezing creates. Requires: positions, velocities, phases
/// and liquid fractions of ghosts.
void findBodyTouches(const BodyContactView& view, ExactSum* frozen);

/// Returns true if a particle of this rank touches another body, or will touch one within two steps.
bool touchesSoon(const BodyContactWork& work);

/// Adds the contact forces and energies of owned rows, in the order of their pairs, except for rows with
/// skipped[row] (empty: none). The dissipation uses the velocities of the force evaluation; recordResistance
/// adds the correction of second order in the step. Requires: Continuum::bodyContact of ghosts.
void addBodyContacts(const BodyContactView& view, std::span<const std::uint8_t> skipped);

/// Returns whether the contact energy of a row changes with the phase of its own particle.
bool changesStiffness(const BodyContactWork& work, const Continuum& particles);

/// Records the change of contact energies at fixed positions, like recordStiffnessChanges for pairs
/// (solid_contact.hpp). Requires: liquid fractions and phases of ghosts. next: s, the next step.
void recordStiffnessChanges(const BodyContactView& view, double next, ExactSum& phaseJump);

}  // namespace thaw
