// SPDX-License-Identifier: Apache-2.0
// Tests of the materials that a scene uses.
#pragma once
#include <algorithm>

#include "core/scene/scene.hpp"

namespace thaw {

/// Returns true if the viscosity depends on the shear rate.
inline bool hasFlowLaw(const Material& m) { return m.flowLaw.law != FlowLaw::Newtonian; }

/// Returns true if a body or emitter has this material (index into Scene::materials).
inline bool inUse(const Scene& s, std::size_t material) {
  const auto has = [&](const auto& source) { return static_cast<std::size_t>(source.material) == material; };
  return std::any_of(s.bodies.begin(), s.bodies.end(), has) ||
         std::any_of(s.emitters.begin(), s.emitters.end(), has);
}

}  // namespace thaw
