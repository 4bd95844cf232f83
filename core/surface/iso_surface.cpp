#include "core/surface/iso_surface.hpp"

#include <algorithm>
#include <array>

#include "core/surface/update_surface.hpp"

namespace thaw {

FieldHere colourAt(const World& w, const SurfaceTools& t, std::uint64_t component, const Vec3d& x) {
  const double h = w.surface.particleSupport, h2 = h * h, back2 = 1 / h2, backNear2 = 1 / (nearSupport * nearSupport * w.scene.spacing * w.scene.spacing);
  FieldHere c;
  double mean = 0, near = 0;
  Vec3d gradient{};
  const Bins& bins = t.relax.particleBins;
  // first who is within reach, then the sums: half of those looked at are not, and nobody can foretell which
  struct Near { Vec3d d; double u, volume, smooth; };
  constexpr std::size_t most = 256;
  std::array<Near, most> within;
  std::size_t n = 0;
  const auto sum = [&] {
    for (std::size_t k = 0; k < n; k++) {
      const Near& p = within[k];
      const double u2 = p.u * p.u, v2 = p.volume * u2;
      c.value += v2 * p.u;
      mean += p.smooth * u2 * p.u;
      gradient -= v2 * p.d;
      const double m = std::max(1 - (1 - p.u) * h2 * backNear2, 0.0);
      near += m * m * m;
    }
    n = 0;
  };
  forBinRunsAround(bins, x, x, h, [&](std::size_t from, std::size_t to) {
    for (std::uint32_t k = bins.first[from]; k < bins.first[to]; k++) {
      const FieldPoint& p = t.relax.field[k];
      const Vec3d d = x - p.at;
      const double u = 1 - dot(d, d) * back2;
      within[n] = {d, u, p.volume, p.smooth};
      n += (u > 0) & (p.component == component);
      if (n == most) sum();
    }
  });
  sum();
  c.gradient = (6 * back2) * gradient;
  if (c.value > 0) c.tight = near < nearFull ? 0.5 : 1, c.level = tightened(t.relax.level.level(mean / c.value), near) * w.scene.surface.isoLevel / 0.5;
  return c;
}

bool ontoIsoSurface(const World& w, const SurfaceTools& t, std::uint64_t component, const Vec3d& start, double most, SurfacePoint& found) {
  const double longest = 0.5 * w.scene.spacing, enough = 0.01 * w.surface.spacing;
  Vec3d x = start;
  for (int k = 0; k < 12; k++) {
    const FieldHere c = colourAt(w, t, component, x);
    const double slope = length(c.gradient);
    if (!(slope * w.surface.particleSupport > 0.05 * c.level && c.value > 0)) return false;
    const double step = std::clamp(c.tight * (c.level - c.value) / slope, -longest, longest);
    x += c.gradient * (step / slope);
    if (dot(x - start, x - start) > most * most) return false;
    if (std::abs(step) > enough) continue;
    found = {x, c.gradient * (-1 / slope)};
    return true;
  }
  return false;
}

}  // namespace thaw
