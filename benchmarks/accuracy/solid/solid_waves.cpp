// SPDX-License-Identifier: Apache-2.0
// Speed of plane waves in a periodic body: standing waves u = a n cos(k x) oscillate with omega = c k.
#include "benchmarks/accuracy/solid/solid_trials.hpp"

namespace thaw::accuracy {
namespace {

struct Waves {
  Vec3d wave{};    ///< 1/m, k of the longest wave
  Vec3d across{};  ///< polarisation of S waves
  double spacing = 0;

  explicit Waves(const World& w) : spacing(w.scene.spacing) {
    const Domain& d = w.scene.domain;
    const bool diagonal = d.max.y == d.max.x;
    wave = {2 * pi / (d.max.x - d.min.x), diagonal ? 2 * pi / (d.max.y - d.min.y) : 0, 0};
    across = cross(Vec3d{0, 0, 1}, normalized(wave));
  }
  Vec3d rest(const World& w, const Vec3d& x) const {
    Vec3d r;
    for (int a = 0; a < 3; a++) r[a] = onLattice(x[a], w.scene.domain.min[a], spacing);
    return r;
  }
  static constexpr int harmonic[3] = {1, 2, 4};
  double shape(const World& w, const Vec3d& x, int n) const {
    return std::cos(harmonic[n] * dot(wave, rest(w, x)));
  }
  double wavelength(int n) const { return 2 * pi / length(wave) / harmonic[n]; }
};

void startWaves(Trial& r) {
  World& w = r.world;
  const Waves waves(w);
  const double a = 1e-5 * waves.spacing;
  for (std::size_t i = 0; i < w.particles.owned; i++) {
    double sum = 0;
    for (int n = 0; n < 3; n++) sum += waves.shape(w, w.particles.position[i], n);
    w.particles.position[i] += (normalized(waves.wave) + waves.across) * (a * sum);
  }
}

void watchWaves(Trial& r) {
  const Waves waves(r.world);
  Sample s{r.world.clock.time, {}};
  for (const Vec3d& along : {normalized(waves.wave), waves.across})
    for (int n = 0; n < 3; n++)
      s.value.push_back(sum(r, [&](const World& w, std::size_t i) {
        const Vec3d x = w.particles.position[i];
        return dot(x - waves.rest(w, x), along) * waves.shape(w, x, n);
      }));
  r.series.push_back(s);
}

std::vector<Figure> measureWaves(Trial& r) {
  const World& w = r.world;
  const Waves waves(w);
  const ElasticConstants c = constantsOf(w);
  const double density = materialOf(w).density,
               speed[2] = {std::sqrt((c.lambda + 2 * c.mu) / density), std::sqrt(c.mu / density)};
  std::vector<Figure> figures;
  for (std::size_t k = 0; k < 6; k++) {
    const double spacings = waves.wavelength(static_cast<int>(k % 3)) / r.spacing();
    const std::vector<double> t = crossings(r.series, k);
    if (t.empty()) continue;
    const double halves = static_cast<double>(t.size()) - 0.5;  // the first zero comes after a quarter of a
                                                                // period
    const double measured = waves.wavelength(static_cast<int>(k % 3)) * 0.5 * halves / t.back();
    char name[64];
    std::snprintf(name, sizeof name, "%s speed at %.3g dx", k < 3 ? "P" : "S", spacings);
    figures.push_back({name, std::abs(measured / speed[k / 3] - 1),
                       spacings > 9.5 ? 0.015 * std::pow(20 / spacings, 2) : never});
  }
  return figures;
}

}  // namespace

std::vector<Case> waveCases() {
  return {{"p_wave",
           "plane P and S waves of 40, 20 and 10 spacings along an axis; c = sqrt((lambda + 2 mu)/rho), "
           "sqrt(mu/rho)",
           nullptr,
           {},
           startWaves,
           watchWaves,
           measureWaves},
          {"p_wave_diagonal",
           "the same along a diagonal of the lattice",
           nullptr,
           {},
           startWaves,
           watchWaves,
           measureWaves}};
}

}  // namespace thaw::accuracy
