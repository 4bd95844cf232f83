// SPDX-License-Identifier: Apache-2.0
// The table of body forces, sources of heat and pair forces of the library. Its rows are entered into the
// registry of extensions (core/terms/extensions.hpp), which scenes, documents, checks, restarts and the step
// read. To add a term: docs/developer/extend.md.
#pragma once
#include "core/terms/extensions.hpp"

namespace thaw {

// Each in its file NAME_term.cpp.
Extension gravityTerm();
Extension buoyancyTerm();
Extension tensionTerm();
Extension artificialViscosityTerm();
Extension smoothingTerm();
Extension heatExchangeTerm();
Extension thermostatTerm();
Extension lightTerm();
Extension heatedRegionTerm();

/// Returns all terms. They act in this order within a stage, and their keys are listed in it.
inline std::vector<Extension> ownTerms() {
  // clang-format off
  return {gravityTerm(),
          buoyancyTerm(),
          tensionTerm(),
          artificialViscosityTerm(),
          smoothingTerm(),
          heatExchangeTerm(),
          thermostatTerm(),
          lightTerm(),
          heatedRegionTerm()};
  // clang-format on
}

}  // namespace thaw
