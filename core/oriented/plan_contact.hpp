// What holds particles of the continuum off an oriented surface, from what the scene says of masses, speeds
// and stiffness.
#pragma once
#include <span>
#include <vector>

#include "core/contact/touch.hpp"
#include "core/fluid/liquid_materials.hpp"

namespace thaw {

/// Contact of an oriented body with the continuum: a spring of OrientedBody::contact times its stiffness
/// (N/m), and beside it a barrier (TouchLaw) that lets nothing through between the particles of either.
struct OrientedContact {
  double reach = 0;   ///< m, distance of centres at which it begins: 0.55 of the sum of the spacings
  double room = 0;    ///< m, depth at which a particle is in the widest gap that the other's lattice has
  double spring = 0;  ///< N/m
  double bonds = 0;   ///< N/m, least barrier: what the surface's own bonds can pull with
  std::vector<double> rate;  ///< 1/s, of each material of the scene: the barrier is a particle's mass times
                             ///< its square
  double mass = 0;           ///< kg, of an oriented particle
};

/// Of each oriented body. The barrier pushes with b at `room`, 2 b room, and has stored b room^2 / 2 there. b
/// is the largest of m (2 v / room)^2, which stops a particle of mass m at the speed v of the scene (falls
/// through the domain, starts, obstacles, anchors) four times over; m c v / (2 s room) with the speed of
/// sound c of its material and the spacing s, three times what bears the pressure rho c v of a body that a
/// held surface stops at once; and what bonds ask for that drag the surface's particles into a body.
std::vector<OrientedContact> planOrientedContact(const Scene& scene, std::span<const LiquidMaterial> liquids);

/// Contact of an oriented body with obstacles: a spring of OrientedBody::contact times its stiffness from its
/// `thickness` on, and beside it a barrier with the energy b depth^4 / (2 room^2).
struct ObstacleContact {
  double keep = 0;    ///< m, distance at which it begins
  double room = 0;    ///< m, depth up to which the barrier grows: there a particle is in the obstacle. Deeper
                      ///< the barrier's force stays as it is
  double spring = 0;  ///< N/m
  double barrier = 0;  ///< N/m, b
};

/// Of each oriented body. b is the larger of m (2 v / room)^2, of a particle's mass and the speed of the
/// scene, and of what its bonds ask for that drag it into an obstacle, as with bodies.
std::vector<ObstacleContact> planObstacleContact(const Scene& scene);

struct ObstaclePush {
  double force = 0;   ///< N
  double energy = 0;  ///< J
  double slope = 0;   ///< N/m, of the barrier's force
};
/// At a depth (m) above 0.
ObstaclePush pushAt(const ObstacleContact& contact, double depth);

/// The law of a pair with a particle of this material and mass (kg); span: s, of the step at hand.
TouchLaw contactLaw(const OrientedContact& contact, std::size_t material, double mass, double span);

}  // namespace thaw
