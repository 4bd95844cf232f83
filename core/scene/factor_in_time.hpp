// Factors of coefficients and forces, as the scene gives them over time.
#pragma once
#include <utility>
#include <vector>

namespace thaw {

/// A factor that changes in time: (s, 1), linear in between, constant before and after; 1 where empty.
struct FactorInTime {
  std::vector<std::pair<double, double>> points;
  double at(double time) const;
  double mean(double from, double to) const;   ///< over these times, exactly; needs from < to
  bool linear(double from, double to) const;   ///< does it change evenly between these times, without a
                                               ///< corner?
  double least(double from, double to) const;  ///< over these times, `to` may be infinite
  double most(double from, double to) const;   ///< of its size, without its sign
};

}  // namespace thaw
