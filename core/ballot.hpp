// What the ranks tell each other after a step: reduced in one go to the largest of each.
#pragma once
#include <array>
#include <bit>
#include <span>

#include "core/halo/halo.hpp"
#include "core/time/limits.hpp"

namespace thaw {

/// Minima are maxima of negated values. Flags: above 0 where some rank says so.
struct Ballot {
  std::array<double, limitNames.size() - kindLimits> negatedLimits{};  ///< s
  double froze = 0, bad = 0, stop = 0, report = 0, checkpoint = 0, melted = 0;
  double stretch2 = 1;          ///< square of the largest stretch of solids
  double grip = 0;              ///< largestGrip
  double negatedFastLimit = 0;  ///< s, fastAccelerationLimit
  double filling = 0;           ///< 1, largestFilling
  double surfaceMove2 = 0;  ///< m^2, farthest that a particle has come since the last update of the surface,
                            ///< squared; sent only with a surface or a further kind
  std::array<double, kindLimits> negatedKindLimits{};  ///< s; sent only with a further kind
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
