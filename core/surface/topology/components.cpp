// SPDX-License-Identifier: Apache-2.0
#include "core/surface/topology/components.hpp"

#include <algorithm>

#include "core/halo/gather_words.hpp"
#include "core/surface/data/place_rows.hpp"
#include "core/surface/data/remove_surfels.hpp"

namespace thaw {
namespace {

using Piece = ComponentTools::Piece;

void sortUnique(std::vector<Piece>& pieces) {
  std::sort(pieces.begin(), pieces.end());
  pieces.erase(std::unique(pieces.begin(), pieces.end()), pieces.end());
}

/// Returns the pairs (previous component, part) of all particles on all ranks, ascending and unique.
std::vector<Piece> piecesOf(const SurfaceParticles& p, Reducer& all) {
  std::vector<Piece> mine;
  for (std::size_t i = 0; i < p.owned; i++) {
    const Piece piece{p.component[i], p.part[i]};
    if (mine.empty() || mine.back() != piece) mine.push_back(piece);
  }
  sortUnique(mine);
  std::vector<std::uint64_t> words;
  for (const Piece& m : mine) words.insert(words.end(), {m.from, m.part});
  words = gatherWords(all, words);
  std::vector<Piece> pieces;
  for (std::size_t k = 0; k + 1 < words.size(); k += 2) pieces.push_back({words[k], words[k + 1]});
  sortUnique(pieces);
  return pieces;
}

}  // namespace

namespace {

/// Marks surfels next to a separated part for resampling.
void markSeams(Surface& s, CellHalo& halo, const std::vector<std::uint64_t>& off, const Bins& bins) {
  Surfels& f = s.surfels;
  refreshGhosts(halo, f, ColumnList{&f.part});
  for (std::size_t i = 0; i < f.size(); i++) {
    if (!std::binary_search(off.begin(), off.end(), f.part[i])) continue;
    forRowsWithin(bins, f.position[i], 2 * s.spacing, [&](std::uint32_t j, double) {
      if (f.part[j] == f.part[i]) return;
      if (j < f.owned) f.resampleMargin[j] = 0;
      if (i < f.owned) f.resampleMargin[i] = 0;
    });
  }
}

}  // namespace

void splitComponents(const Clock& clock, Surface& s, SurfaceHalos halos, ComponentTools& t) {
  Surfels& f = s.surfels;
  SurfaceParticles& p = s.particles;
  const std::vector<Piece>& pieces = t.pieces = piecesOf(p, halos.all);
  std::vector<std::uint64_t> off;
  const auto log = [&](SurfaceEventKind kind, std::uint64_t label, std::uint64_t other) {
    s.events.push_back({clock.step, clock.time, kind, label, other});
  };
  for (std::size_t k = 0, first = 0; k < pieces.size(); k++) {
    if (pieces[k].from != pieces[first].from) first = k;
    if (pieces[k].from == noComponent || s.lastStep < 0)
      // New particles, and pieces of a body at the start, were never connected.
      continue;
    if (k == first) {
      if (pieces[k].part != pieces[k].from) log(SurfaceEventKind::Renamed, pieces[k].part, pieces[k].from);
      continue;
    }
    s.counters.splits++;
    log(SurfaceEventKind::Split, pieces[first].part, pieces[k].part);
    off.push_back(pieces[k].part);
  }
  if (!off.empty()) {
    std::sort(off.begin(), off.end());
    markSeams(s, halos.surfels, off, t.surfelBins);
  }
  for (std::size_t i = 0; i < p.owned; i++) p.component[i] = p.part[i];
  t.dead.assign(f.owned, 0);
  for (std::size_t i = 0; i < f.owned; i++) {
    if (f.part[i] >> 63) t.dead[i] = 1;
    else f.component[i] = f.part[i];
  }
  std::int64_t lost[1] = {removeSurfels(s, t.dead)};
  halos.all.sum(lost);
  s.counters.lost += lost[0];
}

}  // namespace thaw
