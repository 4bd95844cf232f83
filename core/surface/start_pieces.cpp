// SPDX-License-Identifier: Apache-2.0
#include "core/surface/start_pieces.hpp"

#include <algorithm>

#include "core/domain/emit.hpp"
#include "core/halo/gather_words.hpp"
#include "core/surface/data/place_rows.hpp"
#include "core/surface/update_components.hpp"
#include "core/surface/work/surface_tools.hpp"

namespace thaw {
namespace {

// spacings
constexpr double neighbours = 1.95;

}  // namespace

std::vector<BodyPieces> findStartPieces(const SurfaceView& w, SurfaceHalos halos, SurfaceTools& t) {
  labelParticles(w, halos, t);
  Surface& s = w.surface;
  SurfaceParticles& p = s.particles;
  addGhosts(halos.particles, p, s.particleCells, ColumnList{&p.id, &p.position, &p.component, &p.body});
  const double reach = neighbours * w.scene.spacing;
  fillBins(p.position.data(), p.size(), reach, t.topology.components.particleBins);
  std::vector<std::uint64_t> labels;
  for (std::size_t i = 0; i < p.owned; i++) {
    bool apart = false;
    forRowsWithin(t.topology.components.particleBins, p.position[i], reach, [&](std::uint32_t j, double) {
      apart = apart || (p.component[j] != p.component[i] && p.body[j] == p.body[i]);
    });
    if (apart && (labels.empty() || labels.back() != p.component[i])) labels.push_back(p.component[i]);
  }
  dropGhosts(p, s.particleCells);
  std::fill_n(p.component.data(), p.owned, noComponent);
  std::sort(labels.begin(), labels.end());
  labels.erase(std::unique(labels.begin(), labels.end()), labels.end());
  labels = gatherWords(halos.all, labels);
  std::sort(labels.begin(), labels.end());
  labels.erase(std::unique(labels.begin(), labels.end()), labels.end());
  std::vector<BodyPieces> found;
  // Labels contain the id of a particle, so labels of one body are consecutive.
  for (const std::uint64_t label : labels) {
    const std::size_t body = sourceOf(label - 1);
    if (found.empty() || found.back().body != body) found.push_back({body, 0});
    found.back().pieces++;
  }
  return found;
}

}  // namespace thaw
