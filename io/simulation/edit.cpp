// SPDX-License-Identifier: Apache-2.0
#include "io/simulation/edit.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstring>

#include "core/materials/enthalpy.hpp"

namespace thaw {
namespace {

/// Compares bits, since NaN equals nothing.
template<class T> bool differs(const T& a, const T& b) { return std::memcmp(&a, &b, sizeof(T)) != 0; }

}  // namespace

Edit startEdit(const Continuum& p) {
  Edit e;
  e.open = true;
  e.velocity.assign(p.velocity.data(), p.velocity.data() + p.owned);
  if (p.temperature.active) e.temperature.assign(p.temperature.data(), p.temperature.data() + p.owned);
  return e;
}

bool isEdited(const Continuum& p, const Edit& e) {
  for (std::size_t i = 0; i < e.velocity.size(); i++)
    if (differs(p.velocity[i], e.velocity[i])) return true;
  for (std::size_t i = 0; i < e.temperature.size(); i++)
    if (differs(p.temperature[i], e.temperature[i])) return true;
  return false;
}

std::string editProblem(const Continuum& p, const Edit& e) {
  for (std::size_t i = 0; i < e.velocity.size(); i++) {
    const Vec3d& v = p.velocity[i];
    if (differs(v, e.velocity[i]) && !(std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z)))
      return fmt::format("velocity of row {} (id {}) is ({:g}, {:g}, {:g}) m/s; expected finite numbers", i,
                         p.id[i], v.x, v.y, v.z);
  }
  for (std::size_t i = 0; i < e.temperature.size(); i++) {
    const double t = p.temperature[i];
    if (differs(t, e.temperature[i]) && !(t >= 0 && std::isfinite(t)))
      return fmt::format("temperature of row {} (id {}) is {:g} K; expected a finite number of at least 0 K",
                         i, p.id[i], t);
  }
  return "";
}

void undoEdit(Continuum& p, const Edit& e) {
  std::copy(e.velocity.begin(), e.velocity.end(), p.velocity.data());
  std::copy(e.temperature.begin(), e.temperature.end(), p.temperature.data());
}

void recordEdit(Continuum& p, Ledger& ledger, const Scene& scene, const Edit& e) {
  for (std::size_t i = 0; i < e.velocity.size(); i++) {
    const Vec3d dv = p.velocity[i] - e.velocity[i];
    if (dv.x == 0 && dv.y == 0 && dv.z == 0) continue;
    ledger.wallWork.add(0.5 * p.mass[i] * dot(dv, p.velocity[i] + e.velocity[i]));
    for (int a = 0; a < 3; a++) ledger.wallImpulse[a].add(p.mass[i] * dv[a]);
  }
  for (std::size_t i = 0; i < e.temperature.size(); i++) {
    if (p.temperature[i] == e.temperature[i]) continue;
    const double f = p.liquid.active ? static_cast<double>(p.liquid[i]) : 0;
    const double enthalpy = ledgerEnthalpy(scene.numerics.heat, scene.materials[p.material[i]],
                                           p.temperature[i], f);
    ledger.heatIn.add(p.mass[i] * (enthalpy - p.enthalpy[i]));
    p.enthalpy[i] = enthalpy;
  }
}

}  // namespace thaw
