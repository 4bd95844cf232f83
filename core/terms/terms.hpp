// SPDX-License-Identifier: Apache-2.0
// The table of the library's own model parts: forces, heat sources, laws of liquids. Its rows are entered
// into the registry of extensions (core/terms/extensions.hpp). Scenes, documents, checks, restarts and the
// step read this registry. To add a term: docs/developer/extend.md.
#pragma once
#include "core/terms/extensions.hpp"

namespace thaw {

// Each term is in its own file rows/NAME_term.cpp.
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

/// Returns all terms. Within a stage they act in this order. Their keys are listed in the same order.
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
