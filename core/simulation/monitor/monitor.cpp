// SPDX-License-Identifier: Apache-2.0
#include "core/simulation/monitor/monitor.hpp"

#include <algorithm>
#include <cmath>

#include "core/fluid/flow_laws/flow_law.hpp"
#include "core/materials/contact_modulus.hpp"
#include "core/scene/phase_density.hpp"
#include "core/sheet/data/plan_sheets.hpp"
#include "core/simulation/time/limits.hpp"
#include "core/solid/laws/elastic_law.hpp"
#include "core/time/frame_times.hpp"

namespace thaw {
namespace {

constexpr std::int64_t mostRequiredSnapshots = 64, mostBackoff = 60;

bool recovers(const Material& m) {
  if (m.volumeStiffness > 0) return true;
  return boundLaw(m).law->resistsInversion;
}

/// Returns the step (s) of the clock without backoff. For an unlimited step it is the longest finite step,
/// since half of an unlimited step would be unlimited.
double fullStep(const Clock& c, double factor) {
  return c.dt < never ? c.dt / factor : longestUnlimitedStep(c);
}

/// Returns the number of active halvings after one more failure.
std::int64_t nextBackoff(const MonitorState& failed, const Clock& c) {
  std::int64_t h = std::min(failed.backoff + 1, mostBackoff);
  // If frames shorten the step, backoff from a longer step would have no effect.
  while (c.every > 0 && h < mostBackoff && std::ldexp(failed.fullStep, 1 - static_cast<int>(h)) > c.every)
    h++;
  return h;
}

}  // namespace

MonitorLimits monitorLimits(const Scene& s, const Modules& modules,
                            const std::vector<LiquidMaterial>& liquids, const StepLimits& materials) {
  const Numerics& n = s.numerics;
  MonitorLimits b;
  double given = 0, fastest = 0, slowest = never;  // speeds of rotating bodies; speeds of waves
  for (const Body& body : s.bodies)
    given = std::max(given, length(body.velocity) + length(body.spin) * length(s.domain.max - s.domain.min));
  const auto wave = [&](double c) {
    fastest = std::max(fastest, c);
    slowest = std::min(slowest, c);
  };
  for (std::size_t k = 0; k < s.materials.size(); k++) {
    const Material& m = s.materials[k];
    if (modules.fluid && (!m.canBeSolid() || m.melts() || m.liquidAtStart)) wave(liquids[k].soundSpeed);
    if (modules.solid && m.canBeSolid()) wave(std::sqrt(largestContactModulus(m) / solidDensityOf(m)));
  }
  b.expected = std::max({expectedSpeed(s), given, expectedSheetSpeed(s)});
  if (slowest < never) b.expected = std::max(b.expected, 0.1 * slowest);
  if (n.watchSpeed < never) b.speed = n.watchSpeed * (b.expected + 0.1 * fastest);
  b.relativeDensity = n.watchDensity;
  double longest = *std::min_element(materials.value.begin(), materials.value.end());
  if (modules.flowLaw && !modules.implicitViscosity)
    for (std::size_t k = 0; k < s.materials.size(); k++)
      if (hasFlowLaw(s.materials[k])) longest = std::min(longest, flowLawStepLimit(s, s.materials[k]));
  // The expected speed also limits the step. This matters above all if materials limit only heat.
  if (longest < never && b.expected > 0)
    longest = std::min(longest, supportsPerStep * n.support * s.spacing / b.expected);
  b.step = longest < never ? n.watchStep * longest : n.watchStep * 1e-5 * s.end;
  b.inverted = n.watchInverted;
  b.energy = n.watchEnergy;
  return b;
}

double largestRelativeDensity(const Continuum& p) {
  constexpr std::size_t lanes = 16;  // independent chains, to hide latency
  float most[lanes] = {};
  const auto see = [&](std::size_t i, std::size_t l) {
    const float f = p.phase[i] == Liquid ? p.relativeDensity[i] : 0.0f;
    most[l] = f > most[l] ? f : most[l];
  };
  const std::size_t whole = p.owned - p.owned % lanes;
  for (std::size_t i = 0; i < whole; i += lanes)
    for (std::size_t l = 0; l < lanes; l++) see(i + l, l);
  for (std::size_t i = whole; i < p.owned; i++) see(i, i - whole);
  return static_cast<double>(*std::max_element(most, most + lanes));
}

Failure failureOf(const World& w, const MonitorLimits& b, const StepLimits& limits, double relativeDensity) {
  const double perSpeed = limits[Limit::Speed];
  if (perSpeed < supportsPerStep * w.grid.support / b.speed) return Failure::Speed;
  if (relativeDensity > b.relativeDensity) return Failure::Density;
  const double shortest = nextFactor(w.monitor) * limits[limits.smallest()];
  if (!(w.scene.numerics.fixedStep > 0) && shortest < b.step) return Failure::Step;
  return Failure::None;
}

Failure checkEnergyBudget(const World& w, const MonitorLimits& b, const LedgerReport& budget, Reducer& all) {
  const double expected = 0.5 * budget.now.mass * b.expected * b.expected;
  if (b.energy < never &&
      !(budget.energyResidual - w.monitor.residual <=
        b.energy * std::max({w.monitor.scale, std::abs(budget.wallWork), expected, budget.energyRounding})))
    return Failure::Energy;
  // Detects slow growth, which stays below the relative limit between two snapshots.
  const double largest = std::max(
      {w.monitor.largest, budget.energyScale, 0.01 * expected, budget.energyRounding});
  if (b.energy < never && budget.energyResidual > b.energy * largest &&
      budget.energyResidual > w.monitor.residual)
    return Failure::Growth;
  if (!w.modules.solid || !(b.inverted < never)) return Failure::None;
  std::int64_t counts[2] = {0, 0};
  for (std::size_t s = 0; s < w.solids.owned; s++) {
    if (recovers(w.scene.materials[w.solids.material[s]])) continue;
    counts[0]++;
    counts[1] += !(determinant(w.solids.deformation[s]) > 0);
  }
  all.sum(counts);
  return static_cast<double>(counts[1]) > b.inverted * static_cast<double>(counts[0]) ? Failure::Inverted
                                                                                      : Failure::None;
}

double nextFactor(const MonitorState& s) {
  return std::min(std::ldexp(1.0, -static_cast<int>(s.backoff)), 1.1 * s.factor);
}

void acceptState(MonitorState& s, const Clock& clock, const LedgerReport& budget) {
  s.snapshotStep = clock.step;
  s.residual = budget.energyResidual;
  s.scale = budget.energyScale;
  s.largest = std::max(s.largest, budget.energyScale);
  s.fullStep = fullStep(clock, s.factor);
  if (s.backoff == 0 && s.requiredSnapshots == 1) return;
  if (++s.snapshotsSinceChange < s.requiredSnapshots || clock.time < s.passed) return;
  s.snapshotsSinceChange = 0;
  if (s.backoff == 0) {
    s.requiredSnapshots /= 2;  // an old failure must not prolong the backoff of the next failure
    return;
  }
  s.backoff--;
  s.failures = s.backoff == 0 ? 0 : std::max(s.failures - 1, std::int64_t(0));
}

bool mayRetry(const Numerics& n, const MonitorState& monitor, const Clock& clock, const MonitorLimits& b) {
  return n.retryEvery > 0 && monitor.failures < n.retries && !retryTooShort(monitor, clock, b);
}

bool retryTooShort(const MonitorState& monitor, const Clock& clock, const MonitorLimits& b) {
  return std::ldexp(monitor.fullStep, -static_cast<int>(nextBackoff(monitor, clock))) < b.step;
}

void halveStep(MonitorState& s, Clock& c, const Scene& scene, const MonitorState& failed, double failedAt) {
  const double full = fullStep(c, s.factor);
  s.failures = failed.failures + 1;
  s.backoff = nextBackoff(failed, c);
  s.requiredSnapshots = std::min(2 * failed.requiredSnapshots, mostRequiredSnapshots);
  s.snapshotsSinceChange = 0;
  const double stretch = static_cast<double>(scene.numerics.retryEvery) *
                         std::min(full, longestUnlimitedStep(c));
  s.passed = std::max(failed.passed, failedAt + stretch);
  s.factor = std::min(s.factor, std::ldexp(1.0, -static_cast<int>(s.backoff)));
  c.dt = s.factor * full;
}

}  // namespace thaw
