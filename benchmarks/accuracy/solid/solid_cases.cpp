// SPDX-License-Identifier: Apache-2.0
// Elastic bodies against exact results: gradients of linear fields, rotation, conservation
// (docs/validation/accuracy.md).
#include "benchmarks/accuracy/solid/solid_trials.hpp"

#include "core/simulation/time/integrate.hpp"
#include "core/solid/laws/green.hpp"

namespace thaw::accuracy {
namespace {

void jitter(Trial& r) {
  World& w = r.world;
  for (std::size_t i = 0; i < w.particles.owned; i++)
    for (int a = 0; a < 3; a++)
      w.particles.position[i][a] += 0.4 * r.spacing() *
                                    (randomUniform(w.scene.seed, Purpose::Test, w.particles.id[i],
                                                   static_cast<std::uint64_t>(a)) -
                                     0.5);
}

// ---- patch ------------------------------------------------------------------------------------------------
const Mat3d patchGradient{{{0.05, -0.12, 0.08}, {0.1, -0.04, 0.06}, {-0.07, 0.03, 0.09}}};

void deformPatch(Trial& r) {
  Continuum& p = r.world.particles;
  for (std::size_t i = 0; i < p.owned; i++)
    p.position[i] += Vec3d{0.03, -0.02, 0.05} + patchGradient * p.position[i];
}

void watchPatch(Trial& r) {
  if (r.world.clock.step > 0) return;
  r.notes["gradient"] = largest(
      r, [](const World& w, std::size_t i) { return largestEntry(gradientOf(w, i) - patchGradient); });
}

std::vector<Figure> measurePatch(Trial& r) { return {{"Linf(grad u)", r.notes["gradient"], 1e-12}}; }

// ---- rotation ---------------------------------------------------------------------------------------------
void turnRound(Trial& r) {
  World& w = r.world;
  const Vec3d n = normalized(Vec3d{1, 2, 3});
  const Mat3d k{{{0, -n.z, n.y}, {n.z, 0, -n.x}, {-n.y, n.x, 0}}};
  const double angle = pi / 12, force = materialOf(w).young.solid * r.spacing() * r.spacing();
  const Mat3d turn = identity3<double>() + std::sin(angle) * k + (1 - std::cos(angle)) * (k * k);
  for (int step = 1; step <= 24; step++) {
    for (std::size_t i = 0; i < w.particles.owned; i++)
      w.particles.position[i] = turn * w.particles.position[i];
    initializeForces(w, r.halos(), r.tools);
    const double strain = largest(r, [](const World& x, std::size_t i) {
      const Sym3d e = greenStrain(gradientOf(x, i));
      return largestEntry(full(e));
    });
    const double pull = largest(
        r, [&](const World& x, std::size_t i) { return length(forceOf(x.particles, x.scene, i)) / force; });
    r.notes["strain"] = std::max(r.notes["strain"], strain);
    r.notes["force"] = std::max(r.notes["force"], pull);
  }
}

std::vector<Figure> measureRotation(Trial& r) {
  return {{"Linf(strain)", r.notes["strain"], 1e-12}, {"Linf(force)/(E dx^2)", r.notes["force"], 1e-12}};
}

// ---- free flight ------------------------------------------------------------------------------------------
void launch(Trial& r) {
  Continuum& p = r.world.particles;
  for (std::size_t i = 0; i < p.owned; i++) {
    const Vec3d x = p.position[i];
    p.velocity[i] = cross(Vec3d{0.5, 2, 1}, x) +
                    Vec3d{0.3 * std::sin(3 * x.x), 0.6 * x.x * x.x - 0.1, 0.4 * x.y};
  }
}

void watchFlight(Trial& r) {
  World& w = r.world;
  const LedgerReport l = reportLedger(w, r.tools, r.all);
  const double forces = sum(
      r, [](const World& x, std::size_t i) { return length(forceOf(x.particles, x.scene, i)); });
  r.notes["impulse"] += forces * w.clock.stepDt;
  r.notes["energy"] = std::max(r.notes["energy"],
                               std::abs(l.energyResidual) / (l.initial.kinetic + l.initial.elastic));
  r.notes["angular momentum"] = std::max(
      r.notes["angular momentum"],
      length(l.now.angularMomentum - l.initial.angularMomentum) / length(l.initial.angularMomentum));
}

std::vector<Figure> measureFlight(Trial& r) {
  const LedgerReport l = reportLedger(r.world, r.tools, r.all);
  return {{"max |energy residual|", r.notes["energy"], 1e-3},
          {"momentum/(sum|F| t)", length(l.now.momentum - l.initial.momentum) / r.notes["impulse"], 1e-14},
          {"angular momentum", r.notes["angular momentum"], 1e-12}};
}

}  // namespace

std::vector<Case> elasticCases() {
  return {{"patch", "linear displacement on a jittered lattice; its gradient (docs/validation/accuracy.md)",
           nullptr, jitter, deformPatch, watchPatch, measurePatch},
          {"rotation",
           "rigid rotation by 360 degrees; no strain, no force",
           nullptr,
           {},
           turnRound,
           {},
           measureRotation},
          {"free_body",
           "free vibration and spin; energy, momentum and angular momentum stay",
           nullptr,
           {},
           launch,
           watchFlight,
           measureFlight}};
}

std::vector<Case> solidCases() {
  std::vector<Case> all;
  for (const auto& part : {elasticCases(), waveCases(), beamCases(), plasticCases(), plasticFlowCases()})
    all.insert(all.end(), part.begin(), part.end());
  return all;
}

}  // namespace thaw::accuracy
