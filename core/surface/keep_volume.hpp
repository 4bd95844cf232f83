// The volume in the surface held at that of the particles (after DCG98; future work in K05).
#pragma once
#include "core/halo/surface_halos.hpp"
#include "core/surface/relax_tools.hpp"
#include "core/world.hpp"

namespace thaw {

/// Volume keeping may hold a surface this many spacings of the particles outside their level at most, and ask
/// for this much less than it holds (tighteningOf).
inline constexpr double mostRaised = 0.75, mostDrawnIn = 1.15;

/// The last offset of a component, and the volume (m^3) that it held before; 0: none yet.
struct VolumeMove {
  double volume = 0, by = 0;
};

/// Moves every surfel along its normal by its liquid fraction times keepVolume (V_target - V) / sum of liquid
/// fractions times areas of its component, at most half the wanted spacing, and SurfaceComponent::raised by
/// as much: solid surfaces keep their place and detail. V_target is the volume of the particles, mass over
/// density at rest, times what the mesh of their body held over it at the start. If less than three
/// hundredths of a component are liquid, it was held when it was liquid, and hardly any of a mesh's detail is
/// left on it, all that has none moves by the same: what froze keeps its shape. Those are moved that are off
/// V_target by more than a thousandth, or by half a percent of what has frozen. Needs Surface::components as
/// measured. Components of fewer than twelve surfels, solids that never were liquid, and those with a large
/// hole are left alone. Not collective. start: solids that were grown from their particles are moved
/// likewise, by what the level of the colour is off, and keep their place from then on. moves: what the calls
/// of one update have done so far, of each component; empty at the first.
void offsetToVolume(Surface& surface, const Bins& surfelBins, double keepVolume, double particleSpacing,
                    bool start, std::vector<VolumeMove>& moves);

/// Would it move any?
bool volumesAreOff(const Surface& surface, bool start);

/// For the iterations: what holds the liquid surface of each component at SurfaceComponent::raised (m) off
/// the level. Without it they would draw the surface back to the level in each update, and all that volume
/// keeping has to move it is done again.
void listRaised(const World& world, std::vector<RaisedComponent>& raised);

/// Continuum::surfaceShare: what the surfaces of bodies with a mesh hold now over the volume of their
/// particles; 1 of the others; and the share of the copies. At the start. Needs Surface::components as
/// measured, and particle copies. Collective.
void keepStartVolumes(World& world, SurfaceHalos halos);

}  // namespace thaw
