// SPDX-License-Identifier: Apache-2.0
// Functions of the program that run after a phase of each step.
#pragma once
#include <array>
#include <cstddef>
#include <functional>
#include <string_view>
#include <vector>

namespace thaw {

/// Phases of a step, in their order.
enum class HookPhase {
  Predict,       ///< first half kick, drift
  Redistribute,  ///< emission, migration, sort, bonds
  Density,       ///< neighbours, densities, with their ghosts
  Forces,        ///< all forces and heat flows
  Integrate,     ///< second half kick
  PhaseChange,   ///< heat, melting, freezing
  EndOfStep      ///< the length of the next step is known, and modules have prepared it
};
inline constexpr std::array<std::string_view, 7> hookPhaseNames{
    "predict", "redistribute", "density", "forces", "integrate", "phase_change", "end_of_step"};

struct StepHooks {
  std::array<std::vector<std::function<void()>>, hookPhaseNames.size()> calls;
  void after(HookPhase phase) const {
    for (const auto& call : calls[static_cast<std::size_t>(phase)]) call();
  }
};

}  // namespace thaw
