// How walls act on particles: support of liquids (filling, pressure, drag), contact of solids, heat.
#pragma once
#include <span>

#include "core/contact/solid_contact.hpp"
#include "core/fluid/liquid_materials.hpp"
#include "core/walls/tables.hpp"
#include "core/world.hpp"

namespace thaw {

struct WallContext {
  World& world;
  const WallTables& tables;
  const std::vector<LiquidMaterial>& liquids;
  double dt;    ///< s, of the step that ends now; 0 at the start, when nothing is booked
  double span;  ///< s, of the step at hand: drag and heat are averaged over it, so that they cannot overshoot
  double fast = 1;  ///< 1 / substeps: contact of solids acts for that part of dt now, the rest is
                    ///< addSubstepContacts'
  const std::vector<std::uint8_t>* deep = nullptr;  ///< by owned row: sleeps so that nothing changes
                                                    ///< (core/sleep/); no force and no heat for it; null:
                                                    ///< none does
  bool sleeps(std::size_t i) const { return deep && (*deep)[i]; }
};

/// Lists the owned particles within a support radius of a wall. Particles deeper in a wall than half a
/// spacing are moved out to its surface, without their velocity into it; counted in
/// Counters::wallProjections, their kinetic energy booked as dissipated.
void findWallContacts(const WallContext& context, WallContacts& contacts);

/// Adds the walls' share to the filling (times 1 / lattice sum, as particles have it). At corners the shares
/// of several walls overlap like independent ones: 1 - prod(1 - filling_k).
void addWallFilling(const WallContext& context, double perLatticeSum, WallContacts& contacts);

/// Pressure on liquids, drag where the wall does not let slip, and for solids a
/// spring with dashpot and Coulomb friction within half a spacing of the wall. Work and impulse go to the
/// ledger.
void addWallForces(const WallContext& context, double perLatticeSum, WallContacts& contacts);

/// What contacts of solids take away beyond what they booked: half a kick lies on either side of now, and
/// energy changes as if by the velocity between them. After all forces.
void bookResistance(const WallContext& context, std::span<const ContactResistance> resisting);

/// What holds clamped particles, or drives them, balances all that acts on them: after all forces but those
/// of the viscous solver, which books its own.
void bookClamps(const WallContext& context, WallContacts& contacts);

/// Substeps: contacts of slots that may touch a wall before the step ends, at the places of now, by row; and
/// their springs, dashpots and friction at a later place, added to Solids::force. Work, impulse and losses
/// over context.dt go to the ledger and the particles.
void findSubstepContacts(const World& world, std::vector<WallContact>& contacts);
bool followContact(const World& world, WallContact& contact);  ///< distance and normal at the places of now;
                                                               ///< false: they do not touch
void addSubstepContacts(const WallContext& context, std::vector<WallContact>& contacts);
/// Drag (kg/s) of a wall on the liquid at it: times the velocity along the wall, relative to it. Of the
/// forces above where viscosity is explicit, averaged over the step; else of the implicit solver.
double wallDrag(const WallContext& context, const WallContact& contact);

/// Heat from walls that have a temperature.
void addWallHeat(const WallContext& context, const WallContacts& contacts);

}  // namespace thaw
