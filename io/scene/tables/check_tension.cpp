// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <numbers>

#include "core/scene/material_use.hpp"
#include "io/scene/tables/read_sections.hpp"

namespace thaw {

void checkTension(const Scene& s, std::vector<SceneError>& errors) {
  const bool energy = s.numerics.tension == TensionForm::SurfaceEnergy;
  const auto refuse = [&](const SourcePlace& where, const std::string& key, const char* what) {
    errors.push_back(
        {where, fmt::format("{}: {} `numerics.tension = \"surface energy\"`: set it, or remove the key", key,
                            what)});
  };
  for (const Material& m : s.materials) {
    if (energy) continue;
    if (!m.surfaceTensionTable.empty())
      refuse(m.where, fmt::format("material.{}.surface_tension", m.name), "a table by temperature needs");
    if (m.contactAngle != std::numbers::pi / 2)
      refuse(m.where, fmt::format("material.{}.contact_angle", m.name), "contact angles need");
  }
  const bool tension = std::any_of(s.materials.begin(), s.materials.end(),
                                   [](const Material& m) { return m.surfaceTension > 0; });
  for (const Obstacle& o : s.obstacles) {
    if (!(o.contactAngle < never)) continue;
    const std::string key = fmt::format("`contact_angle` of obstacle '{}'", o.name);
    if (!tension)
      errors.push_back({o.where, key +
                                     ": no liquid has surface tension: give a material `surface_tension`, or "
                                     "remove `contact_angle`"});
    else if (!energy) refuse(o.where, key, "contact angles need");
  }
}

}  // namespace thaw
