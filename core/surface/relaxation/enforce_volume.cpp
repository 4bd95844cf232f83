// SPDX-License-Identifier: Apache-2.0
#include "core/surface/relaxation/enforce_volume.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include "core/surface/data/sampled_bodies.hpp"
#include "core/surface/measures/film_limit.hpp"
#include "core/surface/measures/measure.hpp"
#include "core/surface/measures/small_drops.hpp"

namespace thaw {

namespace {

/// Part of a component that volume enforcement may move.
enum class MovablePart { Nothing, Liquid, Frozen, Drop };
struct MovableArea {
  // m^2; 0: not moved
  double area = 0;
  MovablePart what = MovablePart::Nothing;
  // tolerated relative error of the volume
  double tolerance = 0;
};

/// Returns the movable part of a component. Small drops away from walls are excluded, because they are
/// spheres of the correct volume. Surfaces with a large hole are excluded, as are solids that never moved as
/// liquids. In bodies with remaining mesh detail, only crack faces would move. At the start, grown solids are
/// included, because their colour level is too far out around plates of two layers.
MovableArea movableAreaOf(const SurfaceComponent& c, bool start) {
  constexpr std::int64_t fewest = 12;
  constexpr double leastFree = 0.03, leastFrozen = 0.9, closed = 0.25;
  if (c.surfels < fewest || !(c.targetVolume > 0) || !(c.open < closed)) return {};
  // Surface on a wall cannot move. If nearly all surface lies on walls, the small free part cannot
  // compensate.
  const auto area = [&](double all) { return std::max(all - c.wallArea, 0.2 * all); };
  if (c.particles <= smallDrop)
    return c.wallArea > 0 ? MovableArea{area(c.area), MovablePart::Drop, 5e-3} : MovableArea{};
  if (c.liquidArea > leastFree * c.area) return {area(c.liquidArea), MovablePart::Liquid, 1e-3};
  if ((start || c.isoOffset != 0) && c.frozenArea > leastFrozen * c.area)
    return {area(c.frozenArea), MovablePart::Frozen, 5e-3};
  return {};
}

double errorOf(const SurfaceComponent& c) { return std::abs(c.volume - c.targetVolume) / c.targetVolume; }

/// Returns the fraction of its component's offset by which surfel i moves.
double shareOf(const Surfels& f, std::size_t i, MovablePart what) {
  return what == MovablePart::Drop     ? 1
         : what == MovablePart::Frozen ? frozenShare(f, i)
         : what == MovablePart::Liquid ? liquidShare(f, i)
                                       : 0;
}

/// Returns the change of volume per offset (m^2): from the last offset of this update, else the free area.
/// For a drop on a wall, it is up to twice the free area, since the surface bends.
double areaMoved(double free, double volume, const VolumeMove& last) {
  constexpr double least = 0.25, most = 4;
  return last.by != 0 ? std::clamp((volume - last.volume) / last.by, least * free, most * free) : free;
}

}  // namespace

void recordStartVolumes(const Scene& scene, Continuum& source, Surface& surface, SurfaceHalos halos) {
  SurfaceParticles& p = surface.particles;
  if (!source.surfaceVolumeRatio.active) return;
  std::vector<std::uint64_t> shares(p.owned), here(source.owned, std::bit_cast<std::uint64_t>(1.0));
  for (std::size_t i = 0; i < p.owned; i++) {
    const SurfaceComponent* c = isSampled(scene, p.body[i]) ? findComponent(surface, p.component[i])
                                                            : nullptr;
    p.volumeRatio[i] = c && c->volume > 0 ? c->volume / c->particleVolume : 1.0;
    shares[i] = std::bit_cast<std::uint64_t>(p.volumeRatio[i]);
  }
  halos.scatter.scatterBack({p.source.data(), p.owned}, shares, here);
  for (std::size_t i = 0; i < source.owned; i++)
    source.surfaceVolumeRatio[i] = std::bit_cast<double>(here[i]);
}

bool volumesDeviate(const Surface& s, bool start) {
  return std::any_of(s.components.begin(), s.components.end(), [&](const SurfaceComponent& c) {
    const MovableArea hold = movableAreaOf(c, start);
    return hold.area > 0 && errorOf(c) > hold.tolerance;
  });
}

void offsetToVolume(Surface& s, const Bins& surfelBins, double weight, double particleSpacing, bool start,
                    std::vector<VolumeMove>& last) {
  Surfels& f = s.surfels;
  if (!f.liquid.active && !start) return;
  const double longest = 0.5 * s.spacing, highest = mostOutwardOffset * particleSpacing,
               lowest = -mostInwardOffset * particleSpacing;
  struct Move {
    double by = 0;
    MovablePart what = MovablePart::Nothing;
  };
  std::vector<Move> moves(s.components.size());  // same on all ranks
  last.resize(moves.size());
  for (std::size_t k = 0; k < s.components.size(); k++) {
    SurfaceComponent& c = s.components[k];
    const MovableArea hold = movableAreaOf(c, start);
    if (!(hold.area > 0) || errorOf(c) <= hold.tolerance) continue;
    const double by = std::clamp(
        weight * (c.targetVolume - c.volume) / areaMoved(hold.area, c.volume, last[k]), -longest, longest);
    last[k] = {c.volume, by};
    // This includes offsets that the level of the iterations cannot follow. The iterations undo such offsets,
    // and the next update repeats them.
    moves[k] = {by, hold.what};
    // The drop's sphere is rebuilt in each update.
    if (hold.what == MovablePart::Drop) continue;
    // Initial solids keep their position afterwards.
    if (start && hold.what == MovablePart::Frozen) continue;
    c.isoOffset = std::clamp(c.isoOffset + by, std::min(lowest, c.isoOffset), std::max(highest, c.isoOffset));
  }
  const SurfaceComponent* c = nullptr;
  // All offsets are computed before any surfel moves.
  std::vector<double> offset(f.owned, 0.0);
  // Smaller offsets do not affect films.
  const double small = 0.05 * s.spacing;
  for (std::size_t i = 0; i < f.owned; i++) {
    if (!c || c->label != f.component[i]) c = findComponent(s, f.component[i]);
    if (!c) continue;
    const Move& m = moves[static_cast<std::size_t>(c - s.components.data())];
    double move = shareOf(f, i, m.what) * m.by;
    if (move == 0 || liesOnWall(f, i)) continue;
    if (move < -small)
      move = std::max(move, -std::max(0.0, filmOffsetLimit(f, surfelBins, i, s.spacing, 0.25 * s.spacing)));
    offset[i] = move;
  }
  for (std::size_t i = 0; i < f.owned; i++) {
    const double move = offset[i];
    if (move == 0) continue;
    f.position[i] += move * f.normal[i];
    f.resampleMargin[i] = std::max(0.0f,
                                   f.resampleMargin[i] - static_cast<float>(std::abs(move) / f.radius[i]));
  }
}

void listIsoOffsets(const Scene& scene, const Surface& surface, std::vector<ComponentIsoOffset>& isoOffset) {
  isoOffset.clear();
  if (!(scene.surface.enforceVolume > 0)) return;
  for (const SurfaceComponent& c : surface.components)
    if (c.isoOffset != 0) isoOffset.push_back({c.label, c.isoOffset});
}

}  // namespace thaw
