#include "core/surface/keep_volume.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include "core/surface/measure.hpp"
#include "core/surface/sample_mesh.hpp"

namespace thaw {

namespace {

/// Not the smallest ones, nor solids, nor those with a hole: a seam since a merge. A puddle of a few particles' height has .025 by its rim alone, drops of five to
/// nine particles, whose areas are coarse, up to .09.
bool kept(const SurfaceComponent& c) {
  constexpr std::int64_t fewest = 12;
  constexpr double leastFree = 0.05, closed = 0.04;
  return c.surfels >= fewest && c.wantedVolume > 0 && c.freeArea > leastFree * c.area && c.open < std::max(closed, 1.5 / std::sqrt(static_cast<double>(c.surfels)));
}

}  // namespace

void keepStartVolumes(World& w, SurfaceHalos halos) {
  SurfaceParticles& p = w.surface.particles;
  Continuum& home = w.particles;
  if (!home.surfaceShare.active) return;
  std::vector<std::uint64_t> shares(p.owned), here(home.owned, std::bit_cast<std::uint64_t>(1.0));
  for (std::size_t i = 0; i < p.owned; i++) {
    const SurfaceComponent* c = hasMesh(w.scene, p.body[i]) ? findComponent(w.surface, p.component[i]) : nullptr;
    shares[i] = std::bit_cast<std::uint64_t>(c && c->volume > 0 ? c->volume / c->particleVolume : 1.0);
  }
  halos.courier.sendHome({p.home.data(), p.owned}, shares, here);
  for (std::size_t i = 0; i < home.owned; i++) home.surfaceShare[i] = std::bit_cast<double>(here[i]);
}

double volumeError(const Surface& s) {
  double error = 0;
  for (const SurfaceComponent& c : s.components)
    if (kept(c)) error = std::max(error, std::abs(c.volume - c.wantedVolume) / c.wantedVolume);
  return error;
}

void offsetToVolume(Surface& s, double keepVolume, double particleSpacing) {
  Surfels& f = s.surfels;
  if (!f.liquid.active) return;
  const double longest = 0.5 * s.spacing, highest = mostRaised * particleSpacing;
  std::vector<double> moves(s.components.size());  // the same on all ranks
  for (std::size_t k = 0; k < s.components.size(); k++) {
    SurfaceComponent& c = s.components[k];
    if (!kept(c)) continue;
    const double to = c.raised + std::clamp(keepVolume * (c.wantedVolume - c.volume) / c.freeArea, -longest, longest);
    moves[k] = std::clamp(to, -highest, highest) - c.raised;
    c.raised += moves[k];
  }
  const SurfaceComponent* c = nullptr;
  for (std::size_t i = 0; i < f.owned; i++) {
    if (!c || c->label != f.component[i]) c = findComponent(s, f.component[i]);
    if (!c) continue;
    const double move = static_cast<double>(f.liquid[i]) * moves[static_cast<std::size_t>(c - s.components.data())];
    if (move == 0) continue;
    f.position[i] += move * f.normal[i];
    f.calm[i] = std::max(0.0f, f.calm[i] - static_cast<float>(std::abs(move) / f.radius[i]));
  }
}

void listRaised(const World& w, std::vector<RaisedComponent>& raised) {
  raised.clear();
  if (!(w.scene.surface.keepVolume > 0)) return;
  for (const SurfaceComponent& c : w.surface.components)
    if (c.raised != 0) raised.push_back({c.label, c.raised});
}

}  // namespace thaw
