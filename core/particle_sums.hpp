// The parts of a step that are sums over pairs of neighbours.
#pragma once
#include "core/step.hpp"

namespace thaw {

/// The columns that sums over neighbours read of ghosts, by the modules that are on.
ColumnList ghostColumns(World& world);

/// What a sum over neighbours reads and writes, of this world.
PairSums pairSumsOf(World& world, StepTools& tools);

/// Zero for everything that a step adds up. pairsSet: but not for what the sums over pairs set, where those
/// of one liquid (Modules::uniform) come first.
void clearRates(World& world, bool pairsSet = false);

/// StepTools::inner of the cells known by now: 1 where sums need no ghosts.
void markInner(const World& world, const CellHalo& halo, StepTools& tools);

/// A tiny push apart, in a direction that only the id decides, for particles that share their place with
/// another (docs/validation/stability.md B9). before: Counters::coincidentPairs before the sums. For the next
/// step: at the end of an evaluation.
void separateCoincident(World& world, const StepTools& tools, std::int64_t before);

/// Searches and adds to Continuum::force the force of a pressure of 1 Pa everywhere, -2 V_i sum V_j grad W
/// (N). Needs ghosts.
void sumUnitPressure(World& world, StepTools& tools);

/// After sumUnitPressure, at the same places: the filling (without walls), and in Continuum::force that of
/// pressures of 1 Pa times what the filling of liquids has above 1: -V_i times the slope (1/m) by the place
/// of i of half the sum of its squares. Collective.
void sumExcessPressure(World& world, CellHalo& halo, StepTools& tools);

/// Inner passes work on particles whose neighbours are all owned; boundary passes on the others. Density
/// passes search first.
enum class NeighbourPass { InnerDensity, BoundaryDensity, InnerForces, BoundaryForces };
/// elapsed: s, of the step that led here, over which liquids carry their density.
void sumOverNeighbours(World& world, StepTools& tools, NeighbourPass pass, double elapsed = 0);

/// Viscous forces of the implicit solver (fluid/implicit_viscosity/), after all others.
void solveViscosity(World& world, Halos halos, StepTools& tools, const WallContext& walls);

/// Continuum::softening of compression and surface tension, from Continuum::interaction as it is after the
/// sums over neighbours and before contacts are added. Summed compression is proportional to the particle's
/// liquid fraction, carried compression is not; the tension of a pair is proportional to both fractions.
/// Liquids only.
void beginSoftening(World& world, const StepTools& tools);

}  // namespace thaw
