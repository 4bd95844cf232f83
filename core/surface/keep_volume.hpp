// The volume in the surface held at that of the particles (after DCG98; future work in K05).
#pragma once
#include "core/surface/surface.hpp"

namespace thaw {

/// Moves every surfel along its normal by keepVolume (V_target - V) / A of its component, at most a quarter of the wanted spacing: the same
/// for all of a component, so that its detail stays. V_target is the volume of the particles, mass over density at rest. Needs
/// Surface::components as measured. Components of fewer than twelve surfels are left alone. Not collective.
void offsetToVolume(Surface& surface, double keepVolume);

/// The largest |V - V_target| / V_target of components with at least twelve surfels.
double volumeError(const Surface& surface);

}  // namespace thaw
