// SPDX-License-Identifier: Apache-2.0
// Contact stiffness between heavy continuum particles and a light sheet, if the scene gives no stiffness.
#pragma once
#include <span>

#include "core/materials/liquid_materials.hpp"
#include "core/sheet/data/plan_sheets.hpp"

namespace thaw {

/// Sets SheetPlan::particleRate. The contact spring suits a light vertex, but a heavier particle would pass
/// through. At the scene's speeds, an additional barrier (TouchLaw) stops the particle within the contact
/// distance. For a liquid, the barrier is at least as stiff as the liquid, so pressure does not push
/// particles through. This stiffness is m (c/s)^2 for spacing s and sound speed c.
void planParticleContact(const Scene& scene, std::span<const LiquidMaterial> liquids,
                         std::vector<SheetPlan>& plans);

/// Returns TouchLaw::barrier (N/m) for a particle of this material and mass (kg).
inline double particleBarrier(const SheetPlan& plan, std::size_t material, double mass) {
  return mass * plan.particleRate[material] * plan.particleRate[material];
}

}  // namespace thaw
