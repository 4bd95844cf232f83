// SPDX-License-Identifier: Apache-2.0
// Bounds of initial values. Larger values would make energies and radiative heat overflow.
#pragma once
#include <cmath>

namespace thaw {

inline constexpr double fastestStart = 299792458;  // m/s, speed of light
inline constexpr double hottestStart = 1e32;       // K

/// Returns true for a valid component of an initial velocity (m/s); false for NaN.
inline bool isStartSpeed(double v) { return std::abs(v) <= fastestStart; }
inline bool isStartTemperature(double T) { return T > 0 && T <= hottestStart; }

inline constexpr const char* expectedSpeeds =
    "expected velocity components of at most 299792458 m/s (speed of light)";
inline constexpr const char* expectedTemperatures = "expected temperatures above 0 K, at most 1e32 K";

}  // namespace thaw
