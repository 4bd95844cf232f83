// SPDX-License-Identifier: Apache-2.0
// Modules of terms that depend on a coefficient of materials.
#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include "core/scene/material_use.hpp"
#include "core/terms/model_part.hpp"

namespace thaw {

/// Text before and after the name of the material in a reason.
struct MaterialReason {
  const char *before = "", *after = "";
};

/// Returns a use of the module for each material for which has(material) is true.
template<class Has>
std::vector<ModuleUse> usesByMaterials(const Scene& s, bool Modules::*module, const MaterialReason& why,
                                       Has&& has) {
  std::vector<ModuleUse> uses;
  for (const Material& x : s.materials)
    if (has(x)) uses.push_back({module, why.before + ("material '" + x.name + "'") + why.after});
  return uses;
}

/// Returns true if the scene uses one of its materials.
inline bool inUse(const Scene& s, const Material& x) {
  return inUse(s, static_cast<std::size_t>(&x - s.materials.data()));
}

/// Like usesByMaterials, for materials that the scene uses and that can be liquid.
template<class Has>
std::vector<ModuleUse> usesByLiquids(const Scene& s, const Modules& m, bool Modules::*module,
                                     const MaterialReason& why, Has&& has) {
  return usesByMaterials(s, module, why,
                         [&](const Material& x) { return inUse(s, x) && hasLiquid(m, x) && has(x); });
}

/// Like usesByMaterials, for materials that the scene uses and that can be solid.
template<class Has>
std::vector<ModuleUse> usesBySolids(const Scene& s, const Modules& m, bool Modules::*module,
                                    const MaterialReason& why, Has&& has) {
  if (!m.solid) return {};
  return usesByMaterials(s, module, why,
                         [&](const Material& x) { return inUse(s, x) && x.canBeSolid() && has(x); });
}

inline void append(std::vector<ModuleUse>& all, std::vector<ModuleUse> more) {
  all.insert(all.end(), more.begin(), more.end());
}

}  // namespace thaw
