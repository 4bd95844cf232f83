// SPDX-License-Identifier: Apache-2.0
#include "core/sheet/prepare_sheets.hpp"

#include <algorithm>

#include "core/domain/outside.hpp"
#include "core/geometry/basic/shape_error.hpp"
#include "core/sheet/contact/sheet_contact.hpp"
#include "core/sheet/forces/inner_forces.hpp"
#include "core/sheet/forces/time_factors.hpp"

namespace thaw {

void prepareSheets(SheetBodies& sheets, const Scene& scene, const MeshLoader& load) {
  SheetPlans p = planSheets(scene, load);
  sheets.plans = std::move(p.plans);
  sheets.laws = std::move(p.laws);
  sheets.parts = std::move(p.parts);
}

void activateSheets(SheetBodies& sheets, const Scene& scene, const Modules& modules) {
  Sheets& s = sheets.rows;
  activateBodyType(s);
  for (AnyColumn* c :
       std::initializer_list<AnyColumn*>{&s.rest, &s.load, &s.area, &s.law, &s.part, &s.solidIndex})
    s.activate(*c);
  for (const SheetBody& b : scene.sheets) {
    if (b.plasticity > 0 && b.elasticLimit < never) {
      s.activate(s.flow);
      s.activate(s.hardening);
    }
    if (b.windDensity > 0 || b.shrinkWrap != 0 || !b.pressureBrushes.empty()) s.activate(s.outside);
    if (b.windDensity > 0 || b.volumeStiffness > 0 || (b.shrinkWrap != 0 && b.shrinkWrapTo.empty()))
      s.activate(s.areaNormal);
    if (!b.clamp.empty()) s.activate(s.clamped);
    if (s.outside.active) s.activate(s.moved);
    if (modules.heat) {
      s.activate(s.temperature);
      s.activate(s.heatFlow);
    }
  }
  for (const SheetLaw& l : sheets.laws)
    if (l.law.damping > 0) s.activate(s.moved);
  for (const SheetPlan& p : sheets.plans)
    if (p.touches) s.activate(s.dissipativeForce);
  if (sheetsInteract(scene) || sheetsTouchContinuum(scene) || modules.sheetContact) s.activate(s.moving);
  activateTimeFactors(sheets, scene);
  activateEdges(sheets.edges);
}

void sampleSheets(SheetBodies& sheets, const Scene& scene, Halos halos, const MeshLoader& load) {
  Sheets& s = sheets.rows;
  SceneProblems problems;
  const auto rank = static_cast<std::size_t>(halos.all.rank()),
             ranks = static_cast<std::size_t>(halos.all.size());
  for (std::size_t n = 0; n < sheets.plans.size(); n++) {
    const SheetPlan& plan = sheets.plans[n];
    const SheetBody& b = scene.sheets[n];
    std::vector<std::shared_ptr<const SignedDistance>> clamps;
    for (const Shape& c : b.clamp)
      clamps.push_back(makeSignedDistance(c, load, "sheet '" + b.name + "': a clamp", problems));
    const std::size_t all = plan.mesh.vertices.size(), begin = all * rank / ranks,
                      end = all * (rank + 1) / ranks;
    Outside outside;
    for (const Vec3d& x : plan.mesh.vertices) outside.look(scene.domain, x);
    if (outside.count > 0)
      problems.add(b.where, "sheet '" + b.name + "': " +
                                outsideText(outside, scene.domain, static_cast<std::int64_t>(all), "vertices",
                                            "sheet"));
    for (std::size_t c = 0; c < clamps.size(); c++)
      if (clamps[c] && std::none_of(plan.mesh.vertices.begin(), plan.mesh.vertices.end(),
                                    [&](const Vec3d& x) { return clamps[c]->inside(x); }))
        problems.add(
            b.clamp[c].where,
            "sheet '" + b.name + "': no vertex lies in this clamp at the start; expected at least one");
    std::size_t i = s.owned;
    s.resize(i + end - begin, 0);
    for (std::size_t v = begin; v < end; v++, i++) {
      s.id[i] = static_cast<std::uint64_t>(n) << 40 | v;
      s.position[i] = s.rest[i] = plan.mesh.vertices[v];
      s.velocity[i] = b.velocity;
      s.area[i] = plan.topology.area[v];
      s.law[i] = plan.law[v];
      s.part[i] = plan.firstPart + plan.topology.component[v];
      s.mass[i] = sheets.laws[plan.law[v]].law.mass * s.area[i];
      s.body[i] = static_cast<std::uint16_t>(n);
      s.solidIndex[i] = noSolid;
      if (s.temperature.active) s.temperature[i] = b.temperature;
      for (const auto& c : clamps)
        if (c && c->inside(s.position[i])) s.clamped[i] = 1;
      if (s.clamped.active && s.clamped[i]) s.velocity[i] = {};
    }
  }
  problems.raise();
}

}  // namespace thaw
