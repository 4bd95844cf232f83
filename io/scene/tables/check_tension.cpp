// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <numbers>

#include "core/scene/full_box.hpp"
#include "core/scene/material_use.hpp"
#include "io/scene/tables/full_box.hpp"
#include "io/scene/tables/read_sections.hpp"

namespace thaw {

void checkTension(const Scene& s, std::vector<SceneError>& errors) {
  const bool able = s.numerics.tension == TensionForm::SurfaceEnergy ||
                    s.numerics.tension == TensionForm::Curvature;
  const auto refuse = [&](const SourcePlace& where, const std::string& key, const char* what) {
    errors.push_back({where, fmt::format("{}: {} `numerics.tension = \"surface energy\"` or "
                                         "`\"curvature\"`: set one, or remove the key",
                                         key, what)});
  };
  for (const Material& m : s.materials) {
    if (able) continue;
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
    else if (!able) refuse(o.where, key, "contact angles need");
  }
}

void checkCurvature(const Scene& s, const SourcePlace& where, std::vector<SceneError>& errors) {
  const Numerics& n = s.numerics;
  if (n.tension != TensionForm::Curvature || !someSurfaceTension(s)) return;
  if (n.solver == PressureSolver::Incompressible)
    errors.push_back({where,
                      "`numerics.tension = \"curvature\"` needs the equation of state, and "
                      "`numerics.pressure_solver` is \"incompressible\": remove one"});
  else if (n.density != DensityForm::Continuity || !(n.shifting > 0))
    errors.push_back({where,
                      "`numerics.tension = \"curvature\"` needs `numerics.density = \"continuity\"` and "
                      "`numerics.shifting` above 0, the defaults without `quality = \"preview\"`: "
                      "other densities are low at a free surface, and its particles clump"});
  if (n.support < leastCurvatureSupport)
    errors.push_back(
        {where, fmt::format("`numerics.tension = \"curvature\"` needs `numerics.support` of at least "
                            "2, got {:g}: a particle of the surface needs neighbours on it",
                            n.support)});
}

}  // namespace thaw
