// SPDX-License-Identifier: Apache-2.0
// Viscosity of a liquid as a function of its shear rate (docs/theory/rheology.md).
#pragma once
#include "core/fluid/flow_laws/flow_law_row.hpp"
#include "core/scene/material_use.hpp"
#include "core/scene/scene.hpp"

namespace thaw {

/// Returns the row of a law in the table of core/fluid/flow_laws/laws.hpp. Requires: it is not Newtonian.
const FlowLawRow& rowOf(FlowLaw law);
/// Returns the largest d ln(stress) / d ln(rate) of a law; at least 1. Requires: it is not Newtonian.
inline double steepnessOf(const FlowLawSettings& s) { return rowOf(s.law).steepness(s); }
/// Returns true if the law is regularised at its least rate.
bool hasLeastRate(FlowLaw law);
/// Returns true if a coefficient is a table by temperature.
bool dependsOnTemperature(const FlowLawSettings& settings);
/// Declares the keys of [material.NAME.flow]. Rejects keys that the law does not have, and missing keys that
/// it requires.
void readFlowLaw(KeyTable& keys, FlowLawSettings& settings);

/// Shear rate (1/s) below which yield stress and power laws are regularised. It is the material's value, or
/// else 1e-4 of the expected speed divided by the longest side of the domain.
double leastRateOf(const Scene& scene, const Material& material);

/// Returns the coefficients at a temperature (K). Viscosities are interpolated logarithmically. The result
/// refers to `settings`, which must outlive it.
FlowCoefficients flowCoefficients(const FlowLawSettings& settings, double leastRate, double temperature);

/// Apparent viscosity (Pa s) of the law at a shear rate (1/s). It is at most
/// FlowLawSettings::largestViscosity.
double apparentViscosity(const FlowCoefficients& coefficients, double rate);

/// Largest viscosity (Pa s) over the temperatures of the law's tables. It occurs at rest, or for n > 1 at the
/// largest rate (1/s).
double largestFlowViscosity(const FlowLawSettings& settings, double leastRate, double largestRate);
/// Smallest viscosity (Pa s) over the temperatures of the law's tables, at rates up to `largestRate` (1/s).
double leastFlowViscosity(const FlowLawSettings& settings, double leastRate, double largestRate);

/// Largest shear rate (1/s) that a scene resolves: the expected speed over the spacing.
double resolvedRate(const Scene& scene);

/// The same two functions for a material of a scene, with its least rate and the largest rate that the scene
/// resolves.
double largestFlowViscosity(const Scene& scene, const Material& material);
double leastFlowViscosity(const Scene& scene, const Material& material);

}  // namespace thaw
