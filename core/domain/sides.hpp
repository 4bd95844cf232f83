// The sides of the domain: periodic ones bring particles back, open ones let them go.
#pragma once
#include <cstdint>
#include <vector>

#include "core/math/exact_sum.hpp"
#include "core/neighbours/grid.hpp"
#include "core/particles/continuum.hpp"
#include "core/scene/scene.hpp"

namespace thaw {

struct Counters;

/// Brings a place beyond a periodic side back into the domain. Returns the potential of gravity (J/kg) that
/// this gives.
double wrapPlace(const CellGrid& grid, const Domain& domain, Vec3d& place);

/// Brings owned particles that crossed a periodic side back into the domain. The potential of gravity (J)
/// that this gives them, where they fall round and round, is added to `potential`.
void wrapPeriodic(const CellGrid& grid, const Domain& domain, Continuum& particles, ExactSum& potential);

/// What open sides enclose; without end along the others (m).
struct OpenBox {
  Vec3d low, high;
  /// Is a place beyond an open side? Without branches, for loops over all particles.
  bool leaves(const Vec3d& x) const {
    return (x.x < low.x) | (x.y < low.y) | (x.z < low.z) | (x.x >= high.x) | (x.y >= high.y) |
           (x.z >= high.z);
  }
};
OpenBox openBox(const Domain& domain);

bool hasOpenSide(const Domain& domain);

/// Counts one that leaves at x: at the open side that it is farthest beyond.
void countLeaving(const Domain& domain, const Vec3d& x, Counters& counters);

/// Rows [begin, end) beyond an open side, ascending, are added to `rows`. Their nextCell is set to noCell, so
/// that migration leaves them alone; the caller books and drops them. Particles: Continuum, KindRows.
template<class Rows>
void findLeaving(const Domain& domain, Rows& particles, std::size_t begin, std::size_t end,
                 std::vector<std::uint32_t>& rows);

}  // namespace thaw
