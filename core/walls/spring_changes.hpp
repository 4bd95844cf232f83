// SPDX-License-Identifier: Apache-2.0
// Change of the energy of wall springs with the phase. Melting changes the length and stiffness of springs.
#pragma once
#include <cstdint>
#include <vector>

#include "core/walls/wall_forces.hpp"

namespace thaw {

/// Spring of a particle near a wall, before heat changes the phase. For particles of rigid pieces the
/// stiffness is 0.
struct SpringState {
  std::uint32_t row;
  WallSpring spring;
};

/// Lengths of the next step and of its substeps.
struct NextStepLengths {
  double step, substep;  ///< s
};

/// Lists the particles within reach of wall springs that may melt or freeze.
void listSpringStates(const WallContext& context, const WallContacts& contacts,
                      std::vector<SpringState>& springs);

/// Records the change of the energy of these springs at fixed positions in Ledger::phaseJump and
/// Continuum::interaction. It is exact for any change of the phase. The ledger also receives the work of the
/// next half kick, which still uses the force before the change.
void recordSpringChanges(const WallContext& context, const WallContacts& contacts,
                         const std::vector<SpringState>& springs, const NextStepLengths& next);

}  // namespace thaw
