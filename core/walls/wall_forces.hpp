// SPDX-License-Identifier: Apache-2.0
// Wall forces on particles: support of liquids (relative density, pressure, drag), contact of solids, heat.
#pragma once
#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "core/contact/solid_contact.hpp"
#include "core/materials/liquid_materials.hpp"
#include "core/walls/tables.hpp"
#include "core/walls/wall_view.hpp"

namespace thaw {

struct WallContext {
  WallView world;
  const WallTables& tables;
  const std::vector<LiquidMaterial>& liquids;
  double dt;        ///< s, step that ends now; 0 at the start, when nothing is recorded
  double span;      ///< s, length of the current step; drag and heat are limited so that they do not
                    ///< overshoot within it
  double fast = 1;  ///< 1 / substeps: contact of solids acts for this fraction of dt now; addSubstepContacts
                    ///< applies the remainder
  const std::vector<std::uint8_t>* steady = nullptr;  ///< by owned row: 1 if it sleeps with unchanged sums
                                                      ///< (core/sleep/), and thus gets no force and heat.
                                                      ///< null: no such rows
  bool sleeps(std::size_t i) const { return steady && (*steady)[i]; }
};

/// Spring of a particle's contact with walls. It acts on solids within half a spacing. On liquids, which are
/// also supported by pressure, it acts within a quarter of a spacing.
struct WallSpring {
  double length = 0;     ///< m, distance below which it pushes
  double stiffness = 0;  ///< N/m

  /// Returns the energy (J) at a distance (m) from the wall.
  double energy(double distance) const {
    const double gap = std::max(0.0, length - distance);
    return 0.5 * std::max(0.0, stiffness) * gap * gap;
  }
  /// Returns the force (N) away from the wall at this distance (m).
  double force(double distance) const { return std::max(0.0, stiffness) * std::max(0.0, length - distance); }
};
/// Maximum length of a spring, in spacings.
inline constexpr double longestSpring = 0.5;

WallSpring wallSpring(const WallContext& context, std::size_t row);

/// Lists the owned particles within a support radius of a wall. Particles deeper in a wall than half a
/// spacing are moved back to that depth and lose their velocity into it. Counters::wallProjections counts
/// them. Their loss of kinetic energy and contact energy is recorded as dissipation.
void findWallContacts(const WallContext& context, WallContacts& contacts);

/// Records the work of weight, pressure and elastic forces on particles that findWallContacts moved and
/// stopped. Call it before forces of contacts are added.
void recordProjections(const WallContext& context, const WallContacts& contacts);

struct WallSupport {
  const WallTables& tables;
  double support;  ///< m
};
/// Returns WallContact::share of a contact: the fraction of its pressure force that other contacts of the
/// particle do not cover.
double pressureShare(const WallSupport& support, std::span<const WallContact> contacts, std::size_t contact);

/// Returns 1 - 2 angle / pi for two directions: 1 if they are equal, 0 at right angles, -1 if opposite.
double alignment(const Vec3d& n, const Vec3d& m);

/// Returns the contacts of a row. Requires: the list is ordered by rows, as findWallContacts leaves it.
std::span<const WallContact> contactsOf(const WallContacts& contacts, std::uint32_t row);

/// Contribution of the walls that touch a particle to the sum over V W. At corners, contributions of several
/// walls overlap as if independent: 1 - prod(1 - delta_k). added: buffer for one value per contact.
double wallRelativeDensity(const WallSupport& support, std::span<const WallContact> contacts,
                           std::vector<double>& added);

/// Adds the contribution of walls to the relative density (times 1 / lattice sum, as for particles).
void addWallRelativeDensity(const WallContext& context, double inverseLatticeSum, WallContacts& contacts);

/// Adds pressure on liquids and the drag of walls without slip. Solids within half a spacing of the wall get
/// a spring with dashpot and Coulomb friction. Work and impulse are recorded in the ledger.
void addWallForces(const WallContext& context, double inverseLatticeSum, WallContacts& contacts);

/// Records the dissipation of solid contacts that the evaluation missed. The loss depends on the velocity in
/// the half kicks before and after the evaluation. Call it after all forces.
void recordResistance(const WallContext& context, std::span<const DissipativeForce> dissipativeForce);

/// Records the constraint forces of clamped and driven particles, which balance all forces on them. Call it
/// after all forces except those of the viscous solver, which records its own constraint forces.
void recordClamps(const WallContext& context, WallContacts& contacts);

/// Contacts in substeps: findSubstepContacts lists contacts, by row, of solids that may touch a wall before
/// the step ends. followContact updates one contact. addSubstepContacts adds springs, dashpots and friction
/// at a later position to Solids::force. Work, impulse and losses over context.dt are recorded in the ledger
/// and the particles.
void findSubstepContacts(const WallView& world, std::vector<WallContact>& contacts);
bool followContact(const Continuum& particles, const Scene& scene, const Walls& walls,
                   WallContact& contact);  ///< updates distance and normal to the current
                                           ///< position; false: no contact
void addSubstepContacts(const WallContext& context, std::vector<WallContact>& contacts);
/// Drag coefficient (kg/s) of a wall on liquid, for the relative velocity along the wall. With explicit
/// viscosity, addWallForces limits it for the step. Otherwise the implicit solver uses it.
double wallDrag(const WallContext& context, const WallContact& contact);

/// Adds heat from walls that have a temperature.
void addWallHeat(const WallContext& context, const WallContacts& contacts);

}  // namespace thaw
