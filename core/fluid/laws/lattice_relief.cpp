// SPDX-License-Identifier: Apache-2.0
#include "core/fluid/laws/lattice_relief.hpp"

#include <algorithm>

namespace thaw {
namespace {

/// Share of the force that is removed. If all of it were removed, no force would keep the particles evenly
/// spaced.
constexpr double reliefShare = 0.75;
/// Share of solid neighbours at which half of the force acts, which corresponds to a distance of 0.95 support
/// radii. It bounds the force of pairs that come into range within half a step.
constexpr double faintContact = 1e-5;

}  // namespace

Vec3f latticeRelief(const ReliefInput& in) {
  const double size2 = dot(in.away, in.away);
  const Vec3d along = in.gradient - in.away * (dot(in.gradient, in.away) / std::max(size2, 1e-30));
  return single(along *
                (2 * reliefShare * in.pressure * in.volume / (in.support * (in.solidShare + faintContact))));
}

}  // namespace thaw
