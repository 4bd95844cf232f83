// SPDX-License-Identifier: Apache-2.0
#include "core/surface/resampling/birth_colours.hpp"

#include <algorithm>
#include <limits>

#include "core/surface/data/mean_colour.hpp"
#include "core/surface/data/place_rows.hpp"
#include "core/surface/data/sampled_bodies.hpp"
#include "core/surface/work/surface_tools.hpp"

namespace thaw {
namespace {

struct Nearest {
  double d2 = std::numeric_limits<double>::infinity();
  std::uint64_t id = 0;
  std::uint32_t colour = 0;
  void update(double r2, std::uint64_t i, std::uint32_t c) {
    if (r2 < d2 || (r2 == d2 && i < id)) *this = {r2, i, c};
  }
  bool found() const { return d2 < std::numeric_limits<double>::infinity(); }
};

bool inherits(const SurfelRow& r) { return r.particle != SurfelRow::none; }
bool ofMesh(const Scene& scene, const Surface& surface, const SurfelRow& r) {
  return hasMesh(scene, surface.particles.body[r.particle]);
}

/// Smallest and largest colour among surfels and inheriting rows. If the two are equal, all births get that
/// colour.
struct ColourRange {
  std::uint32_t least = std::numeric_limits<std::uint32_t>::max(), most = 0;
  void add(std::uint32_t c) { least = std::min(least, c), most = std::max(most, c); }
  ColourRange(const Surfels& f, const std::vector<SurfelRow>& rows) {
    for (std::size_t i = 0; i < f.size(); i++) add(f.colour[i]);
    for (const SurfelRow& r : rows)
      if (inherits(r)) add(r.colour);
  }
  bool one() const { return least >= most; }
};

/// Finds the nearest surfel of the row's component, and of other components. Only surfels within `reach` (m)
/// of the row and `around` (m) of its particle count. Also sums the mean colour of the row's component.
void findNearest(const Surface& surface, const Bins& bins, const SurfelRow& r, double reach, double around,
                 Nearest& own, Nearest& any, MeanColour& mean) {
  const Surfels& f = surface.surfels;
  const Vec3d particle = surface.particles.position[r.particle];
  forRowsWithin(bins, r.position, reach, [&](std::uint32_t j, double d2) {
    const Vec3d p = f.position[j] - particle;
    if (dot(p, p) > around * around) return;
    const bool same = f.component[j] == r.component;
    (same ? own : any).update(d2, f.id[j], f.colour[j]);
    if (same) mean.add(1 - d2 / (reach * reach), f.colour[j]);
  });
}

}  // namespace

bool coloursMayDiffer(const Scene& scene) {
  for (std::size_t b = 0; b < scene.bodies.size() + scene.emitters.size(); b++)
    if (hasMesh(scene, b) || surfaceColour(scene, b) != surfaceColour(scene, 0)) return true;
  return false;
}

void inheritColours(const Scene& scene, const Surface& s, const Bins& bins, std::vector<SurfelRow>& rows) {
  if (ColourRange(s.surfels, rows).one()) return;
  // All surfels within a cell's edge of an owned particle are known on this rank.
  const double around = std::min({s.grid.edge.x, s.grid.edge.y, s.grid.edge.z});
  for (SurfelRow& r : rows) {
    if (!inherits(r)) continue;
    Nearest own, any;
    MeanColour near, far;
    findNearest(s, bins, r, 2 * s.spacing, around, own, any, near);
    if (near.weight > 0) {
      r.colour = near.colour();
      continue;
    }
    // The row keeps its material's colour.
    if (!ofMesh(scene, s, r)) continue;
    if (!own.found())
      findNearest(s, bins, r, around + length(r.position - s.particles.position[r.particle]), around, own,
                  any, far);
    if (own.found()) r.colour = own.colour;
    else if (any.found()) r.colour = any.colour;
  }
}

void inheritColours(const Scene& scene, Surface& s, SurfaceHalos halos, SurfaceTools& t,
                    std::vector<SurfelRow>& rows) {
  if (!coloursMayDiffer(scene)) return;
  Surfels& f = s.surfels;
  const ColourRange here(f, rows);
  double all[3] = {
      std::any_of(rows.begin(), rows.end(), [&](const SurfelRow& r) { return inherits(r); }) ? 1.0 : 0.0,
      static_cast<double>(here.most), -static_cast<double>(here.least)};
  halos.all.maximum(all);
  if (all[0] == 0 || -all[2] >= all[1]) return;
  addGhosts(halos.surfels, f, s.surfelCells, ColumnList{&f.id, &f.position, &f.component, &f.colour});
  fillBins(s.grid, s.surfelCells, f.position.data(), 2 * s.spacing, t.relax.surfelBins);
  inheritColours(scene, s, t.relax.surfelBins, rows);
  dropGhosts(f, s.surfelCells);
}

}  // namespace thaw
