// SPDX-License-Identifier: Apache-2.0
// Contact laws of oriented surfaces, from masses, speeds and stiffness in the scene.
#pragma once
#include <span>
#include <vector>

#include "core/contact/touch.hpp"
#include "core/materials/liquid_materials.hpp"

namespace thaw {

/// Contact of an oriented body with the continuum. It has a spring of OrientedBody::contact times its
/// stiffness (N/m), and a barrier (TouchLaw) that stops particles from passing through.
struct OrientedContact {
  double reach = 0;          ///< m, distance between centres at which contact begins: 0.55 of the sum of the
                             ///< spacings
  double room = 0;           ///< m, depth of a particle in the widest gap of the other lattice
  double spring = 0;         ///< N/m
  double bonds = 0;          ///< N/m, smallest barrier, which is stronger than the surface's own bonds
  std::vector<double> rate;  ///< 1/s, one per material: the barrier is a particle's mass times the squared
                             ///< rate
  double mass = 0;           ///< kg, mass of an oriented particle
};

/// Returns the contact of each oriented body. The barrier's force at `room` is 2 b room, its energy b room^2
/// / 2. b is the largest of
/// - m (2 v / room)^2, which stops mass m at four times the energy of the scene's speed v (falls, initial
/// velocities, obstacles, constraints);
/// - m c v / (2 s room), with sound speed c and spacing s. It is three times the water-hammer pressure rho c
/// v of a body stopped by a fixed surface;
/// - the strength of bonds that pull the surface into a body.
std::vector<OrientedContact> planOrientedContact(const Scene& scene, std::span<const LiquidMaterial> liquids);

/// Contact of an oriented body with obstacles: a spring and a barrier. The spring starts at `thickness` and
/// has OrientedBody::contact times the stiffness. The barrier has the energy b depth^4 / (2 room^2).
struct ObstacleContact {
  double keep = 0;  ///< m, distance at which contact begins
  double room = 0;  ///< m, depth of a particle on the obstacle's surface. The barrier grows up to this depth,
                    ///< and its force is constant beyond
  double spring = 0;   ///< N/m
  double barrier = 0;  ///< N/m, b
};

/// Returns the obstacle contact of each oriented body. b is the larger of m (2 v / room)^2 and the
/// strength of bonds, as for the continuum. m: mass of a particle. v: speed of the scene.
std::vector<ObstacleContact> planObstacleContact(const Scene& scene);

struct ObstacleForce {
  double force = 0;   ///< N
  double energy = 0;  ///< J
  double slope = 0;   ///< N/m, slope of the barrier's force
};
/// Returns contact force, energy and slope at a depth (m) above 0.
ObstacleForce obstacleForceAt(const ObstacleContact& contact, double depth);

/// Returns the law of a pair with a particle of this material and mass (kg). span: s, length of the current
/// step.
TouchLaw contactLaw(const OrientedContact& contact, std::size_t material, double mass, double span);

}  // namespace thaw
