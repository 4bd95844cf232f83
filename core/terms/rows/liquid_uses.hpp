// SPDX-License-Identifier: Apache-2.0
// Modules that terms with a coefficient of liquid materials need.
#pragma once
#include <vector>

#include "core/scene/material_use.hpp"
#include "core/terms/model_part.hpp"

namespace thaw {

/// Returns a use of the module for each material of the scene that can be liquid and for which has(material)
/// is true.
template<class Has>
std::vector<ModuleUse> usesByLiquids(const Scene& s, const Modules& m, bool Modules::*module, Has&& has) {
  std::vector<ModuleUse> uses;
  for (std::size_t k = 0; k < s.materials.size(); k++)
    if (const Material& x = s.materials[k]; inUse(s, k) && hasLiquid(m, x) && has(x))
      uses.push_back({module, "material '" + x.name + "'"});
  return uses;
}

}  // namespace thaw
