// SPDX-License-Identifier: Apache-2.0
#include "core/heat/heat.hpp"

#include <algorithm>
#include <cmath>

#include "core/materials/enthalpy.hpp"
#include "core/materials/rest_density.hpp"
#include "core/particles/sleep_stage.hpp"

namespace thaw {
namespace {

constexpr double stefanBoltzmann = 5.670374419e-8;  // W/(m^2 K^4)

Thermal stateOf(const Scene& s, const Material& m, const Continuum& p, std::size_t i) {
  if (s.numerics.heat == HeatModel::Paper) return {p.temperature[i], paperFraction(m, p.temperature[i])};
  return thermalOf(m, p.enthalpy[i]);
}

/// Returns the temperature (K) of a particle in a scene without heat: the one of its body or emitter.
double givenTemperature(const Scene& s, std::uint16_t source) {
  return source < s.bodies.size() ? s.bodies[source].temperature
                                  : s.emitters[source - s.bodies.size()].temperature;
}

/// Convection and radiation as a coefficient (W/(m^2 K)) of the temperature difference: T1^4 - T2^4 = (T1^2 +
/// T2^2) (T1 + T2) (T1 - T2).
double surfaceConductance(const Material& m, double T, double ambient) {
  return m.convection + m.emissivity * stefanBoltzmann * (ambient * ambient + T * T) * (ambient + T);
}

/// Returns the coefficient (W/(m^2 K)) for the difference between a particle's temperature T (K) and the
/// ambient temperature. The surface is half a spacing from the particle, and cooler. The heat flux is k (T -
/// T_surface) / (dx / 2) (CJ59 1.9). Without conductivity, the surface has the particle's temperature.
double particleConductance(const Scene& s, const Material& m, double f, double T) {
  const double ambient = s.domain.ambient, inner = 2 * conductivityOf(s.numerics.heat, m, f) / s.spacing;
  if (!(inner > 0)) return surfaceConductance(m, T, ambient);
  double surface = T;
  for (int n = 0; n < 5 && m.emissivity > 0; n++)  // Newton's method
    surface += (inner * (T - surface) - surfaceConductance(m, surface, ambient) * (surface - ambient)) /
               (inner + m.convection + 4 * m.emissivity * stefanBoltzmann * surface * surface * surface);
  const double outer = surfaceConductance(m, surface, ambient);
  return inner * outer / (inner + outer);
}

/// Returns the fraction of a particle's heat above the ambient temperature that is lost in a step. share: the
/// same fraction at the initial rate. The two differ by O(share^3), because conduction supplies heat during
/// the step. The result is below 1, so losses do not overshoot.
double boundedShare(double share) { return -std::expm1(-share * (1 + 0.5 * share)); }

/// Returns the heat (J/kg) that a particle must absorb to reach a thermostat's temperature.
double missingHeat(const Scene& s, const Material& m, const Continuum& p, std::size_t i, double T) {
  return ledgerEnthalpy(s.numerics.heat, m, T, p.liquid.active ? static_cast<double>(p.liquid[i]) : 0) -
         p.enthalpy[i];
}

/// Returns the fraction of a thermostat's remaining heat that is due in the step of dt (s) from `time` (s).
/// 0: inactive.
double shareOf(const Thermostat& t, double time, double dt) {
  const double from = std::max(time, t.start), end = t.start + t.over, left = end - from;
  if (time + dt <= t.start || from > end) return 0;
  if (!(left > 0)) return time <= t.start;
  return std::min(1.0, (time + dt - from) / left);
}

}  // namespace

void setPhase(const Scene& s, const Modules& modules, Continuum& p, std::size_t begin, std::size_t end) {
  for (std::size_t i = begin; i < end; i++) {
    const Material& m = s.materials[p.material[i]];
    double f = restFraction(m);
    if (modules.heat) {
      const Thermal t = stateOf(s, m, p, i);
      p.temperature[i] = t.temperature;
      if (m.melts()) f = t.liquid;
    } else if (m.melts()) {
      f = thermalOf(m, enthalpyOf(m, givenTemperature(s, p.body[i]), 1)).liquid;
    }
    if (p.liquid.active) p.liquid[i] = static_cast<float>(f);
    p.phase[i] = f >= 1 || !m.canBeSolid() ? Liquid : Solid;
    if (p.restDensity.active) p.restDensity[i] = targetRestDensity(m, static_cast<Phase>(p.phase[i]), f);
  }
}

void addOuterHeat(const HeatView& w, double dt, const std::vector<std::uint8_t>* steady) {
  Continuum& p = w.particles;
  const Scene& s = w.scene;
  const auto heats = [](const Material& m) { return m.heatSource != 0; };
  if (!w.modules.surfaceHeat && std::none_of(s.materials.begin(), s.materials.end(), heats)) return;
  const double face = s.spacing * s.spacing;
  for (std::size_t i = 0; i < p.owned; i++) {
    if (steady && (*steady)[i]) continue;
    const Material& m = s.materials[p.material[i]];
    double flow = m.heatSource * p.mass[i];
    if (w.modules.surfaceHeat && (m.convection > 0 || m.emissivity > 0)) {
      const double area = face * static_cast<double>(p.exposedArea[i]);
      const double T = p.temperature[i],
                   f = p.liquid.active ? static_cast<double>(p.liquid[i]) : restFraction(m);
      const double conductance = area > 0 ? area * particleConductance(s, m, f, T) : 0;
      const double share = conductance * dt / (p.mass[i] * heatCapacityOf(s.numerics.heat, m, f));
      flow += conductance * (s.domain.ambient - T) * (share > 1e-8 ? boundedShare(share) / share : 1);
    }
    if (flow == 0) continue;
    p.heatFlow[i] += flow;
    w.ledger.heatIn.add(flow * dt);
  }
}

void addThermostats(const HeatView& w, double dt) {
  if (dt == 0) return;
  Continuum& p = w.particles;
  const Scene& s = w.scene;
  const double time = w.clock.time;
  for (const Thermostat& t : s.thermostats) {
    const double share = shareOf(t, time, dt);
    if (share == 0) continue;
    for (std::size_t i = 0; i < p.owned; i++) {
      if (t.material >= 0 && p.material[i] != t.material) continue;
      const double flow = p.mass[i] * missingHeat(s, s.materials[p.material[i]], p, i, t.temperature) *
                          share / dt;
      p.heatFlow[i] += flow;
      w.ledger.heatIn.add(flow * dt);
    }
  }
}

void updateHeat(const HeatView& w, double dt) {
  Continuum& p = w.particles;
  const Scene& s = w.scene;
  const bool paper = s.numerics.heat == HeatModel::Paper;
  for (std::size_t i = 0; i < p.owned; i++) {
    if (p.sleep.active && p.sleep[i] != awake) continue;
    const Material& m = s.materials[p.material[i]];
    if (paper) {
      p.temperature[i] += dt * p.heatFlow[i] / (p.mass[i] * m.heatCapacity.solid);
      p.enthalpy[i] = ledgerEnthalpy(s.numerics.heat, m, p.temperature[i]);
    } else {
      p.enthalpy[i] += dt * p.heatFlow[i] / p.mass[i];
    }
    const Thermal t = stateOf(s, m, p, i);
    p.temperature[i] = t.temperature;
    if (!p.liquid.active || !m.melts()) continue;
    const float before = p.liquid[i];
    p.liquid[i] = static_cast<float>(t.liquid);
    if (before == p.liquid[i] || !p.softening.active) continue;
    const double gained = p.softening[i] * (static_cast<double>(p.liquid[i]) - static_cast<double>(before));
    p.interaction[i] += gained;
    w.ledger.phaseJump.add(-gained);
  }
}

PhaseChanges changePhase(const Scene& scene, Continuum& p, Counters& counters) {
  PhaseChanges changes;
  for (std::size_t i = 0; i < p.owned; i++) {
    const Material& m = scene.materials[p.material[i]];
    if (p.justFrozen.active) p.justFrozen[i] = 0;
    if (!m.melts() || !m.canBeSolid()) continue;
    const double f = static_cast<double>(p.liquid[i]);
    if (p.phase[i] == Solid && f >= 1 - m.hysteresis) {
      p.phase[i] = Liquid;
      if (p.clamped.active && p.clamped[i] == fixedInPlace) p.clamped[i] = 0;
      counters.melted++;
      changes.melted = true;
    } else if (p.phase[i] == Liquid && f <= m.hysteresis && f < 1 - m.hysteresis) {
      p.phase[i] = Solid;
      p.justFrozen[i] = 1;
      counters.frozen++;
      changes.frozen = true;
    }
  }
  return changes;
}

}  // namespace thaw
