// SPDX-License-Identifier: Apache-2.0
// Sides of the domain: periodic sides wrap positions, open sides remove particles.
#pragma once
#include <cstdint>
#include <vector>

#include "core/math/exact_sum.hpp"
#include "core/neighbours/grid.hpp"
#include "core/particles/continuum.hpp"
#include "core/scene/scene.hpp"

namespace thaw {

struct Counters;

/// Wraps a position beyond a periodic side into the domain. Returns the gained gravitational potential
/// (J/kg).
double wrapPlace(const CellGrid& grid, const Domain& domain, Vec3d& place);

/// Wraps owned particles beyond periodic sides into the domain. Adds their gain of gravitational potential
/// energy (J) to `potential`; particles that fall endlessly gain such energy.
void wrapPeriodic(const CellGrid& grid, const Domain& domain, Continuum& particles, ExactSum& potential);

/// Region enclosed by open sides (m); infinite along other sides.
struct OpenBox {
  Vec3d low, high;
  /// Returns true for a position beyond an open side. Branch-free, for loops over all particles.
  bool leaves(const Vec3d& x) const {
    return (x.x < low.x) | (x.y < low.y) | (x.z < low.z) | (x.x >= high.x) | (x.y >= high.y) |
           (x.z >= high.z);
  }
};
OpenBox openBox(const Domain& domain);

bool hasOpenSide(const Domain& domain);

/// Counts a particle that leaves at position x (m). If it is beyond several open sides, the farthest one
/// counts.
void countLeaving(const Domain& domain, const Vec3d& x, Counters& counters);

/// Appends rows of [begin, end) beyond an open side, ascending, to `rows`. Sets nextCell of these rows to
/// noCell, so that migration skips them. The caller records and drops them. Particles: Continuum,
/// BodyTypeRows.
template<class Rows>
void findLeaving(const Domain& domain, Rows& particles, std::size_t begin, std::size_t end,
                 std::vector<std::uint32_t>& rows);

}  // namespace thaw
