// SPDX-License-Identifier: Apache-2.0
#include "io/run/reports/volume_errors.hpp"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

namespace thaw {
namespace {

constexpr double mostOff = 0.01, mostSmallOff = 0.1, mostMissed = 0.01;

void note(VolumeError& worst, const SurfaceComponent& c, double volume, double time) {
  if (!(volume > 0)) return;
  const double off = c.volume / volume - 1;
  if (worst.label == noComponent || std::abs(off) > std::abs(worst.off))
    worst = {off, c.label, c.particles, time};
}

/// Returns the target volume. Logs of earlier versions lack it.
double targetOf(const SurfaceComponent& c) { return c.targetVolume > 0 ? c.targetVolume : c.particleVolume; }

bool there(const VolumeError& w) { return w.label != noComponent; }
std::string placeOf(const VolumeError& w) {
  return fmt::format("component {} of {} particles, t {:.5g} s", w.label, w.particles, w.time);
}
std::string worstOf(const VolumeError& w) { return fmt::format("{:+.2f} % ({})", 100 * w.off, placeOf(w)); }
double shareOf(const VolumeErrors& h) {
  return h.particles > 0 ? static_cast<double>(h.missed) / static_cast<double>(h.particles) : 0;
}

nlohmann::ordered_json jsonOf(const VolumeError& w) {
  return {{"off", w.off}, {"component", w.label}, {"particles", w.particles}, {"time_s", w.time}};
}

}  // namespace

void recordVolumes(VolumeErrors& errors, const std::vector<SurfaceComponent>& components, double time) {
  if (components.empty()) return;
  VolumeSums frame;
  frame.time = time;
  for (const SurfaceComponent& c : components) {
    const double target = targetOf(c);
    frame.volume += c.volume;
    frame.target += target;
    frame.particles += c.particles;
    if (target > 0 && std::abs(c.volume / target - 1) > mostOff) frame.missed += c.particles;
    if (c.particles < leastSmallParticles) continue;
    if (c.particles < leastComponentParticles) {
      note(errors.small, c, target, time);
    } else if (c.surfels >= leastControlledSurfels) {
      note(errors.againstParticles, c, c.particleVolume, time);
      note(errors.againstTarget, c, c.targetVolume, time);
      if (c.open > closedTolerance) errors.unsure += c.particles;
      if (c.open > errors.open.off) errors.open = {c.open, c.label, c.particles, time};
    }
  }
  if (!errors.any || std::abs(frame.off()) > std::abs(errors.sum.off())) errors.sum = frame;
  if (!errors.any || frame.missedShare() > errors.missing.missedShare()) errors.missing = frame;
  errors.particles += frame.particles;
  errors.missed += frame.missed;
  errors.any = true;
}

std::vector<std::string> volumeErrorLines(const VolumeErrors& h) {
  if (!h.any) return {};
  std::vector<std::string> lines{fmt::format(
      "  volume over all frames: the sum at most {:+.2f} % off the target (t {:.5g} s); {:.3g} % of the "
      "particles are in components more than 1 % off ({:.3g} % in the worst frame, t {:.5g} s)",
      100 * h.sum.off(), h.sum.time, 100 * shareOf(h), 100 * h.missing.missedShare(), h.missing.time)};
  if (there(h.againstParticles)) {
    lines.push_back(
        fmt::format("    components of {} particles and more: at most {} off the volume of the particles",
                    leastComponentParticles, worstOf(h.againstParticles)));
    if (there(h.againstTarget) && h.againstTarget.off != h.againstParticles.off)
      lines.back() += fmt::format(", {} off the target, which follows the meshes at the start",
                                  worstOf(h.againstTarget));
  }
  if (h.unsure > 0)
    lines.push_back(fmt::format(
        "    {:.3g} % of the particles are in components of {} and more whose surface is open by more than 1 "
        "% of its area (at most {:.3g} %: {}): the reported volume is uncertain by more than 1 %",
        100 * static_cast<double>(h.unsure) / static_cast<double>(h.particles), leastComponentParticles,
        100 * h.open.off, placeOf(h.open)));
  if (there(h.small))
    lines.push_back(fmt::format("    components of {} to {} particles: at most {}", leastSmallParticles,
                                leastComponentParticles - 1, worstOf(h.small)));
  return lines;
}

nlohmann::ordered_json volumeErrorJson(const VolumeErrors& h) {
  nlohmann::ordered_json j = {{"least_particles", leastComponentParticles}};
  if (!h.any) return j;
  if (there(h.againstParticles)) j["worst_against_particles"] = jsonOf(h.againstParticles);
  if (there(h.againstTarget)) j["worst_against_target"] = jsonOf(h.againstTarget);
  if (there(h.small)) j["worst_of_small"] = jsonOf(h.small);
  if (there(h.open))
    j["worst_open"] = {{"share_of_area", h.open.off},
                       {"component", h.open.label},
                       {"particles", h.open.particles},
                       {"time_s", h.open.time}};
  j["share_of_particles_unsure"] = h.particles > 0
                                       ? static_cast<double>(h.unsure) / static_cast<double>(h.particles)
                                       : 0;
  j["worst_sum"] = {{"off", h.sum.off()}, {"time_s", h.sum.time}};
  j["share_of_particles_off"] = shareOf(h);
  j["worst_share_of_particles_off"] = {{"share", h.missing.missedShare()}, {"time_s", h.missing.time}};
  return j;
}

std::string volumeErrorWarning(const VolumeErrors& h) {
  const bool component = std::abs(h.againstTarget.off) > mostOff, sum = std::abs(h.sum.off()) > mostOff,
             small = std::abs(h.small.off) > mostSmallOff, share = shareOf(h) > mostMissed;
  if (!component && !sum && !small && !share) return {};
  const VolumeError& worst = component || !there(h.small) ? h.againstTarget : h.small;
  std::string line = fmt::format(
      "surface.enforce_volume: {:.3g} % of the particles are in components more than 1 % off their target "
      "volume. The sum is at most {:+.3g} % off",
      100 * shareOf(h), 100 * h.sum.off());
  if (there(worst))
    line += fmt::format(". One component was {:+.1f} % off ({})", 100 * worst.off, placeOf(worst));
  return line + ". See docs/reference/surfaces.md";
}

}  // namespace thaw
