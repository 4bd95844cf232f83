// SPDX-License-Identifier: Apache-2.0
// The table of the parts of the library's own model: forces, sources of heat, laws of liquids. Its rows are
// entered into the registry of extensions (core/terms/extensions.hpp), which scenes, documents, checks,
// restarts and the step read. To add a term: docs/developer/extend.md.
#pragma once
#include "core/terms/extensions.hpp"

namespace thaw {

// Each in its file rows/NAME_term.cpp.
Extension gravityTerm();
Extension pressureTerm();
Extension viscosityTerm();
Extension buoyancyTerm();
Extension tensionTerm();
Extension artificialViscosityTerm();
Extension smoothingTerm();
Extension elasticityTerm();
Extension plasticityTerm();
Extension fractureTerm();
Extension meltingTerm();
Extension contactTerm();
Extension weldingTerm();
Extension conductionTerm();
Extension heatExchangeTerm();
Extension thermostatTerm();
Extension lightTerm();
Extension heatedRegionTerm();
Extension evaporationTerm();
Extension mushTerm();

/// Returns all terms. They act in this order within a stage, and their keys are listed in it.
inline std::vector<Extension> ownTerms() {
  // clang-format off
  return {gravityTerm(),
          pressureTerm(),
          viscosityTerm(),
          buoyancyTerm(),
          tensionTerm(),
          artificialViscosityTerm(),
          smoothingTerm(),
          elasticityTerm(),
          plasticityTerm(),
          fractureTerm(),
          meltingTerm(),
          contactTerm(),
          weldingTerm(),
          conductionTerm(),
          heatExchangeTerm(),
          thermostatTerm(),
          lightTerm(),
          heatedRegionTerm(),
          evaporationTerm(),
          mushTerm()};
  // clang-format on
}

}  // namespace thaw
