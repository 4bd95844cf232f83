// SPDX-License-Identifier: Apache-2.0
// Factors of coefficients and forces as functions of time.
#pragma once
#include <utility>
#include <vector>

namespace thaw {

/// A piecewise linear factor: points (s, 1), constant before the first and after the last. Without points,
/// the factor is 1.
struct FactorInTime {
  std::vector<std::pair<double, double>> points;
  double at(double time) const;
  double mean(double from, double to) const;   ///< exact mean over [from, to]; requires from < to
  bool linear(double from, double to) const;   ///< true if the factor is linear between these times
  double least(double from, double to) const;  ///< minimum over these times; `to` may be infinite
  double most(double from, double to) const;   ///< maximum of the absolute value
};

}  // namespace thaw
