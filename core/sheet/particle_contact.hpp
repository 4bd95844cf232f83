// What holds heavy particles of the continuum off a light sheet, where the scene does not say how stiff
// contact is.
#pragma once
#include <span>

#include "core/fluid/liquid_materials.hpp"
#include "core/sheet/plan_sheets.hpp"

namespace thaw {

/// Fills SheetPlan::particleRate. Contact's spring turns round a light vertex, as its mass asks; a particle
/// is often much heavier and would go on through. So beside the spring there is a barrier (TouchLaw) that
/// stops it: one that comes at the scene's speeds, within the distance of contact; for one of a liquid as
/// stiff as the liquid itself, m (c/s)^2 for a spacing s and speed of sound c, so that the liquid's pressure
/// does not press through.
void planParticleContact(const Scene& scene, std::span<const LiquidMaterial> liquids,
                         std::vector<SheetPlan>& plans);

/// N/m, TouchLaw::barrier of a particle of this material and mass (kg).
inline double particleBarrier(const SheetPlan& plan, std::size_t material, double mass) {
  return mass * plan.particleRate[material] * plan.particleRate[material];
}

}  // namespace thaw
