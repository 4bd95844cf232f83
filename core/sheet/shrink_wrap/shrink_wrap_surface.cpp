// SPDX-License-Identifier: Apache-2.0
#include "core/sheet/shrink_wrap/shrink_wrap_surface.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "core/halo/gather_words.hpp"
#include "core/math/hash_random.hpp"
#include "core/sheet/search/near_boxes.hpp"

namespace thaw {
namespace {

constexpr int blockBits = 3;  // a block is 8 x 8 x 8 cells

std::uint64_t blockOf(const Vec3i& cell) {  // cells begin at -1
  return cellKey({(cell.x + 8) >> blockBits, (cell.y + 8) >> blockBits, (cell.z + 8) >> blockBits});
}
int ownerOf(std::uint64_t block, int ranks) {
  return static_cast<int>(mixBits(block) % static_cast<std::uint64_t>(ranks));
}

constexpr std::size_t wordsOfPart = 5;
void addPart(std::vector<std::uint64_t>& words, const ShrinkWrapCell& p) {
  words.push_back(p.key);
  addNumber(words, p.share);
  addPlace(words, p.middle);
}
ShrinkWrapCell partAt(const std::vector<std::uint64_t>& words, std::size_t k) {
  return {words[k], numberAt(words, k + 1), placeAt(words, k + 2)};
}

const auto byKey = [](const auto& a, const auto& b) { return a.key < b.key; };

/// Returns messages with cells for the owners of their blocks. Owners of adjacent blocks get the cells with
/// share 0.
std::vector<WordStream> messagesToBlocks(const std::vector<ShrinkWrapCell>& cells, int ranks) {
  WordStreams out(ranks);
  for (const ShrinkWrapCell& p : cells) {
    const Vec3i c = cellOfKey(p.key);
    const std::uint64_t block = blockOf(c);
    addPart(out.to(ownerOf(block, ranks)), p);
    for (int a = 0; a < 3; a++)
      for (const int side : {-1, 1}) {
        Vec3i beside = c;
        beside[a] += side;
        if (const std::uint64_t other = blockOf(beside); other != block)
          addPart(out.to(ownerOf(other, ranks)), {p.key, 0, {}});
      }
  }
  return std::move(out.lists);
}

/// Returns the received cells that lie on the surface.
std::vector<ShrinkWrapSurface::Listed> surfaceOf(const std::vector<WordStream>& received) {
  std::vector<ShrinkWrapSurface::Listed> known;
  for (const WordStream& l : received)
    for (std::size_t k = 0; k < l.words.size(); k += wordsOfPart)
      known.push_back({partAt(l.words, k), l.rank});
  // a cell may arrive for several blocks; its entry with share > 0 sorts first
  std::sort(known.begin(), known.end(), [](const auto& a, const auto& b) {
    return a.part.key != b.part.key ? a.part.key < b.part.key : a.part.share > b.part.share;
  });
  known.erase(std::unique(known.begin(), known.end(),
                          [](const auto& a, const auto& b) { return a.part.key == b.part.key; }),
              known.end());
  const auto taken = [&](const Vec3i& c) {
    const auto at = std::lower_bound(known.begin(), known.end(), cellKey(c),
                                     [](const auto& p, std::uint64_t key) { return p.part.key < key; });
    return at != known.end() && at->part.key == cellKey(c);
  };
  std::vector<ShrinkWrapSurface::Listed> surface;
  for (const auto& p : known) {
    if (!(p.part.share > 0)) continue;
    const Vec3i c = cellOfKey(p.part.key);
    bool inside = true;
    for (int a = 0; a < 3 && inside; a++)
      for (const int side : {-1, 1}) {
        Vec3i beside = c;
        beside[a] += side;
        inside = inside && taken(beside);
      }
    if (!inside) surface.push_back(p);
  }
  return surface;
}

/// Bounding box (m) of a block's points.
struct Block {
  std::uint64_t key;
  Box box;
};

/// Groups places[k] into blocks by key(k).
template<class Key, class Place> std::vector<Block> blocksOf(std::size_t n, Key&& key, Place&& place) {
  std::map<std::uint64_t, Box> boxes;
  for (std::size_t k = 0; k < n; k++) {
    const Vec3d x = place(k);
    boxes.try_emplace(key(k), Box{x, x}).first->second.take(x);
  }
  std::vector<Block> blocks;
  for (const auto& [block, box] : boxes) blocks.push_back({block, box});
  return blocks;
}

std::vector<Block> gatherBlocks(Reducer& all, const std::vector<Block>& mine) {
  std::vector<std::uint64_t> words;
  for (const Block& b : mine) {
    words.push_back(b.key);
    addPlace(words, b.box.low);
    addPlace(words, b.box.high);
  }
  words = gatherWords(all, words);
  std::vector<Block> blocks;
  for (std::size_t k = 0; k < words.size(); k += 7)
    blocks.push_back({words[k], {placeAt(words, k + 1), placeAt(words, k + 4)}});
  return blocks;
}

/// Smallest and largest distance (m) between points of two boxes.
double leastApart(const Box& a, const Box& b) {
  Vec3d d;
  for (int k = 0; k < 3; k++) d[k] = std::max({0.0, a.low[k] - b.high[k], b.low[k] - a.high[k]});
  return length(d);
}
double mostApart(const Box& a, const Box& b) {
  Vec3d d;
  for (int k = 0; k < 3; k++) d[k] = std::max(a.high[k] - b.low[k], b.high[k] - a.low[k]);
  return length(d);
}

/// Returns the blocks whose surface cells may attract a vertex in one of these boxes.
std::vector<std::uint64_t> blocksNear(const std::vector<Block>& vertices, const std::vector<Block>& surface,
                                      double beyond) {
  std::vector<std::uint8_t> wanted(surface.size(), 0);
  for (const Block& v : vertices) {
    double nearest = HUGE_VAL;  // m, upper bound of the distance to the nearest cell, for vertices in the box
    for (const Block& b : surface) nearest = std::min(nearest, mostApart(v.box, b.box));
    for (std::size_t k = 0; k < surface.size(); k++)
      if (leastApart(v.box, surface[k].box) <= (nearest + beyond) * (1 + 1e-12)) wanted[k] = 1;
  }
  std::vector<std::uint64_t> keys;
  for (std::size_t k = 0; k < surface.size(); k++)
    if (wanted[k]) keys.push_back(surface[k].key);
  return keys;
}

}  // namespace

ShrinkWrapSurface findShrinkWrapSurface(Reducer& all, const CellGrid& grid,
                                        const std::vector<ShrinkWrapCell>& cells,
                                        const std::vector<Vec3d>& places, double beyond) {
  const int ranks = all.size();
  ShrinkWrapSurface s;
  s.listed = surfaceOf(all.sparseAllToAll(messagesToBlocks(cells, ranks)));
  const auto listedBlock = [&](std::size_t k) { return blockOf(cellOfKey(s.listed[k].part.key)); };
  const std::vector<Block> surface = gatherBlocks(
      all, blocksOf(s.listed.size(), listedBlock, [&](std::size_t k) { return s.listed[k].part.middle; }));
  s.any = !surface.empty();
  if (!s.any) return s;
  const std::vector<Block> vertices = blocksOf(
      places.size(), [&](std::size_t k) { return blockOf(cellOf(grid, places[k])); },
      [&](std::size_t k) { return places[k]; });
  WordStreams ask(ranks), answer(ranks);
  for (const std::uint64_t block : blocksNear(vertices, surface, beyond))
    ask.to(ownerOf(block, ranks)).push_back(block);
  std::map<std::uint64_t, std::vector<std::size_t>> inBlock;
  for (std::size_t k = 0; k < s.listed.size(); k++) inBlock[listedBlock(k)].push_back(k);
  for (const WordStream& l : all.sparseAllToAll(std::move(ask.lists)))
    for (const std::uint64_t block : l.words)
      for (const std::size_t k : inBlock[block]) addPart(answer.to(l.rank), s.listed[k].part);
  for (const WordStream& l : all.sparseAllToAll(std::move(answer.lists)))
    for (std::size_t k = 0; k < l.words.size(); k += wordsOfPart) s.near.push_back(partAt(l.words, k));
  std::sort(s.near.begin(), s.near.end(), byKey);
  return s;
}

std::vector<ShrinkWrapForce> reduceShrinkWrapForces(Reducer& all, const ShrinkWrapSurface& s,
                                                    const std::vector<std::int64_t>& units) {
  const int ranks = all.size();
  WordStreams back(ranks), home(ranks);
  for (std::size_t k = 0; k < s.near.size(); k++) {
    const std::int64_t* u = units.data() + 3 * k;
    if (u[0] == 0 && u[1] == 0 && u[2] == 0) continue;
    std::vector<std::uint64_t>& words = back.to(ownerOf(blockOf(cellOfKey(s.near[k].key)), ranks));
    words.push_back(s.near[k].key);
    for (int a = 0; a < 3; a++) words.push_back(std::bit_cast<std::uint64_t>(u[a]));
  }
  const auto pullAt = [](const std::vector<std::uint64_t>& words, std::size_t k) {
    ShrinkWrapForce p{words[k], {}};
    for (int a = 0; a < 3; a++)
      p.units[a] = std::bit_cast<std::int64_t>(words[k + 1 + static_cast<std::size_t>(a)]);
    return p;
  };
  std::vector<Vec3<std::int64_t>> sums(s.listed.size());
  for (const WordStream& l : all.sparseAllToAll(std::move(back.lists)))
    for (std::size_t k = 0; k < l.words.size(); k += 4) {
      const ShrinkWrapForce p = pullAt(l.words, k);
      const auto at = std::lower_bound(s.listed.begin(), s.listed.end(), p.key,
                                       [](const auto& x, std::uint64_t key) { return x.part.key < key; });
      sums[static_cast<std::size_t>(at - s.listed.begin())] += p.units;
    }
  for (std::size_t k = 0; k < s.listed.size(); k++) {
    std::vector<std::uint64_t>& words = home.to(s.listed[k].home);
    words.push_back(s.listed[k].part.key);
    for (int a = 0; a < 3; a++) words.push_back(std::bit_cast<std::uint64_t>(sums[k][a]));
  }
  std::vector<ShrinkWrapForce> pulls;
  for (const WordStream& l : all.sparseAllToAll(std::move(home.lists)))
    for (std::size_t k = 0; k < l.words.size(); k += 4) pulls.push_back(pullAt(l.words, k));
  std::sort(pulls.begin(), pulls.end(), byKey);
  return pulls;
}

}  // namespace thaw
