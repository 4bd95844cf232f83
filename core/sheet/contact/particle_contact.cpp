// SPDX-License-Identifier: Apache-2.0
#include "core/sheet/contact/particle_contact.hpp"

#include <algorithm>

namespace thaw {
namespace {

// Contact rate (1/s) over the liquid's speed of sound per spacing.
constexpr double asLiquid = 1;

}  // namespace

void planParticleContact(const Scene& s, std::span<const LiquidMaterial> liquids,
                         std::vector<SheetPlan>& plans) {
  for (std::size_t n = 0; n < plans.size(); n++) {
    SheetPlan& plan = plans[n];
    plan.particleRate.assign(s.materials.size(), 0);
    if (s.sheets[n].contactRate > 0) continue;
    for (std::size_t m = 0; m < s.materials.size(); m++) {
      const double reach = 0.5 * (plan.thickness + s.spacing);
      plan.particleRate[m] = std::max(
          2 * expectedSheetSpeed(s) / reach,
          canBeLiquid(s.materials[m]) ? asLiquid * liquids[m].soundSpeed / s.spacing : 0);
    }
  }
}

}  // namespace thaw
