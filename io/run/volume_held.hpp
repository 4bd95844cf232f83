// How well the surface of a run holds the volume of its particles: the worst of all frames.
#pragma once
#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "core/surface/surface.hpp"

namespace thaw {

/// What counts: of fewer particles a piece is hardly more than its rim, and of fewer surfels volume keeping leaves it alone.
inline constexpr std::int64_t leastHeldParticles = 30, leastHeldSurfels = 12;

/// A component at a frame. The volume of its surface is (1 + off) times the other.
struct VolumeOff {
  double off = 0;
  std::uint64_t label = noComponent;
  std::int64_t particles = 0;
  double time = 0;  ///< s
};

/// The worst of the frames that are noted; the first of equals.
struct VolumeHeld {
  bool any = false;        ///< a component that counts was there
  VolumeOff ofParticles;   ///< against the volume of the particles
  VolumeOff ofWanted;      ///< against what volume keeping is to hold (SurfaceComponent::wantedVolume)
};

void noteVolume(VolumeHeld& held, const SurfaceComponent& component, double time);

/// A line for the end of a run; empty where nothing counts.
std::string volumeHeldLine(const VolumeHeld& held);
nlohmann::ordered_json volumeHeldJson(const VolumeHeld& held);
/// Where more than 1 % of the volume to be held is missing or too much; else empty.
std::string volumeHeldWarning(const VolumeHeld& held);

}  // namespace thaw
