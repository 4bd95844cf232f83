// SPDX-License-Identifier: Apache-2.0
#include "core/heat/cover_areas.hpp"

#include "core/heat/exposed_area.hpp"

namespace thaw {

void coverAreas(const WallView& w, const WallContacts& contacts) {
  const ExposedAreaLaw law = exposedAreaLaw(w.scene.numerics);
  for (const WallContact& c : contacts.list) {
    const double covered = c.share * coveredArea(law, c.distance / w.scene.spacing);
    float& area = w.particles.exposedArea[c.row];
    if (covered > 0 && area > 0) area = static_cast<float>(clearArea(static_cast<double>(area) - covered));
  }
}

}  // namespace thaw
