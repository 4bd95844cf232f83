#include "core/surface/birth_colours.hpp"

#include <algorithm>
#include <limits>

#include "core/surface/place_rows.hpp"
#include "core/surface/sample_mesh.hpp"
#include "core/surface/update_surface.hpp"

namespace thaw {
namespace {

struct Nearest {
  double d2 = std::numeric_limits<double>::infinity();
  std::uint64_t id = 0;
  std::uint32_t colour = 0;
  void offer(double r2, std::uint64_t i, std::uint32_t c) {
    if (r2 < d2 || (r2 == d2 && i < id)) *this = {r2, i, c};
  }
  bool found() const { return d2 < std::numeric_limits<double>::infinity(); }
};

bool inherits(const World& w, const SurfelRow& r) { return r.particle != SurfelRow::none && hasMesh(w.scene, w.surface.particles.body[r.particle]); }

}  // namespace

bool hasMeshes(const Scene& scene) {
  for (std::size_t b = 0; b < scene.bodies.size(); b++)
    if (hasMesh(scene, b)) return true;
  return false;
}

void inheritColours(const World& w, const Bins& bins, std::vector<SurfelRow>& rows) {
  const Surface& s = w.surface;
  const Surfels& f = s.surfels;
  const double reach = std::min({s.grid.edge.x, s.grid.edge.y, s.grid.edge.z});  // of the particle, whose cell is this rank's: all surfels there are known
  for (SurfelRow& r : rows) {
    if (!inherits(w, r)) continue;
    Nearest own, any;
    forRowsWithin(bins, s.particles.position[r.particle], reach, [&](std::uint32_t j, double) {
      const Vec3d d = f.position[j] - r.position;
      (f.component[j] == r.component ? own : any).offer(dot(d, d), f.id[j], f.colour[j]);
    });
    if (own.found()) r.colour = own.colour;
    else if (any.found()) r.colour = any.colour;
  }
}

void inheritColours(World& w, SurfaceHalos halos, SurfaceTools& t, std::vector<SurfelRow>& rows) {
  if (!hasMeshes(w.scene)) return;
  std::int64_t asking[1] = {std::count_if(rows.begin(), rows.end(), [&](const SurfelRow& r) { return inherits(w, r); })};
  halos.all.sum(asking);
  if (asking[0] == 0) return;
  Surface& s = w.surface;
  Surfels& f = s.surfels;
  addGhosts(halos.surfels, f, s.surfelCells, ColumnList{&f.id, &f.position, &f.component, &f.colour});
  fillBins(s.grid, s.surfelCells, f.position.data(), 2 * s.spacing, t.relax.surfelBins);
  inheritColours(w, t.relax.surfelBins, rows);
  dropGhosts(f, s.surfelCells);
}

}  // namespace thaw
