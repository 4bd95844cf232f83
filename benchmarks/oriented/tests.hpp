// SPDX-License-Identifier: Apache-2.0
// Measurements of scripts/bench oriented and the output of their figures.
#pragma once
#include <chrono>
#include <cstdio>

#include "core/oriented/forces/oriented_forces.hpp"
#include "tests/support/simulation.hpp"

namespace thaw::bench {

/// Writes figures to the terminal and the CSV file.
struct Figures {
  FILE* csv = nullptr;
  int missed = 0;  ///< number of missed targets

  /// Prints one figure. The value must not exceed `target`; 0 means no target.
  void row(const char* name, const char* figure, double particles, double value, double target) {
    const bool bad = target > 0 && !(value <= target);
    missed += bad;
    if (target > 0) std::fprintf(csv, "\"%s: %s\",%.0f,%.6g,%.3g\n", name, figure, particles, value, target);
    else std::fprintf(csv, "\"%s: %s\",%.0f,%.6g,\n", name, figure, particles, value);
    std::printf("%-12s %-76s %8.0f particles  %12.6g%s\n", name, figure, particles, value,
                target > 0 ? (bad ? "  MISSED" : "  ok") : "");
    std::fflush(stdout);
  }
};

/// A body with default parameters and some damping in empty space.
inline Scene defaultBody(double spacing) {
  Scene s;
  s.spacing = spacing;
  s.domain.min = {-1.5, -1.5, -1.5};
  s.domain.max = {1.5, 1.5, 1.5};
  s.domain.gravity = {};
  s.output.every = 0;
  s.oriented.emplace_back();
  s.oriented[0].name = "body";
  s.oriented[0].damping = s.oriented[0].spinDamping = 5;
  return s;
}

/// Energy per particle of one of the potentials, over stiffness spacing^2.
double energyOf(const test::Simulation& x, double PairPotential::*weight);

inline double seconds(const std::chrono::steady_clock::time_point& since) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - since).count();
}

void plane(Figures& figures);
void lattice(Figures& figures);
void sphere(Figures& figures);
void rebuilt(Figures& figures, double spacing);  // m
void neighbours(Figures& figures);

}  // namespace thaw::bench
