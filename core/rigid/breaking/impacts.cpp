// SPDX-License-Identifier: Apache-2.0
#include "core/rigid/breaking/impacts.hpp"

#include <algorithm>
#include <cmath>

#include "core/rigid/piece_sums.hpp"

namespace thaw {
namespace {

constexpr double impactFactor = 2;  // lower limit of an impact's impulses over those of known loads

/// Returns the length (m) of a rod with the mass of the piece and its largest second moment of mass.
double lengthOf(const Pieces& p, std::size_t k) {
  const Vec3d& i = p.inertia[k];
  const double most = 0.5 * (i.x + i.y + i.z) - std::min({i.x, i.y, i.z});
  return std::sqrt(12 * most / p.mass[k]);
}

/// Returns the duration (s) of an impact on a piece of a material; 0 if the material does not break.
double durationOf(const Pieces& p, std::size_t k, const Material& m) {
  return m.impactModulus > 0 ? 2 * lengthOf(p, k) / std::sqrt(m.impactModulus / m.density) : 0;
}

/// Smallest strength (Pa) of all breaking materials, and their shortest impact duration per length (s/m).
struct Weakest {
  double strength = never, perLength = never;
};

Weakest weakestOf(const Scene& scene) {
  Weakest w;
  for (const Material& m : scene.materials) {
    if (!(m.strength < never)) continue;
    w.strength = std::min(w.strength, m.strength);
    w.perLength = std::min(w.perLength, 2 / std::sqrt(m.impactModulus / m.density));
  }
  return w;
}

struct LoadWriter {
  const RigidView& v;
  std::span<const std::uint32_t> hit;
  PieceRecords records{ImpactLoads::recordWords, {}};

  void add(std::uint32_t row, std::uint64_t particle, std::uint64_t other, const Vec3d& force,
           const Vec3d& arm) {
    if (!std::binary_search(hit.begin(), hit.end(), row)) return;
    records.words.insert(records.words.end(), {v.pieces.id[row], particle, other});
    addPlace(records.words, force);
    addPlace(records.words, cross(arm, force));
  }
};

}  // namespace

std::vector<double> contactSizes(const RigidView& v, std::span<const FoundContact> contacts, Reducer& all) {
  const Pieces& p = v.pieces;
  std::vector<ExactSum>& sums = v.work.sums;
  sums.assign(p.owned, ExactSum{});
  for (const FoundContact& f : contacts) {
    const double size = length(f.contact.impulse);
    sums[f.contact.a].add(size);
    if (f.contact.b != noPiece) sums[f.contact.b].add(size);
  }
  RankPieceExchange exchange = exchangeOf(p, v.work, all);
  sumOverRanks(exchange, sums, 1, v.work.words);
  std::vector<double> sizes(p.owned);
  for (std::size_t k = 0; k < p.owned; k++) sizes[k] = sums[k].value();
  return sizes;
}

std::vector<std::uint32_t> findHit(const RigidView& v, std::span<const double> sizes, double dt) {
  const Pieces& p = v.pieces;
  const Weakest weakest = weakestOf(v.scene);
  const double spacing = v.scene.spacing, g = length(v.scene.domain.gravity);
  std::vector<std::uint32_t> hit;
  for (std::uint32_t k = 0; k < p.owned; k++) {
    const bool known = p.contactLoad[k] >= 0;
    if (!known || p.fixed[k] || p.sleeping[k] || p.count[k] < leastToBreak) continue;
    if (!(sizes[k] > impactFactor * dt * std::max(p.contactLoad[k], p.mass[k] * g))) continue;
    // The largest possible stress occurs in a bar one particle thick that the whole force bends over its
    // length.
    const double size = lengthOf(p, k), force = sizes[k] / (weakest.perLength * size),
                 most = 6 * std::max(1.0, size / spacing) * force / (spacing * spacing);
    if (most > weakest.strength) hit.push_back(k);
  }
  return hit;
}

ImpactLoads impactLoads(const RigidView& v, std::span<const FoundContact> contacts,
                        std::span<const std::uint32_t> hit, Reducer& all) {
  const Pieces& p = v.pieces;
  const Continuum& c = v.particles;
  const auto materialOf = [&](std::uint32_t i) -> const Material& {
    return v.scene.materials[c.material[i]];
  };
  LoadWriter writer{v, hit};
  for (const FoundContact& f : contacts) {
    const RigidContact& x = f.contact;
    double duration = durationOf(p, x.a, materialOf(f.particle));
    if (x.b != noPiece) duration = std::max(duration, durationOf(p, x.b, materialOf(f.other)));
    if (!(duration > 0) || x.impulse == Vec3d{}) continue;
    const Vec3d force = x.impulse / duration;
    writer.add(x.a, x.keyA, x.keyB, force, x.armA);
    if (x.b != noPiece) writer.add(x.b, x.keyB, x.keyA, -force, x.armB);
  }
  return {shareRecords(writer.records, idsOf(p, hit), all)};
}

}  // namespace thaw
