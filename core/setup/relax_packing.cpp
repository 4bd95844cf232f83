#include "core/setup/relax_packing.hpp"

#include <cmath>

#include "core/domain/sides.hpp"
#include "core/geometry/sampling.hpp"
#include "core/particle_sums.hpp"
#include "core/scene/full_box.hpp"

namespace thaw {
namespace {

constexpr int iterations = 30;

/// Sums of grad W over all neighbours, as the pressure force of a liquid whose pressure is 1 everywhere.
void kernelGradients(World& w, Halos& halos, StepTools& t) {
  Continuum& p = w.particles;
  computeCellKeys(w.grid, p);
  if (p.ghosts > 0) p.resize(p.owned, 0);
  const Migration m = halos.cells.migrate(p, {p.nextCell.data(), p.owned});
  computeCellKeys(w.grid, p);
  if (p.slot.active)
    for (std::size_t i = 0; i < p.owned; i++) p.slot[i] = noSlot;
  sortByCell(p, m, t.sort, w.cells);
  halos.cells.beginGhosts(p, w.cells, ghostColumns(w));
  halos.cells.finishGhosts(p, w.cells);
  clearRates(w);
  markInner(w, halos.cells, t);
  t.ghostRoom = std::max(t.ghostRoom, p.ghosts);
  sumUnitPressure(w, t);
}

/// The image of x, across periodic sides, that is nearest to a body's middle: where the body has it that reaches over a side.
Vec3d imageIn(const CellGrid& g, const Vec3d& middle, Vec3d x) {
  for (int a = 0; a < 3; a++)
    if (g.periodic[a]) x[a] -= g.period[a] * std::round((x[a] - middle[a]) / g.period[a]);
  return x;
}

}  // namespace

int relaxPacking(World& w, Halos halos, StepTools& t, const std::vector<std::shared_ptr<const SignedDistance>>& shapes) {
  bool wanted = false;
  for (const Body& b : w.scene.bodies) wanted = wanted || b.packing == Packing::Relaxed;
  if (!wanted) return 0;
  Continuum& p = w.particles;
  std::vector<Vec3d> middle;
  for (const auto& s : shapes) middle.push_back(0.5 * (s->bounds().min + s->bounds().max));
  const bool everywhere = liquidFillsTheBox(w.scene);  // then what crosses a side comes back on the other
  const double dx = w.scene.spacing, V = dx * dx * dx;
  for (int k = 0; k < iterations; k++) {
    kernelGradients(w, halos, t);
    for (std::size_t i = 0; i < p.owned; i++) {
      const std::size_t body = p.body[i];
      if (body >= w.scene.bodies.size() || w.scene.bodies[body].packing != Packing::Relaxed) continue;
      // force / V^2 = - 2 sum grad W (1/m^4); times V dx it is the share of a spacing that is missing on one side
      Vec3d move = p.force[i] * (0.25 * dx * dx / V);
      const double length2 = dot(move, move), most = 0.1 * dx;
      if (length2 > most * most) move = move * (most / std::sqrt(length2));
      p.position[i] += move;
      if (!everywhere) p.position[i] = pullInside(*shapes[body], imageIn(w.grid, middle[body], p.position[i]), 0.45 * dx);
      wrapPlace(w.grid, w.scene.domain, p.position[i]);
    }
  }
  p.resize(p.owned, 0);
  return iterations;
}

}  // namespace thaw
