#include "core/surface/leap.hpp"

#include <algorithm>
#include <limits>

#include "core/surface/iso_surface.hpp"
#include "core/surface/place_rows.hpp"
#include "core/surface/surfel_move.hpp"
#include "core/surface/update_surface.hpp"

namespace thaw {
namespace {

/// As near as this, in spacings of surfels, forces take it on.
constexpr double nearEnough = 0.3;
/// Of half a spacing of the particles each: so far around its cell the grid leaves room (prepareSurface).
constexpr int legs = 5;

/// One leg of Newton's way from where the surfel was sorted. True where it has ended: on the surface, or where there is none to be found.
bool leapLeg(const World& w, const SurfaceTools& t, Surfels& f, std::size_t i, double raised) {
  const double room = 0.5 * w.scene.spacing, enough = nearEnough * w.surface.spacing;
  const Vec3d start = f.position[i];
  Vec3d x = start;
  for (int k = 0; k < 6; k++) {
    const FieldHere c = colourAt(w, t, f.component[i], x);
    const double slope = length(c.gradient);
    if (!(slope * w.surface.particleSupport > 0.05 * c.level && c.value > 0)) return true;
    const Vec3d outward = c.gradient * (-1 / slope);
    if (dot(outward, f.normal[i]) < 0) return true;
    const double step = std::clamp(c.tight * ((c.level - c.value) / slope - raised), -room, room);
    x -= outward * step;
    const double gone = length(x - start);
    if (gone > room) x = start + (x - start) * (room / gone);
    f.position[i] = outOfWalls(w, x, outward);
    f.normal[i] = outward;
    if (std::abs(step) <= enough) return true;
    if (gone > room) return false;
  }
  return true;
}

}  // namespace

void leapOntoSurface(World& w, SurfaceHalos halos, SurfaceTools& t) {
  Surface& s = w.surface;
  Surfels& f = s.surfels;
  f.resize(f.owned, 0);
  double going = 1;
  for (int leg = 0; leg < legs && going > 0; leg++) {
    placeRows(s.grid, halos.surfels, f, s.surfelCells, t.sort);
    going = 0;
    for (std::size_t i = 0; i < f.owned; i++) {
      if (f.moving[i] != heldAtMargin) continue;
      f.pace[i] = 0;
      if (f.ceiling[i] < std::numeric_limits<float>::infinity() || leapLeg(w, t, f, i, raisedOf(t.relax.raised, f.component[i]))) f.moving[i] = 1;
      else going = 1;
    }
    halos.all.maximum({&going, 1});
  }
  for (std::size_t i = 0; i < f.owned; i++) f.moving[i] = std::min<std::uint8_t>(f.moving[i], 1);
}

}  // namespace thaw
