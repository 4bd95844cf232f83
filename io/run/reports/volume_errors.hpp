// SPDX-License-Identifier: Apache-2.0
// Errors of the volume that the surface of a run encloses: the largest over all frames.
#pragma once
#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "core/surface/data/surface.hpp"

namespace thaw {

/// Size classes of components. Components of fewer particles than leastComponentParticles are mostly rim. The
/// largest error of those with at least leastSmallParticles is reported separately. Smaller ones are spheres.
/// Volume control skips components of fewer surfels than leastControlledSurfels.
inline constexpr std::int64_t leastComponentParticles = 30, leastSmallParticles = 5,
                              leastControlledSurfels = 12;

/// Largest fraction of missing area of a surface with a reliable volume. Where a mesh has spurs along
/// cracks of a body, 3 % is missing. The volume is then 3 to 5 % too large.
inline constexpr double closedTolerance = 0.01;

/// A component at a frame. The volume of its surface is (1 + off) times the reference volume.
struct VolumeError {
  double off = 0;
  std::uint64_t label = noComponent;
  std::int64_t particles = 0;
  double time = 0;  ///< s
};

/// All components of a frame together.
struct VolumeSums {
  double time = 0, volume = 0, target = 0;  ///< s, m^3, m^3
  std::int64_t particles = 0, missed = 0;  ///< all particles, and those in components more than 1 % off their
                                           ///< target volume
  double off() const { return target > 0 ? volume / target - 1 : 0; }
  double missedShare() const {
    return particles > 0 ? static_cast<double>(missed) / static_cast<double>(particles) : 0;
  }
};

/// The largest errors over all recorded frames. Of equal errors, the first one is kept.
struct VolumeErrors {
  bool any = false;              ///< at least one component
  VolumeError againstParticles;  ///< against the volume of the particles
  VolumeError againstTarget;     ///< against the target volume (SurfaceComponent::targetVolume)
  VolumeError small;   ///< against the target, for leastSmallParticles to leastComponentParticles - 1
                       ///< particles
  VolumeSums sum;      ///< the frame with the largest error of the summed volume
  VolumeSums missing;  ///< the frame with the largest share of missed particles
  std::int64_t particles = 0, missed = 0;  ///< VolumeSums over all frames
  VolumeError open;         ///< the most open surface: SurfaceComponent::open in place of `off`
  std::int64_t unsure = 0;  ///< particles in components of at least leastComponentParticles that are more
                            ///< open than closedTolerance
};

void recordVolumes(VolumeErrors& errors, const std::vector<SurfaceComponent>& components, double time);

/// Returns lines for the end of a run; none without components.
std::vector<std::string> volumeErrorLines(const VolumeErrors& errors);
nlohmann::ordered_json volumeErrorJson(const VolumeErrors& errors);
/// Returns a warning if a component or the sum is more than 1 % off the target volume, or a small component
/// more than 10 %. It also warns if more than 1 % of the particles are in components that are more than 1 %
/// off. Else returns "".
std::string volumeErrorWarning(const VolumeErrors& errors);

}  // namespace thaw
