// SPDX-License-Identifier: Apache-2.0
// Viscosity of a particle, computed from other fields.
#pragma once
#include <cstddef>

#include "core/fluid/flow_laws/flow_law.hpp"
#include "core/materials/liquid_materials.hpp"
#include "core/particles/continuum.hpp"

namespace thaw {

/// Viscosity (Pa s) at a liquid fraction f: the flow law's at the last shear rate, or the material's at the
/// particle's temperature. 0 until a first shear rate is known.
inline double viscosityOfParticle(const Material& m, const Continuum& p, std::size_t i, double f) {
  if (hasFlowLaw(m)) return p.apparentViscosity.active ? static_cast<double>(p.apparentViscosity[i]) : 0;
  return viscosityAt(m, f, p.temperature.active ? p.temperature[i] : 0);
}

}  // namespace thaw
