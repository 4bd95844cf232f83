// SPDX-License-Identifier: Apache-2.0
#include "core/heat/sources/heat_sources.hpp"
#include "core/terms/rows/source_keys.hpp"
#include "core/terms/terms.hpp"

namespace thaw {
namespace {

void readHeatedRegion(KeyTable& keys, HeatedRegion& h) {
  keys.restart(Restart::Setting);
  keys.name(h.name);
  keys.shape(h.shape);
  keys.needed().number("power", h.power, "W", positive(),
                       "power that the particles inside receive in proportion to their mass");
  keys.material(h.material, "material that it heats; none: all");
  readTimes(keys, h);
  requireKey(keys, "power");
}

std::vector<ModuleUse> usesOfHeatedRegions(const Scene& s) {
  std::vector<ModuleUse> all;
  addUses(s, s.heatedRegions, "heated region", all);
  return all;
}

OutsideSource startHeatedRegions(const TermSetup& setup) {
  std::vector<std::shared_ptr<const SignedDistance>> shapes;
  for (const HeatedRegion& r : setup.scene.heatedRegions)
    shapes.push_back(
        makeSignedDistance(r.shape, setup.load, "heated region '" + r.name + "'", setup.problems));
  return [shapes = std::move(shapes)](const OutsideLoad& load) {
    addRegionHeat(load.run, shapes, load.dt, load.all);
  };
}

}  // namespace

Extension heatedRegionTerm() {
  return {.name = "heated regions",
          .about = "power that the particles in a shape receive",
          .heats = true,
          .model = ModelPart{
              .tables = {termTable<&Scene::heatedRegions, readHeatedRegion>(
                  "heated_region", "heated region", "power that the particles in a shape receive")},
              .earlyUses = usesOfHeatedRegions,
              .stage = LoadStage::Sources,
              .start = startHeatedRegions,
              .limits = {"heat"},
              .stepLimit = regionStepLimit,
              .energies = {"regions_given_J", "regions_absorbed_J", "regions_reflected_J", "heat_in_J"}}};
}

}  // namespace thaw
