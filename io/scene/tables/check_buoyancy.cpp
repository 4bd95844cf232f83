// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <utility>

#include "core/scene/buoyancy.hpp"
#include "core/scene/material_use.hpp"
#include "core/scene/phase_density.hpp"
#include "io/scene/tables/read_sections.hpp"

namespace thaw {

void checkBuoyancy(const SceneReading& x, std::vector<SceneError>& errors) {
  const Scene& s = *x.scene;
  if (s.numerics.buoyancy != Buoyancy::Boussinesq) return;
  const auto chosen = x.numerics.find("buoyancy");
  const SourcePlace where = chosen == x.numerics.end() ? x.start : chosen->second;
  const auto refuse = [&](const SourcePlace& place, const std::string& why) {
    errors.push_back({place, "`numerics.buoyancy = \"boussinesq\"` " + why});
  };
  if (!hasBuoyancy(s))
    return refuse(where,
                  length(s.domain.gravity) > 0
                      ? "needs a body or emitter of a material with `expansion` or a table of densities"
                      : "needs gravity: set `domain.gravity`");
  if (!s.oriented.empty() || !s.sheets.empty())
    refuse(where, "leaves out all weight, also that of sheets and oriented bodies: use \"density\"");
  const Material* first = nullptr;
  for (std::size_t k = 0; k < s.materials.size(); k++) {
    const Material& m = s.materials[k];
    if (!inUse(s, k)) continue;
    if (hasPhaseDensities(m))
      return refuse(m.where,
                    fmt::format("leaves out the weight, so solid and liquid of '{}' must not differ in "
                                "density; use \"density\"",
                                m.name));
    if (first && m.density != first->density)
      return refuse(m.where, fmt::format("leaves out the weight, so all materials need one density: '{}' has "
                                         "{:g} kg/m^3, '{}' {:g} kg/m^3; use \"density\"",
                                         m.name, m.density, first->name, first->density));
    if (!first) first = &m;
  }
}

void chooseBuoyancy(Scene& s) {
  if (!hasBuoyancy(s)) return;
  Buoyancy& chosen = s.numerics.buoyancy;
  if (chosen == Buoyancy::Automatic)
    chosen = liquidFillsClosedDomain(s) ? Buoyancy::Boussinesq : Buoyancy::Density;
  if (chosen == Buoyancy::Boussinesq) s.domain.buoyantGravity = std::exchange(s.domain.gravity, Vec3d{});
}

}  // namespace thaw
