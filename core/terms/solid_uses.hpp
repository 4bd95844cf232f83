// SPDX-License-Identifier: Apache-2.0
// Modules and keys of terms with a coefficient of solid materials.
#pragma once
#include <initializer_list>
#include <vector>

#include "core/scene/material_use.hpp"
#include "core/terms/model_part.hpp"

namespace thaw {

/// Returns true if particles of a body or emitter can be solid at its start.
template<class Source> bool mayStartSolid(const Scene& s, const Source& from) {
  const Material& x = s.materials[static_cast<std::size_t>(from.material)];
  return (from.temperatureField && x.canBeSolid() && x.melts()) || solidAt(x, from.temperature);
}

/// Returns the number of bodies that can be solid at the start.
inline int solidBodies(const Scene& s) {
  int bodies = 0;
  for (const Body& b : s.bodies) bodies += mayStartSolid(s, b);
  return bodies;
}

/// Returns a use of the module for each material of the scene that can be solid and for which has(material)
/// is true. The reason is the material, between two texts.
template<class Has>
std::vector<ModuleUse> usesBySolids(const Scene& s, const Modules& m, bool Modules::*module,
                                    const char* before, const char* after, Has&& has) {
  std::vector<ModuleUse> uses;
  for (std::size_t k = 0; m.solid && k < s.materials.size(); k++)
    if (const Material& x = s.materials[k]; inUse(s, k) && x.canBeSolid() && has(x))
      uses.push_back({module, before + ("material '" + x.name + "'") + after});
  return uses;
}

inline void append(std::vector<ModuleUse>& all, std::vector<ModuleUse> more) {
  all.insert(all.end(), more.begin(), more.end());
}

/// Refuses keys that rigid pieces do not have.
inline void refuseForRigid(KeyTable& keys, const Material& m, std::initializer_list<const char*> names) {
  for (const char* key : names)
    if (m.isRigid() && keys.has(key))
      keys.fail(key, "has no effect with `law = \"rigid\"`: remove it, or choose another law");
}

}  // namespace thaw
