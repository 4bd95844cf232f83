// SPDX-License-Identifier: Apache-2.0
// Energy of springs on walls that changes with the phase: melting changes their length and stiffness.
#pragma once
#include <cstdint>
#include <vector>

#include "core/walls/wall_forces.hpp"

namespace thaw {

/// Spring of a particle near a wall, before heat changes its phase. Particles of rigid pieces have none: a
/// stiffness of 0.
struct SpringState {
  std::uint32_t row;
  WallSpring spring;
};

/// Lengths of the next step and of its substeps.
struct NextStepLengths {
  double step, substep;  ///< s
};

/// Lists the particles that may melt or freeze within reach of springs.
void listSpringStates(const WallContext& context, const WallContacts& contacts,
                      std::vector<SpringState>& springs);

/// Records the change of the energy of these springs at the same positions in Ledger::phaseJump and
/// Continuum::interaction, exactly for any change of the phase. The ledger also takes the work of the next
/// half kick, which still has the force before the change.
void recordSpringChanges(const WallContext& context, const WallContacts& contacts,
                         const std::vector<SpringState>& springs, const NextStepLengths& next);

}  // namespace thaw
