// SPDX-License-Identifier: Apache-2.0
// Time-step reduction: values of all ranks after a step, reduced by one element-wise maximum.
#pragma once
#include <algorithm>
#include <array>
#include <bit>
#include <span>

#include "core/halo/halo.hpp"
#include "core/simulation/time/limits.hpp"

namespace thaw {

/// Minima are stored as negated values. A flag is above 0 if any rank sets it.
struct StepReduction {
  std::array<double, limitNames.size() - bodyTypeLimits> negatedLimits{};  ///< s
  double froze = 0, bad = 0, stop = 0, report = 0, checkpoint = 0, melted = 0;
  double pairsChange = 0;       ///< flag: energies of contacts or cohesion change with the phase
  double rigidity = 0;          ///< flag: parts of elastic solids become rigid or elastic
  double stretch2 = 1;          ///< squared largest stretch of solids; 0: all solids are rigid and do not
                                ///< touch
  double strainBound = 0;       ///< largestStrainBound
  double negatedFastLimit = 0;  ///< s, fastAccelerationLimit
  double relativeDensity = 0;   ///< 1, largestRelativeDensity
  double surfaceMove2 = 0;      ///< m^2, squared largest displacement of a particle since the last surface
                                ///< update. Sent only with a surface or a further body type
  std::array<double, bodyTypeLimits> negatedBodyTypeLimits{-never, -never};  ///< s; sent only with a further
                                                                             ///< body type

  /// Lowers a limit to at most `seconds`.
  void lower(Limit limit, double seconds) {
    const std::size_t k = static_cast<std::size_t>(limit);
    double& negated = k < negatedLimits.size() ? negatedLimits[k]
                                               : negatedBodyTypeLimits[k - negatedLimits.size()];
    negated = std::max(negated, -seconds);
  }
};

/// Reduces all values over ranks, in one reduction. Collective.
inline void reduceOverRanks(StepReduction& reduction, Reducer& all, const Modules& modules) {
  constexpr std::size_t n = sizeof(StepReduction) / sizeof(double);
  std::array<double, n> values = std::bit_cast<std::array<double, n>>(reduction);
  all.maximum(std::span(values).first(modules.bodyTypes() ? n
                                      : modules.surface   ? n - bodyTypeLimits
                                                          : n - bodyTypeLimits - 1));
  reduction = std::bit_cast<StepReduction>(values);
}

}  // namespace thaw
