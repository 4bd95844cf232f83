// SPDX-License-Identifier: Apache-2.0
#include "core/heat/cover_areas.hpp"

#include "core/heat/exposed_area.hpp"

namespace thaw {

void coverAreas(const WallView& w, const WallContacts& contacts) {
  const ExposedAreaLaw law = exposedAreaLaw(w.scene.numerics);
  for (const WallContact& c : contacts.list)
    w.particles.exposedArea[c.row] -= static_cast<float>(c.share *
                                                         coveredArea(law, c.distance / w.scene.spacing));
}

}  // namespace thaw
