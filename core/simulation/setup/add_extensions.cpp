// SPDX-License-Identifier: Apache-2.0
#include "core/simulation/setup/add_extensions.hpp"

#include <algorithm>
#include <stdexcept>

#include "core/terms/extensions.hpp"

namespace thaw {
namespace {

const Extension& extensionOf(const std::string& name) {
  const Extension* e = findExtension(name);
  if (!e) throw std::runtime_error("extension '" + name + "' is not registered");
  return *e;
}

void lower(StepLimits& limits, double limit) {
  double& least = limits[Limit::Extension];
  least = std::min(least, limit);
}

void addPairForce(World& w, TermWork& terms, StepLimits& limits, const Extension& e,
                  const ExtensionSettings& settings) {
  if (!w.modules.fluid)
    throw std::runtime_error(
        "extension '" + e.name +
        "' is a force between liquid particles, but no material of the scene can be liquid: "
        "remove the table, or give the scene a liquid");
  if (w.modules.emitters) declareNewborn(w.particles);
  PairForceWork work;
  work.force = &e.pairForce;
  work.settings = &settings;
  for (const ExtensionKey& key : e.keys) work.values.push_back(settings.values.at(key.name));
  terms.pairForces.push_back(std::move(work));
  if (e.pairForce.stepLimit) lower(limits, e.pairForce.stepLimit(settings, w.scene));
}

}  // namespace

void startTerms(const Scene& scene, const Modules& modules, TermWork& terms, const MeshLoader& load,
                SceneProblems& problems) {
  for (const Extension* term : modelTerms()) {
    for (const PairSweep& sweep : term->model->sweeps)
      if (sweep.isOn(scene.numerics, modules)) terms.sweeps.push_back(&sweep);
    if (term->model->start && isUsed(*term, scene, modules))
      terms.active.push_back({&*term->model, term->model->start({scene, load, problems})});
  }
}

void addExtensions(World& w, TermWork& terms, StepLimits& limits) {
  declareFields(w.scene, w.particles);
  for (const ExtensionSettings& settings : w.scene.extensions) {
    const Extension& e = extensionOf(settings.name);
    if (e.heats && !w.modules.heat)
      throw std::runtime_error(
          "extension '" + e.name +
          "' is a source of heat, but the scene has no [[body]] and no [[emitter]] that it could heat");
    if (e.load) terms.outside.push_back(e.load(settings));
    if (e.update) terms.fieldUpdates.push_back(e.update(settings));
    if (e.stepLimit) lower(limits, e.stepLimit(settings));
    if (e.pairForce.kernels.sum) addPairForce(w, terms, limits, e, settings);
  }
  static const ExtensionSettings none;  // terms have no settings, since their keys are members of the scene
  for (const Extension* term : modelTerms())
    if (term->pairForce.kernels.sum && isUsed(*term, w.scene, w.modules))
      addPairForce(w, terms, limits, *term, none);
  for (const Extension* e : usedExtensions(w.scene))
    w.modules.why.push_back("extension '" + e->name + "': " + e->about);
}

}  // namespace thaw
