// SPDX-License-Identifier: Apache-2.0
// All particles of a trial on every rank, for neighbour sums and connected components.
#pragma once
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "benchmarks/accuracy/trial.hpp"

namespace thaw::accuracy {

struct GatheredParticle {
  std::uint64_t id;
  Vec3d position;   // m
  Vec3d velocity;   // m/s
  double mass;      // kg
  double pressure;  // Pa
  std::uint64_t body;
};

/// Every particle, on every rank, by ascending id. Collective.
std::vector<GatheredParticle> gather(Trial& trial);

/// Calls action(i, j, x_i - x_j of the nearest image) once for each pair closer than `radius` (m).
using PairAction = std::function<void(std::size_t i, std::size_t j, const Vec3d& between)>;
void forEachPair(const Domain& domain, const std::vector<GatheredParticle>& particles, double radius,
                 const PairAction& action);

/// Components: sets of particles joined by links shorter than `link` (m).
struct Components {
  std::size_t count;
  double largestShare;  // fraction of all particles in the largest component
};
Components findComponents(const Domain& domain, const std::vector<GatheredParticle>& particles, double link);

/// Mean summed density relative to the lattice at rest, over particles inside the liquid; 0 if there are
/// none. A particle is inside if each of 26 directions has a neighbour 1.25 to 2.5 spacings away within 37
/// degrees.
double meanInnerDensity(const Domain& domain, double spacing, const std::vector<GatheredParticle>& particles);

/// Writes x, y, speed and pressure of the layer of particles in the middle of the z axis. Returns false if
/// the file cannot be written.
bool writeMiddleLayer(Trial& trial, const std::string& path);

}  // namespace thaw::accuracy
