// SPDX-License-Identifier: Apache-2.0
#include "core/simulation/setup/warnings/empty_regions.hpp"

#include "core/geometry/shapes/pose.hpp"
#include "core/heat/sources/heat_sources.hpp"

namespace thaw {

std::vector<SceneWarning> emptyRegions(const Scene& scene, const Continuum& particles, const MeshLoader& load,
                                       Reducer& all) {
  std::vector<SceneWarning> warnings;
  const std::vector<HeatedRegion>& regions = scene.heatedRegions;
  if (regions.empty() || !scene.emitters.empty()) return warnings;
  std::vector<std::int64_t> count;
  for (const HeatedRegion& r : regions) {
    const std::shared_ptr<const SignedDistance> shape = makeSignedDistance(r.shape, load);
    count.push_back(std::ssize(rowsInRegion(r, *shape, poseAt(r.motion, r.start), particles)));
  }
  all.sum(count);
  for (std::size_t k = 0; k < regions.size(); k++) {
    const HeatedRegion& region = regions[k];
    if (count[k] > 0 || region.motion.size() > 1 || region.start >= scene.end) continue;
    std::string text = "'" + region.name + "' holds no particle at the start";
    if (region.material >= 0)
      text = "'" + region.name + "' holds no particle of material '" +
             scene.materials[static_cast<std::size_t>(region.material)].name + "' at the start";
    warnings.push_back({region.where, "heated region " + text +
                                          ": it heats nothing until a particle moves into it. Move its "
                                          "`place`, or enlarge its shape"});
  }
  return warnings;
}

}  // namespace thaw
