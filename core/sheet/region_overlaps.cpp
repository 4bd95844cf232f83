// SPDX-License-Identifier: Apache-2.0
#include "core/sheet/region_overlaps.hpp"

#include <algorithm>

namespace thaw {
namespace {

/// Returns the coefficients with a factor in the earlier region but none in the later one: "warp, damping".
std::string lostFactors(const SheetRegion& earlier, const SheetRegion& later) {
  std::string lost;
  for (std::size_t f = 0; f < sheetFactors; f++)
    if (earlier.factor[f] != 1 && later.factor[f] == 1)
      lost += (lost.empty() ? "" : ", ") + std::string(sheetCoefficients[f].key);
  return lost;
}

}  // namespace

std::vector<SceneWarning> overlapsOfRegions(const SheetBodies& sheets, const Scene& scene,
                                            const MeshLoader& load) {
  std::vector<SceneWarning> warnings;
  for (std::size_t n = 0; n < sheets.plans.size(); n++) {
    const SheetBody& b = scene.sheets[n];
    std::vector<std::shared_ptr<const SignedDistance>> shapes;
    for (const SheetRegion& r : b.regions)
      if (b.regions.size() > 1) shapes.push_back(makeSignedDistance(r.shape, load));
    const auto& places = sheets.plans[n].mesh.vertices;
    for (std::size_t later = 1; later < shapes.size(); later++)
      for (std::size_t earlier = 0; earlier < later; earlier++) {
        const std::string lost = lostFactors(b.regions[earlier], b.regions[later]);
        if (lost.empty()) continue;
        const auto shared = std::count_if(places.begin(), places.end(), [&](const Vec3d& x) {
          return shapes[earlier]->inside(x) && shapes[later]->inside(x);
        });
        const std::string first = std::to_string(earlier), second = std::to_string(later);
        if (shared > 0)
          warnings.push_back(
              {b.regions[later].where, "sheet '" + b.name + "': " + std::to_string(shared) +
                                           " vertices lie in regions " + first + " and " + second +
                                           ". Region " + second + " applies there; " + lost + " of region " +
                                           first + " is ignored. Set it in region " + second + ", too"});
      }
  }
  return warnings;
}

}  // namespace thaw
