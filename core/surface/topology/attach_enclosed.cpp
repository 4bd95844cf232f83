// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "core/halo/gather_words.hpp"
#include "core/surface/search/inside.hpp"
#include "core/surface/topology/components.hpp"

namespace thaw {
namespace {

using Pair = std::pair<std::uint64_t, std::uint64_t>;

template<class T> void sortUnique(std::vector<T>& v) {
  std::sort(v.begin(), v.end());
  v.erase(std::unique(v.begin(), v.end()), v.end());
}

/// Returns the labels of parts with surfels on all ranks, ascending.
std::vector<std::uint64_t> partsWithSurfels(const Surfels& f, Reducer& all) {
  std::vector<std::uint64_t> parts;
  for (std::size_t i = 0; i < f.owned; i++)
    if (parts.empty() || parts.back() != f.part[i]) parts.push_back(f.part[i]);
  sortUnique(parts);
  parts = gatherWords(all, parts);
  sortUnique(parts);
  return parts;
}

/// Returns the value of a key in a sorted list, or the key itself if it is absent.
std::uint64_t lookUp(const std::vector<Pair>& list, std::uint64_t key) {
  const auto at = std::lower_bound(list.begin(), list.end(), Pair{key, 0});
  return at != list.end() && at->first == key ? at->second : key;
}

}  // namespace

void attachEnclosed(Surface& s, SurfaceHalos halos, ComponentTools& t) {
  Surfels& f = s.surfels;
  SurfaceParticles& p = s.particles;
  const std::vector<std::uint64_t> covered = partsWithSurfels(f, halos.all);
  // (part without surfels, enclosing part)
  std::vector<Pair> into;
  InsideTools inside;
  std::vector<SurfaceSide> sides;
  for (std::size_t i = 0; i < p.owned; i++) {
    if (p.component[i] == noComponent || std::binary_search(covered.begin(), covered.end(), p.part[i]))
      continue;
    findSides(f, t.surfelBins, {p.position[i], p.component[i], false, s.particleSupport}, inside, sides);
    if (sides.empty() || sides[0].distance >= 0 || sides[0].discsUsed < leastDiscs) continue;
    const std::uint64_t part = f.part[sides[0].nearest];
    // Otherwise, the surfels have no particles and will be deleted.
    if (part >> 63 == 0) into.push_back({p.part[i], part});
  }
  sortUnique(into);
  std::vector<std::uint64_t> words;
  for (const Pair& m : into) words.insert(words.end(), {m.first, m.second});
  words = gatherWords(halos.all, words);
  if (words.empty()) return;
  into.clear();
  for (std::size_t k = 0; k + 1 < words.size(); k += 2) into.push_back({words[k], words[k + 1]});
  sortUnique(into);
  into.erase(
      std::unique(into.begin(), into.end(), [](const Pair& a, const Pair& b) { return a.first == b.first; }),
      into.end());
  // (part with surfels, its label with all enclosed parts)
  std::vector<Pair> named;
  for (const Pair& m : into) named.push_back({m.second, std::min(m.first, m.second)});
  // smallest label of each part first
  std::sort(named.begin(), named.end());
  for (Pair& m : into) m.second = lookUp(named, m.second);
  for (std::size_t i = 0; i < p.owned; i++) p.part[i] = lookUp(named, lookUp(into, p.part[i]));
  for (std::size_t i = 0; i < f.owned; i++) f.part[i] = lookUp(named, f.part[i]);
}

}  // namespace thaw
