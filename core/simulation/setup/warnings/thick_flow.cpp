// SPDX-License-Identifier: Apache-2.0
#include "core/simulation/setup/warnings/thick_flow.hpp"

#include <algorithm>
#include <cstdio>

#include "core/fluid/flow_laws/flow_law.hpp"
#include "core/scene/material_use.hpp"
#include "core/simulation/time/limits.hpp"

namespace thaw {
namespace {

/// The largest viscosity (Pa s) of a flow law and the explicit step (s) that it allows.
struct ThickFlow {
  double leastRate, viscosity, step;
};

ThickFlow thickFlowOf(const Scene& s, const Material& m) {
  return {leastRateOf(s, m), largestFlowViscosity(s, m), flowLawStepLimit(s, m)};
}

template<class Action> void forEachFlowLaw(const Scene& scene, const Modules& modules, Action action) {
  for (std::size_t k = 0; modules.flowLaw && k < scene.materials.size(); k++)
    if (const Material& m = scene.materials[k]; hasFlowLaw(m) && inUse(scene, k) && canBeLiquid(m)) action(m);
}

}  // namespace

std::vector<std::string> flowLawLines(const Scene& scene, const Modules& modules) {
  std::vector<std::string> lines;
  forEachFlowLaw(scene, modules, [&](const Material& m) {
    const ThickFlow flow = thickFlowOf(scene, m);
    char text[320], rate[80] = "";
    if (hasLeastRate(m.flowLaw.law))
      std::snprintf(rate, sizeof rate, ", at rest below a shear rate of %.3g 1/s", flow.leastRate);
    std::snprintf(
        text, sizeof text, "': %s%s, viscosity up to %.3g Pa s, %s", rowOf(m.flowLaw.law).title, rate,
        flow.viscosity,
        modules.implicitViscosity ? "no step limit (implicit viscosity)" : "which limits steps to ");
    char limit[40] = "";
    if (!modules.implicitViscosity) std::snprintf(limit, sizeof limit, "%.3g s", flow.step);
    lines.push_back("flow law of liquid '" + m.name + text + limit);
  });
  return lines;
}

std::vector<SceneWarning> thickFlows(const Scene& scene, const Modules& modules, const StepLimits& limits) {
  std::vector<SceneWarning> warnings;
  if (modules.implicitViscosity) return warnings;
  forEachFlowLaw(scene, modules, [&](const Material& m) {
    const ThickFlow flow = thickFlowOf(scene, m);
    const double times = limits[Limit::Sound] / flow.step;
    if (!(times > 4 && times < never)) return;
    char text[800];
    std::snprintf(text, sizeof text,
                  ": at rest its viscosity is up to %.3g Pa s, and its steps are %.3g times shorter than the "
                  "limit of sound; set `numerics.viscosity_solver = \"implicit\"`, raise "
                  "`material.%s.flow.least_rate`, or lower `material.%s.flow.largest_viscosity`",
                  flow.viscosity, times, m.name.c_str(), m.name.c_str());
    warnings.push_back({m.where, "material." + m.name + text});
  });
  return warnings;
}

}  // namespace thaw
