// SPDX-License-Identifier: Apache-2.0
// Declarations and helpers shared by the cases of solids.
#pragma once
#include <cmath>
#include <numbers>

#include "benchmarks/accuracy/trial.hpp"
#include "core/math/hash_random.hpp"
#include "core/solid/elasticity/solid_state.hpp"
#include "core/solid/laws/elastic_constants.hpp"

namespace thaw::accuracy {

std::vector<Case> elasticCases();      ///< gradient, rotation, free flight
std::vector<Case> waveCases();         ///< plane waves in a periodic body
std::vector<Case> beamCases();         ///< cantilevers
std::vector<Case> plasticCases();      ///< yield and creep
std::vector<Case> plasticFlowCases();  ///< large plastic flow

using std::numbers::pi;

/// The only material of these scenes.
inline const Material& materialOf(const World& w) { return w.scene.materials[0]; }
inline const ElasticConstants constantsOf(const World& w) { return elasticConstants(materialOf(w), 0); }

inline Mat3d gradientOf(const World& w, std::size_t i) {
  return w.solids.deformation[w.particles.solidIndex[i]] - identity3<double>();
}
inline double largestEntry(const Mat3d& m) {
  double most = 0;
  for (const Vec3d& r : m.row) most = std::max({most, std::abs(r.x), std::abs(r.y), std::abs(r.z)});
  return most;
}

/// Lattice coordinate of a particle moved by less than half a spacing, in a box sampled from `corner`.
inline double onLattice(double x, double corner, double spacing) {
  return corner + spacing * (std::floor((x - corner) / spacing) + 0.5);
}

/// Times of sign changes in a series, by linear interpolation.
inline std::vector<double> crossings(const std::vector<Sample>& series, std::size_t k) {
  std::vector<double> times;
  for (std::size_t n = 1; n < series.size(); n++) {
    const double a = series[n - 1].value[k], b = series[n].value[k];
    if (a * b < 0) times.push_back(series[n - 1].time + (series[n].time - series[n - 1].time) * a / (a - b));
  }
  return times;
}

}  // namespace thaw::accuracy
