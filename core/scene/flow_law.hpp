// SPDX-License-Identifier: Apache-2.0
// Viscosity of a liquid as a function of its shear rate (core/flow/rheology/).
#pragma once
#include <utility>
#include <vector>

namespace thaw {

/// Values by temperature: (K, value), ascending in temperature. One entry is a constant.
using TemperatureTable = std::vector<std::pair<double, double>>;

enum class FlowLaw { Newtonian, Bingham, HerschelBulkley, PowerLaw, Carreau };

struct FlowLawSettings {
  FlowLaw law = FlowLaw::Newtonian;
  TemperatureTable yieldStress;  // Pa, interpolated linearly
  TemperatureTable consistency;  // Pa s^n, interpolated logarithmically
  double exponent = 1;           // 1, n
  double infiniteViscosity = 0;  // Pa s, Carreau: at infinite shear rate
  double relaxationTime = 0;     // s, Carreau
  double leastRate = 0;          // 1/s, shear rate that regularises the yield stress; 0: chosen from the
                                 // scene
  double largestViscosity = 0;   // Pa s, upper limit of the viscosity; 0: none
};

}  // namespace thaw
