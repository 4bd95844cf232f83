// SPDX-License-Identifier: Apache-2.0
// Energies of an evaluation, kept until heat has changed the phases at the end of the step.
#pragma once
#include <vector>

#include "core/contact/solid_contact.hpp"
#include "core/math/vec3.hpp"
#include "core/walls/spring_changes.hpp"

namespace thaw {

struct PhaseEnergyWork {
  std::vector<double> ofPairs;  ///< J, Continuum::interaction of owned rows before contacts: compression and
                                ///< tension; only where volumes change with the phase or by evaporation
  std::vector<double> inPairs;  ///< J, pairwise tension and pair forces of extensions, by owned row
  std::vector<float> liquid;    ///< liquid fractions of owned rows, where these exist
  std::vector<SpringState> springs;
  std::vector<TouchingPair> touching;
  std::vector<double> energy, dissipation;  ///< J, W; temporary
  std::vector<Vec3d> force;                 ///< N, temporary
};

/// Changes of phases since the start of a step, and their energies.
struct PhaseChangeWork {
  PhaseEnergyWork energy;
  bool here = false;            ///< on this rank, since the last bond update
  bool frozeAnywhere = false;   ///< a particle just froze on any rank
  bool meltedAnywhere = false;  ///< a solid melted in this step on any rank
};

}  // namespace thaw
