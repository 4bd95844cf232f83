// SPDX-License-Identifier: Apache-2.0
#include "io/commands/check/chosen_numerics.hpp"

#include "io/run/restart/restart_coefficients.hpp"

namespace thaw {

bool isChosen(const std::string& key, const Numerics& n) {
  const Numerics usual;
  if (key == "numerics.support") return n.support != usual.support;
  if (key == "numerics.bond_support") return n.bondSupport != usual.bondSupport;
  CheckpointValues own, defaults;
  addCoefficients(own, n);
  addCoefficients(defaults, usual);
  for (const char* kind : {coefficient, setting})
    if (const auto at = own.find(kind + key); at != own.end()) return at->second != defaults[kind + key];
  return false;
}

}  // namespace thaw
