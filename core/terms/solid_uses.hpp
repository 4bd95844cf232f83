// SPDX-License-Identifier: Apache-2.0
// Bodies that start solid, and keys that only elastic solids have.
#pragma once
#include <initializer_list>

#include "core/scene/key_table.hpp"
#include "core/scene/modules.hpp"

namespace thaw {

template<class Source> const Material& materialOf(const Scene& s, const Source& from) {
  return s.materials[static_cast<std::size_t>(from.material)];
}

/// Returns true if particles of a body or emitter may start solid, and others may start liquid.
template<class Source> bool mayStartInEitherPhase(const Scene& s, const Source& from) {
  const Material& x = materialOf(s, from);
  return from.temperatureField && x.canBeSolid() && x.melts();
}

/// Returns true if particles of a body or emitter can be solid at its start.
template<class Source> bool mayStartSolid(const Scene& s, const Source& from) {
  return mayStartInEitherPhase(s, from) || solidAt(materialOf(s, from), from.temperature);
}

/// Returns the number of bodies that can be solid at the start.
inline int solidBodies(const Scene& s) {
  int bodies = 0;
  for (const Body& b : s.bodies) bodies += mayStartSolid(s, b);
  return bodies;
}

/// Rejects keys that do not apply to rigid pieces.
inline void refuseForRigid(KeyTable& keys, const Material& m, std::initializer_list<const char*> names) {
  for (const char* key : names)
    if (m.isRigid() && keys.has(key))
      keys.fail(key, "has no effect with `law = \"rigid\"`: remove it, or choose another law");
}

}  // namespace thaw
