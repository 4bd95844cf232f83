// The sides of the domain: periodic ones bring particles back, open ones let them go.
#pragma once
#include <cstdint>
#include <vector>

#include "core/neighbours/grid.hpp"
#include "core/particles/continuum.hpp"
#include "core/scene/scene.hpp"

namespace thaw {

/// Brings a place beyond a periodic side back into the domain.
void wrapPlace(const CellGrid& grid, const Domain& domain, Vec3d& place);

/// Brings owned particles that crossed a periodic side back into the domain.
void wrapPeriodic(const CellGrid& grid, const Domain& domain, Continuum& particles);

/// Owned rows beyond an open side, ascending, into `rows`. Their nextCell is set to noCell, so that migration leaves them alone; the
/// caller books and drops them.
void findLeaving(const CellGrid& grid, const Domain& domain, Continuum& particles, std::vector<std::uint32_t>& rows);

}  // namespace thaw
