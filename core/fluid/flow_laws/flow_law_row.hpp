// SPDX-License-Identifier: Apache-2.0
// A flow law as a row of the table in core/fluid/flow_laws/laws.hpp, and keys common to several laws.
#pragma once
#include <span>

#include "core/scene/flow_law.hpp"
#include "core/scene/key_table.hpp"

namespace thaw {

/// Coefficients of a flow law at one temperature.
struct FlowCoefficients {
  const FlowLawSettings* settings = nullptr;  ///< coefficients that do not depend on temperature
  double yieldStress = 0;                     ///< Pa
  double viscosity = 0;  ///< Pa s: plastic viscosity, or viscosity at a rate of 1/s (the consistency);
                         ///< Carreau: viscosity at rest
  double leastRate = 0;  ///< 1/s, > 0: regularisation
};

/// A key of [material.NAME.flow].
struct FlowLawKey {
  const char* name;
  bool needed;  ///< true: a scene with this law must set it
  void (*declare)(KeyTable&, const char* name, FlowLawSettings&);
};

struct FlowLawRow {
  FlowLaw law;
  const char *name, *title;  ///< in scenes; in messages
  const char* stress;        ///< documentation of the stress at a shear rate g
  std::span<const FlowLawKey> keys;
  /// Apparent viscosity (Pa s) at a shear rate (1/s); finite at rest. It is monotonic in the rate.
  double (*viscosity)(const FlowCoefficients&, double rate);
  /// Largest d ln(stress) / d ln(rate); at least 1. Larger values shorten steps.
  double (*steepness)(const FlowLawSettings&);
};

// ---- keys that several laws have --------------------------------------------------------------------------

inline constexpr FlowLawKey yieldStressKey{
    "yield_stress", true, [](KeyTable& keys, const char* name, FlowLawSettings& f) {
      keys.byTemperature({name, "Pa", notNegative(),
                          "shear stress below which the liquid does not flow; or a table of pairs by "
                          "temperature, interpolated linearly"},
                         f.yieldStress);
    }};
inline constexpr FlowLawKey viscosityKey{
    "viscosity", true, [](KeyTable& keys, const char* name, FlowLawSettings& f) {
      keys.byTemperature({name, "Pa s", positive(),
                          "bingham: plastic viscosity. herschel_bulkley and power_law: consistency, which is "
                          "the viscosity at a shear rate of 1/s without the yield stress. carreau: viscosity "
                          "at rest. Or a table of pairs by temperature, interpolated logarithmically"},
                         f.consistency);
    }};
inline constexpr FlowLawKey exponentKey{
    "exponent", true, [](KeyTable& keys, const char* name, FlowLawSettings& f) {
      keys.number(name, f.exponent, "", between(0.1, 3),
                  "n of herschel_bulkley, power_law and carreau; below 1 the liquid is shear-thinning");
    }};
inline constexpr FlowLawKey leastRateKey{
    "least_rate", false, [](KeyTable& keys, const char* name, FlowLawSettings& f) {
      keys.number(name, f.leastRate, "1/s", notNegative(),
                  "shear rate below which the law is regularised: a liquid below its yield stress creeps at "
                  "most at this rate. 0: 1e-4 of the expected speed (at least 1 mm/s) over the longest side "
                  "of the domain");
    }};

}  // namespace thaw
