// SPDX-License-Identifier: Apache-2.0
// Changes of velocities and temperatures that a program makes between two steps.
#pragma once
#include <string>
#include <vector>

#include "core/ledger/ledger.hpp"
#include "core/particles/continuum.hpp"
#include "core/scene/scene.hpp"

namespace thaw {

/// Values of the owned rows at the start of an edit.
struct Edit {
  bool open = false;
  std::vector<Vec3d> velocity;      ///< m/s
  std::vector<double> temperature;  ///< K, empty in a scene without heat
};

/// Returns an edit that starts from the current values.
Edit startEdit(const Continuum& particles);

/// Returns whether a row of this rank differs from its value at the start.
bool isEdited(const Continuum& particles, const Edit& edit);

/// Returns the error of the first refused row of this rank, or "". Refused are values that are not
/// finite, and temperatures below 0 K.
std::string editProblem(const Continuum& particles, const Edit& edit);

/// Sets velocities and temperatures back to their values at the start.
void undoEdit(Continuum& particles, const Edit& edit);

/// Records the changes in the ledger: work m (v'^2 - v^2) / 2 (J), impulse m (v' - v) (N s), and heat (J).
/// Heat is the difference of enthalpies, which follow the temperatures (docs/theory/heat.md).
void recordEdit(Continuum& particles, Ledger& ledger, const Scene& scene, const Edit& edit);

}  // namespace thaw
