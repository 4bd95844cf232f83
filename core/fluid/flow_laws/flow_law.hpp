// SPDX-License-Identifier: Apache-2.0
// Viscosity of a liquid as a function of its shear rate (docs/theory/rheology.md).
#pragma once
#include "core/scene/material_use.hpp"
#include "core/scene/scene.hpp"

namespace thaw {

/// Coefficients of a flow law at one temperature.
struct FlowCoefficients {
  FlowLaw law = FlowLaw::Newtonian;
  double yieldStress = 0;  ///< Pa
  double viscosity = 0;    ///< Pa s: plastic viscosity; at a rate of 1/s (the consistency); Carreau: at rest
  double exponent = 1;     ///< 1
  double infinite = 0;     ///< Pa s, Carreau: at infinite shear rate
  double time = 0;         ///< s, Carreau
  double leastRate = 0;    ///< 1/s, > 0: regularisation
  double largest = never;  ///< Pa s, limit of the viscosity
};

/// Returns "Bingham", "Herschel-Bulkley", "power law" or "Carreau".
const char* nameOf(FlowLaw law);

/// Shear rate (1/s) below which yield stress and power laws are regularised. It is that of the material, or
/// else 1e-4 of the expected speed over the longest side of the domain.
double leastRateOf(const Scene& scene, const Material& material);

/// Returns the coefficients at a temperature (K). Viscosities are interpolated logarithmically.
FlowCoefficients flowCoefficients(const FlowLawSettings& settings, double leastRate, double temperature);

/// Apparent viscosity (Pa s) at a shear rate g (1/s), at most `largest`.
/// Bingham [B22], Herschel-Bulkley [HB26], power law: K (g^2 + e^2)^((n-1)/2) + tau_y (1 - exp(-g/e)) / g.
/// Here e is the least rate; the second term is Papanastasiou's [P87].
/// Carreau [C72]: mu_inf + (mu_0 - mu_inf) (1 + (lambda g)^2)^((n-1)/2).
double apparentViscosity(const FlowCoefficients& coefficients, double rate);

/// Largest viscosity (Pa s) at any of the temperatures of its tables: at rest, or for n > 1 at the largest
/// rate (1/s).
double largestFlowViscosity(const FlowLawSettings& settings, double leastRate, double largestRate);
/// Smallest viscosity (Pa s) at any of the temperatures of its tables, at rates up to `largestRate` (1/s).
double leastFlowViscosity(const FlowLawSettings& settings, double leastRate, double largestRate);

/// Largest shear rate (1/s) that a scene resolves: the expected speed over the spacing.
double resolvedRate(const Scene& scene);

/// The same two for a material of a scene, from its least rate and the largest rate that the scene resolves.
double largestFlowViscosity(const Scene& scene, const Material& material);
double leastFlowViscosity(const Scene& scene, const Material& material);

}  // namespace thaw
