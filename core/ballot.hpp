// Time-step reduction: values of all ranks after a step, reduced by one element-wise maximum.
#pragma once
#include <array>
#include <bit>
#include <span>

#include "core/halo/halo.hpp"
#include "core/time/limits.hpp"

namespace thaw {

/// Minima are maxima of negated values. A flag is above 0 if some rank sets it.
struct Ballot {
  std::array<double, limitNames.size() - kindLimits> negatedLimits{};  ///< s
  double froze = 0, bad = 0, stop = 0, report = 0, checkpoint = 0, melted = 0;
  double stretch2 = 1;          ///< squared largest stretch of solids
  double grip = 0;              ///< largestGrip
  double negatedFastLimit = 0;  ///< s, fastAccelerationLimit
  double filling = 0;           ///< 1, largestFilling
  double surfaceMove2 = 0;      ///< m^2, squared largest displacement of a particle since the last surface
                                ///< update; sent only with a surface or a further body type
  std::array<double, kindLimits> negatedKindLimits{};  ///< s; sent only with a further body type
};

/// Collective: one reduction.
inline void reduce(Ballot& ballot, Reducer& all, const Modules& modules) {
  constexpr std::size_t n = sizeof(Ballot) / sizeof(double);
  std::array<double, n> values = std::bit_cast<std::array<double, n>>(ballot);
  all.maximum(std::span(values).first(modules.kinds()   ? n
                                      : modules.surface ? n - kindLimits
                                                        : n - kindLimits - 1));
  ballot = std::bit_cast<Ballot>(values);
}

}  // namespace thaw
