// SPDX-License-Identifier: Apache-2.0
#include "core/rigid/contact/reduce_contacts.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <tuple>

namespace thaw {
namespace {

constexpr std::size_t outward = 8, criteria = outward + 1;
constexpr double gapWeight = 10;     // ratio of distance along the surface to an open gap of equal weight
constexpr double evenDepth = 0.02;   // spacings; smaller differences in depth do not count, so the same
                                     // contacts remain from step to step
constexpr double closedGap = 0.002;  // spacings; contacts with larger gaps do not support a load yet
constexpr double firstAngle = 0.3;   // rad; no direction is normal to the edges of boxes along the axes

/// Contact as seen from the piece with the smaller id, which defines the patch.
struct Side {
  std::uint64_t piece, partner;
  Vec3d normal, arm;
};

Side sideOf(const FoundContact& f) {
  const RigidContact& c = f.contact;
  if (f.pieceA < f.partner) return {f.pieceA, f.partner, c.normal, c.armA};
  return {f.partner, f.pieceA, -c.normal, c.armB};
}

struct Patch {
  std::uint64_t piece, partner;
  std::uint32_t direction;  ///< twice the bin of normals, plus 1 for open gaps
  auto operator<=>(const Patch&) const = default;
};

Patch patchOf(const FoundContact& c, double spacing) {
  const Side s = sideOf(c);
  const bool open = c.contact.gap > closedGap * spacing;
  return {s.piece, s.partner, 2 * directionBin(s.normal) + (open ? 1 : 0)};
}

/// Score of a contact by one criterion. The outermost contact has the largest score. The keys break ties.
struct Rank {
  double score;
  std::uint64_t keyA, keyB;
  bool operator>(const Rank& o) const {
    return std::tuple(score, o.keyA, o.keyB) > std::tuple(o.score, keyA, keyB);
  }
};

/// Directions along the surface, the same for all normals of a bin.
std::array<Vec3d, outward> directionsOf(const Vec3d& normal) {
  int side = 0;
  for (int a = 1; a < 3; a++)
    if (std::abs(normal[a]) > std::abs(normal[side])) side = a;
  Vec3d e, f;
  e[(side + 1) % 3] = 1;
  f[(side + 2) % 3] = 1;
  std::array<Vec3d, outward> d;
  for (std::size_t k = 0; k < outward; k++) {
    const double angle = firstAngle + static_cast<double>(k) * (2 * std::numbers::pi / outward);
    d[k] = std::cos(angle) * e + std::sin(angle) * f;
  }
  return d;
}

std::array<Rank, criteria> ranksOf(const FoundContact& f, double depthStep) {
  const RigidContact& c = f.contact;
  std::array<Rank, criteria> r;
  const Side side = sideOf(f);
  const auto directions = directionsOf(side.normal);
  for (std::size_t k = 0; k < outward; k++)
    r[k] = {dot(side.arm, directions[k]) - gapWeight * std::max(0.0, c.gap), c.keyA, c.keyB};
  r[outward] = {-std::floor(c.gap / depthStep), c.keyA, c.keyB};
  return r;
}

using Winners = std::map<Patch, std::array<std::size_t, criteria>>;

Winners winnersOf(const std::vector<FoundContact>& contacts,
                  const std::vector<std::array<Rank, criteria>>& ranks, double spacing) {
  Winners best;
  for (std::size_t i = 0; i < contacts.size(); i++) {
    std::array<std::size_t, criteria> first;
    first.fill(i);
    const auto [at, made] = best.try_emplace(patchOf(contacts[i], spacing), first);
    for (std::size_t k = 0; !made && k < criteria; k++)
      if (ranks[i][k] > ranks[at->second[k]][k]) at->second[k] = i;
  }
  return best;
}

constexpr std::size_t entryWords = 7;  // piece, partner, direction and criterion, score, keyA, keyB, index

/// Compares the best contacts of all ranks on home ranks. Returns the indices of the best ones.
std::vector<std::size_t> compareOverRanks(const std::vector<std::vector<std::uint64_t>>& entries,
                                          Reducer& all) {
  WordStreams out(all.size());
  for (const auto& e : entries) {
    const std::uint64_t hash = (e[0] * 0x9e3779b97f4a7c15u ^ e[1]) * 0xbf58476d1ce4e5b9u;
    auto& words = out.to(static_cast<int>((hash >> 32) % static_cast<std::uint64_t>(all.size())));
    words.insert(words.end(), e.begin(), e.end());
  }
  const std::vector<WordStream> in = all.sparseAllToAll(std::move(out.lists));
  std::map<std::tuple<std::uint64_t, std::uint64_t, std::uint64_t>, std::tuple<Rank, int, std::uint64_t>>
      best;
  for (const WordStream& list : in)
    for (std::size_t k = 0; k < list.words.size(); k += entryWords) {
      const std::uint64_t* const w = &list.words[k];
      const Rank rank{numberAt(list.words, k + 3), w[4], w[5]};
      const auto [at, made] = best.try_emplace({w[0], w[1], w[2]}, rank, list.rank, w[6]);
      if (!made && rank > std::get<0>(at->second)) at->second = {rank, list.rank, w[6]};
    }
  WordStreams back(all.size());
  for (const auto& [key, winner] : best) back.to(std::get<1>(winner)).push_back(std::get<2>(winner));
  std::vector<std::size_t> kept;
  for (const WordStream& list : all.sparseAllToAll(std::move(back.lists)))
    kept.insert(kept.end(), list.words.begin(), list.words.end());
  return kept;
}

}  // namespace

std::uint32_t directionBin(const Vec3d& n) {
  int side = 0;
  for (int a = 1; a < 3; a++)
    if (std::abs(n[a]) > std::abs(n[side])) side = a;
  const auto third = [&](double x) { return x < -1.0 / 3 ? 0u : x > 1.0 / 3 ? 2u : 1u; };
  const double size = std::abs(n[side]);
  const std::uint32_t face = static_cast<std::uint32_t>(2 * side) + (n[side] < 0 ? 1u : 0u);
  return 9 * face + 3 * third(n[(side + 1) % 3] / size) + third(n[(side + 2) % 3] / size);
}

void reduceContacts(std::vector<FoundContact>& contacts, const Pieces& pieces, double spacing, Reducer& all) {
  const double depthStep = evenDepth * spacing;
  std::vector<std::array<Rank, criteria>> ranks;
  ranks.reserve(contacts.size());
  for (const FoundContact& c : contacts) ranks.push_back(ranksOf(c, depthStep));
  std::vector<std::uint8_t> keep(contacts.size(), 0);
  std::vector<std::vector<std::uint64_t>> entries;
  for (const auto& [patch, winners] : winnersOf(contacts, ranks, spacing))
    for (std::size_t k = 0; k < criteria; k++) {
      const std::size_t i = winners[k];
      const RigidContact& c = contacts[i].contact;
      if (!pieces.shared[c.a] && (c.b == noPiece || !pieces.shared[c.b])) {
        keep[i] = 1;
        continue;
      }
      std::vector<std::uint64_t> e{patch.piece, patch.partner, patch.direction * criteria + k};
      addNumber(e, ranks[i][k].score);
      e.insert(e.end(), {ranks[i][k].keyA, ranks[i][k].keyB, i});
      entries.push_back(std::move(e));
    }
  if (all.size() > 1)
    for (const std::size_t i : compareOverRanks(entries, all)) keep[i] = 1;
  else
    for (const auto& e : entries) keep[e[6]] = 1;
  std::size_t n = 0;
  for (std::size_t i = 0; i < contacts.size(); i++)
    if (keep[i]) contacts[n++] = contacts[i];
  contacts.resize(n);
}

}  // namespace thaw
