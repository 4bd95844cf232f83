// How well the surface of a run holds the volume of its particles: the worst of all frames.
#pragma once
#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "core/surface/surface.hpp"

namespace thaw {

/// Components are told apart by size: a piece of fewer particles than this is hardly more than its rim. Of
/// those, from leastSmallParticles on the worst is told by itself; fewer are spheres. Of fewer surfels volume
/// keeping leaves a component alone.
inline constexpr std::int64_t leastHeldParticles = 30, leastSmallParticles = 5, leastHeldSurfels = 12;

/// Of its area may be missing in a surface whose volume is told for sure. Where rags of a mesh lie on the
/// cracks of a body, 3 % was missing, and its volume told 3 to 5 % too large.
inline constexpr double surelyClosed = 0.01;

/// A component at a frame. The volume of its surface is (1 + off) times the other.
struct VolumeOff {
  double off = 0;
  std::uint64_t label = noComponent;
  std::int64_t particles = 0;
  double time = 0;  ///< s
};

/// All components of a frame.
struct VolumeSums {
  double time = 0, volume = 0, wanted = 0;  ///< s, m^3, m^3
  std::int64_t particles = 0, missed = 0;   ///< of all, and of components that are more than a hundredth off
                                            ///< what is to be held
  double off() const { return wanted > 0 ? volume / wanted - 1 : 0; }
  double missedShare() const {
    return particles > 0 ? static_cast<double>(missed) / static_cast<double>(particles) : 0;
  }
};

/// The worst of the frames that are noted; the first of equals.
struct VolumeHeld {
  bool any = false;       ///< a component was there
  VolumeOff ofParticles;  ///< against the volume of the particles
  VolumeOff ofWanted;     ///< against what volume keeping is to hold (SurfaceComponent::wantedVolume)
  VolumeOff small;        ///< the same of components of leastSmallParticles to leastHeldParticles - 1
  VolumeSums sum;         ///< the frame whose sum of volumes is farthest off
  VolumeSums missing;     ///< the frame with the largest share of particles in components that miss it
  std::int64_t particles = 0, missed = 0;  ///< of VolumeSums, of all frames together
  VolumeOff open;           ///< the surface that closes worst: SurfaceComponent::open in place of `off`
  std::int64_t unsure = 0;  ///< of the particles those in components of leastHeldParticles and more that
                            ///< close worse than surelyClosed
};

void noteVolumes(VolumeHeld& held, const std::vector<SurfaceComponent>& components, double time);

/// Lines for the end of a run; none where there was no component.
std::vector<std::string> volumeHeldLines(const VolumeHeld& held);
nlohmann::ordered_json volumeHeldJson(const VolumeHeld& held);
/// Where a component, or the sum, is more than 1 % off the volume to be held, or a small piece more than 10
/// %, or more than 1 % of the particles are in components that miss it by 1 %; else empty.
std::string volumeHeldWarning(const VolumeHeld& held);

}  // namespace thaw
