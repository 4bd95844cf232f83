#include "core/surface/gather_particles.hpp"

#include <cmath>
#include <vector>

namespace thaw {

void gatherParticles(World& w, int rank) {
  const Continuum& p = w.particles;
  SurfaceParticles& c = w.surface.particles;
  c.resize(c.owned, 0);
  c.resize(p.owned, 0);
  for (std::size_t i = 0; i < p.owned; i++) {
    const bool fresh = p.component[i] == noComponent;
    Vec3d u = fresh ? Vec3d{} : p.position[i] - p.surfacePlace[i];
    for (int a = 0; a < 3; a++)
      if (w.grid.periodic[a]) u[a] -= w.grid.period[a] * std::nearbyint(u[a] / w.grid.period[a]);
    c.id[i] = p.id[i];
    c.position[i] = fresh ? p.position[i] : p.surfacePlace[i];
    c.displacement[i] = u;
    c.component[i] = p.component[i];
    c.mass[i] = p.mass[i];
    c.share[i] = p.surfaceShare.active && p.surfaceShare[i] > 0 ? p.surfaceShare[i] : 1;
    c.volume[i] = p.mass[i] / w.scene.materials[p.material[i]].density;
    if (c.fill.active) c.fill[i] = p.surfaceFill[i];
    if (c.liquid.active) c.liquid[i] = p.liquid.active ? p.liquid[i] : static_cast<float>(p.phase[i] == Liquid);
    if (c.temperature.active) c.temperature[i] = static_cast<float>(p.temperature[i]);
    if (c.startPlace.active) c.startPlace[i] = p.surfaceStart[i];
    if (c.covered.active) c.covered[i] = p.slot[i] != noSlot && !w.solids.bared[p.slot[i]];
    c.body[i] = p.body[i];
    c.home[i] = static_cast<std::uint64_t>(rank) << 32 | i;
  }
}

void returnParticles(World& w, SurfaceHalos halos) {
  Continuum& p = w.particles;
  SurfaceParticles& c = w.surface.particles;
  halos.courier.sendHome({c.home.data(), c.owned}, {c.component.data(), c.owned}, {p.component.data(), p.owned});
  if (c.covered.active) {
    std::vector<std::uint64_t> there(c.covered.data(), c.covered.data() + c.owned), here(p.owned);
    halos.courier.sendHome({c.home.data(), c.owned}, there, here);
    for (std::size_t i = 0; i < p.owned; i++)
      if (p.slot[i] != noSlot && here[i] == 0) w.solids.bared[p.slot[i]] = 1;
  }
  for (std::size_t i = 0; i < p.owned; i++) p.surfacePlace[i] = p.position[i];
  c.resize(c.owned, 0);
  c.resize(0, 0);
}

}  // namespace thaw
