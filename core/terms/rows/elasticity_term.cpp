// SPDX-License-Identifier: Apache-2.0
// Elastic forces of solids (core/solid/elasticity/), by the laws of core/solid/laws/ and of programs.
#include "core/terms/terms.hpp"

namespace thaw {
namespace {

void readElasticSums(KeyTable& keys, Numerics& n) {
  keys.restart(Restart::State);
  keys.number(
      "bond_support", n.bondSupport, "", between(1.2, 6),
      "longest bond of solids in spacings, at most `support`; longer bonds soften thin bodies, shorter "
      "ones need shorter steps in irregular arrangements");
  keys.restart(Restart::Coefficient);
  keys.choice("elastic_precision", n.elasticPrecision, {"single", "double"},
              "precision of sums over bonds of solids; single is accurate to 1e-6 of the strain");
  keys.restart(Restart::Setting);
  keys.number("cfl_elastic", n.cflElastic, "", stepFactor(),
              "step limit as a multiple of spacing / speed of pressure waves");
  std::int64_t substeps = n.elasticSubsteps;
  keys.whole(
      "elastic_substeps", substeps, 0, 64,
      "largest number of substeps of solids within a step, if their elastic limit is the shortest. 0: 4 with "
      "liquid (2 if it is incompressible) and without contact of solids, else 1. With at most one solid "
      "body, contacts of frozen pieces limit the step only while pieces touch or are about to. With more "
      "than 8 the liquid may pump energy into solids without damping. With incompressible liquid, or with "
      "liquid in a scene of melting solids, the step is at most that of a `cfl_elastic` of 0.8");
  n.elasticSubsteps = static_cast<int>(substeps);
}

void readElasticity(KeyTable& keys, Material& m) {
  Blend young = m.impactModulus > 0 ? Blend{m.impactModulus, 0} : m.young;
  keys.blend({"young", "Pa", notNegative(), LiquidValue::Unchanged,
              "Young's modulus; above 0 the material can be solid. A single value is for the solid, and the "
              "liquid has 0"},
             young);
  if (keys.reading()) m.young = young;
  keys.blend({"poisson", "", inside(-1, 0.5), LiquidValue::Same, "Poisson's ratio"}, m.poisson);
  keys.number("volume_stiffness", m.volumeStiffness, "Pa", notNegative(),
              "k_v of the volume force (Mueller et al. 2004)");
  keys.number("hourglass", m.hourglass, "", between(0, 10), "strength of the control of zero-energy modes");
  keys.number("damping", m.damping, "1/s", notNegative(),
              "rate at which velocity differences of bonded particles decay; vibrations that are many "
              "spacings long decay far more slowly");
}

}  // namespace

Extension elasticityTerm() {
  return {.name = "elasticity",
          .about = "forces of solids that are deformed, by an elastic law",
          .model = ModelPart{.numericsKeys = readElasticSums,
                             .materialKeys = readElasticity,
                             .modules = {{&Modules::solid, "solid"},
                                         {&Modules::elastic, "elastic solids"},
                                         {&Modules::substeps, "substeps of solids"}},
                             .limits = {"elastic waves"},
                             .energies = {"elastic_J", "dissipated_J"}}};
}

}  // namespace thaw
