// SPDX-License-Identifier: Apache-2.0
// Viscosity of a liquid as a function of its shear rate (core/flow/rheology/).
#pragma once
#include <utility>
#include <vector>

namespace thaw {

/// Value by temperature: (K, value), ascending; one entry: a constant.
using TemperatureTable = std::vector<std::pair<double, double>>;

enum class FlowLaw { Newtonian, Bingham, HerschelBulkley, PowerLaw, Carreau };

struct FlowLawSettings {
  FlowLaw law = FlowLaw::Newtonian;
  TemperatureTable yieldStress;  // Pa, interpolated linearly
  TemperatureTable consistency;  // Pa s^n, interpolated logarithmically
  double exponent = 1;           // 1, n
  double infiniteViscosity = 0;  // Pa s, Carreau: at infinite shear rate
  double relaxationTime = 0;     // s, Carreau
  double leastRate = 0;          // 1/s, regularisation of the yield stress; 0: chosen from the scene
  double largestViscosity = 0;   // Pa s, limit of the viscosity; 0: none
};

}  // namespace thaw
