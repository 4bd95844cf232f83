#include "io/run/volume_held.hpp"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

namespace thaw {
namespace {

constexpr double mostOff = 0.01;

void note(VolumeOff& worst, const SurfaceComponent& c, double volume, double time) {
  if (!(volume > 0)) return;
  const double off = c.volume / volume - 1;
  if (worst.label == noComponent || std::abs(off) > std::abs(worst.off)) worst = {off, c.label, c.particles, time};
}

std::string placeOf(const VolumeOff& w) { return fmt::format("component {} of {} particles, t {:.5g} s", w.label, w.particles, w.time); }

nlohmann::ordered_json jsonOf(const VolumeOff& w) { return {{"off", w.off}, {"component", w.label}, {"particles", w.particles}, {"time_s", w.time}}; }

}  // namespace

void noteVolume(VolumeHeld& held, const SurfaceComponent& c, double time) {
  if (c.particles < leastHeldParticles || c.surfels < leastHeldSurfels) return;
  held.any = true;
  note(held.ofParticles, c, c.particleVolume, time);
  note(held.ofWanted, c, c.wantedVolume, time);
}

std::string volumeHeldLine(const VolumeHeld& h) {
  if (!h.any) return {};
  std::string line = fmt::format("  volume, at all frames, of components of {} particles and more: at worst {:+.2f} % off that of the particles ({})", leastHeldParticles, 100 * h.ofParticles.off, placeOf(h.ofParticles));
  if (h.ofWanted.label != noComponent && h.ofWanted.off != h.ofParticles.off)
    line += fmt::format(", {:+.2f} % off what is to be held, which is what meshes held at the start ({})", 100 * h.ofWanted.off, placeOf(h.ofWanted));
  return line;
}

nlohmann::ordered_json volumeHeldJson(const VolumeHeld& h) {
  nlohmann::ordered_json j = {{"least_particles", leastHeldParticles}};
  if (!h.any) return j;
  j["worst_against_particles"] = jsonOf(h.ofParticles);
  if (h.ofWanted.label != noComponent) j["worst_against_wanted"] = jsonOf(h.ofWanted);
  return j;
}

std::string volumeHeldWarning(const VolumeHeld& h) {
  if (h.ofWanted.label == noComponent || std::abs(h.ofWanted.off) <= mostOff) return {};
  return fmt::format("surface.keep_volume: a surface was {:+.1f} % off the volume that it is to hold ({}); docs/pictures.md says what is held how well", 100 * h.ofWanted.off, placeOf(h.ofWanted));
}

}  // namespace thaw
