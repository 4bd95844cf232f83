// SPDX-License-Identifier: Apache-2.0
#include "core/simulation/setup/warnings/thick_flow.hpp"

#include <algorithm>
#include <cstdio>

#include "core/fluid/flow_laws/flow_law.hpp"
#include "core/scene/material_use.hpp"
#include "core/simulation/time/limits.hpp"
#include "core/simulation/workspace/step_tools.hpp"

namespace thaw {
namespace {

/// The largest viscosity (Pa s) of a flow law and the explicit step (s) that it allows.
struct ThickFlow {
  double leastRate, viscosity, step;
};

ThickFlow thickFlowOf(const Scene& s, const Material& m) {
  return {leastRateOf(s, m), largestFlowViscosity(s, m), flowLawStepLimit(s, m)};
}

template<class Action> void forEachFlowLaw(const World& w, Action action) {
  for (std::size_t k = 0; w.modules.flowLaw && k < w.scene.materials.size(); k++)
    if (const Material& m = w.scene.materials[k]; hasFlowLaw(m) && inUse(w.scene, k) && canBeLiquid(m))
      action(m);
}

}  // namespace

std::vector<std::string> flowLawLines(const World& w) {
  std::vector<std::string> lines;
  forEachFlowLaw(w, [&](const Material& m) {
    const ThickFlow flow = thickFlowOf(w.scene, m);
    char text[320], rate[80] = "";
    if (m.flowLaw.law != FlowLaw::Carreau)
      std::snprintf(rate, sizeof rate, ", at rest below a shear rate of %.3g 1/s", flow.leastRate);
    std::snprintf(
        text, sizeof text, "': %s%s, viscosity up to %.3g Pa s, %s", nameOf(m.flowLaw.law), rate,
        flow.viscosity,
        w.modules.implicitViscosity ? "no step limit (implicit viscosity)" : "which limits steps to ");
    char limit[40] = "";
    if (!w.modules.implicitViscosity) std::snprintf(limit, sizeof limit, "%.3g s", flow.step);
    lines.push_back("flow law of liquid '" + m.name + text + limit);
  });
  return lines;
}

std::vector<SceneWarning> thickFlows(const World& w, const StepTools& t) {
  std::vector<SceneWarning> warnings;
  if (w.modules.implicitViscosity) return warnings;
  forEachFlowLaw(w, [&](const Material& m) {
    const ThickFlow flow = thickFlowOf(w.scene, m);
    const double times = t.limits.fixed[Limit::Sound] / flow.step;
    if (!(times > 4 && times < never)) return;
    char text[400];
    std::snprintf(text, sizeof text,
                  ": at rest its viscosity is up to %.3g Pa s, and its steps are %.3g times shorter than the "
                  "limit of sound; `numerics.viscosity_solver = \"implicit\"` is recommended, else a larger "
                  "flow.least_rate or a smaller flow.largest_viscosity",
                  flow.viscosity, times);
    warnings.push_back({m.where, "material." + m.name + text});
  });
  return warnings;
}

}  // namespace thaw
