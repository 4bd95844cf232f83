// SPDX-License-Identifier: Apache-2.0
// Enforces the particles' volume on the surface (after DCG98; future work in K05).
#pragma once
#include "core/halo/surface_halos.hpp"
#include "core/particles/continuum.hpp"
#include "core/scene/scene.hpp"
#include "core/surface/data/surface.hpp"
#include "core/surface/work/relax_tools.hpp"

namespace thaw {

/// Largest outward offset and largest inward request of volume enforcement, in particle spacings
/// (levelRiseOf).
inline constexpr double mostOutwardOffset = 0.75, mostInwardOffset = 1.15;

/// Last offset (m) of a component, and its volume (m^3) before that offset. 0: no offset yet.
struct VolumeMove {
  double volume = 0, by = 0;
};

/// Moves surfels along their normals to enforce the volume. A surfel moves by f weight (V_target - V) / sum f
/// A, with liquid fraction f and area A, summed over the component. It moves by at most half the surfel
/// spacing. SurfaceComponent::isoOffset changes by the same offset, so solid surfaces keep position and
/// detail. V_target is the particles' mass over rest density, times the ratio of mesh to particle volume at
/// the start. Nearly frozen components (less than 0.03 of the area liquid) without mesh detail move as a
/// whole, so they keep their shape. The tolerance is 0.001 of V_target, 0.005 for frozen components.
/// Components of fewer than twelve surfels, solids that never were liquid, and surfaces with a large hole do
/// not move. With `start`, grown solids are corrected once and keep their position afterwards. moves:
/// state of the calls in one update for each component, empty at the first call. Requires: measured
/// Surface::components. Not collective.
void offsetToVolume(Surface& surface, const Bins& surfelBins, double weight, double particleSpacing,
                    bool start, std::vector<VolumeMove>& moves);

/// Returns whether a component would move.
bool volumesDeviate(const Surface& surface, bool start);

/// Lists the offsets SurfaceComponent::isoOffset (m) of liquid surfaces for the iterations. Without the
/// offsets, each update would move the surface back to its level.
void listIsoOffsets(const Scene& scene, const Surface& surface, std::vector<ComponentIsoOffset>& isoOffset);

/// Records Continuum::surfaceVolumeRatio at the start, also in the copies. For sampled bodies, it is the
/// volume of the surfaces over the volume of the particles. For other bodies, it is 1. Requires: measured
/// Surface::components; particle copies. Collective.
void recordStartVolumes(const Scene& scene, Continuum& particles, Surface& surface, SurfaceHalos halos);

}  // namespace thaw
