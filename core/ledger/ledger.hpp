// SPDX-License-Identifier: Apache-2.0
// The ledger of a run: present amounts, inflow, outflow, dissipation, and the unexplained residual.
#pragma once
#include <cstdint>
#include <vector>

#include "core/math/exact_sum.hpp"
#include "core/math/vec3.hpp"

namespace thaw {

/// A set of conserved quantities in SI units. Angular momentum is about the origin.
struct Balance {
  double mass = 0;                                               // kg
  Vec3d momentum{}, angularMomentum{};                           // kg m/s, kg m^2/s
  double kinetic = 0, elastic = 0, potential = 0, internal = 0;  // J; internal: heat and latent heat;
                                                                 // potential: gravity and contacts
};

/// A balance with exact sums, which can be added over ranks.
struct ExactBalance {
  ExactSum mass, momentum[3], angularMomentum[3], kinetic, elastic, potential, internal;
};

/// Energies (J) of all lamps, of all lasers, or of all heated regions. Energy that is neither absorbed nor
/// reflected missed all bodies or hit an obstacle.
struct SourceSums {
  ExactSum given, absorbed, reflected;
};

/// Use of one lamp, laser or heated region.
struct SourceUse {
  double given = 0;           ///< J, the same on all ranks
  std::int64_t absorbed = 0;  ///< 1: a particle of this rank has absorbed energy of the source, else 0
};

/// Flows since the start, on this rank only. Only sums over all ranks are meaningful. The ledger is in every
/// checkpoint.
struct Ledger {
  ExactBalance entered, left;  ///< emitters, open sides
  ExactSum dissipated;      ///< J, of particles that left, and of rigid pieces; other dissipation is in the
                            ///< `dissipated` columns of particles
  ExactSum wallWork;        ///< J, work on particles by moving obstacles, emitters and forces from outside
  ExactSum wallImpulse[3];  ///< N s, impulse on particles from obstacles, constraints and forces from outside
  ExactSum wallForce[3];    ///< N, current force of obstacles, constraints and forces from outside; half of
                            ///< the next kick is outstanding
  ExactSum gravityImpulse[3];  ///< N s, for entered minus left mass; the total adds initial.mass * g * time
  ExactSum heatIn;             ///< J, heat through obstacles, sources and surfaces
  ExactSum phaseJump;    ///< J, elastic energy that melting, freezing, fracture and new references removed (>
                         ///< 0) or created (< 0)
  ExactSum restartJump;  ///< J, stored energy that changed coefficients created (> 0) or removed (< 0) at a
                         ///< restart
  SourceSums lamps, lasers, regions;  ///< the absorbed parts are in heatIn
  std::vector<SourceUse> sourceUse;   ///< lamps, then lasers, then heated regions; empty before their first
                                      ///< evaluation
  ExactSum evaporated;                ///< kg, vapour; also in left.mass
  ExactSum vapourHeat;                ///< J, latent heat of the vapour; minus this is in heatIn
  Balance initial;                    ///< global, at time 0
};

}  // namespace thaw
