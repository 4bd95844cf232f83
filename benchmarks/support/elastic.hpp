// The elastic step on a jittered lattice with a free surface and fixed bonds, for benchmarks.
#pragma once
#include "core/scene/scene.hpp"

namespace thaw::bench {

struct ElasticFigures {
  double particles = 0, neighbours = 0, bytesPerParticle = 0;
  double copy = 0, deformation = 0, forces = 0, move = 0;  ///< s a step, medians: particles to slots; phases 1 and 2; forces to particles and leap-frog
  double total = 0;                                        ///< s a step, median
};

/// n^3 particles, bonds shorter than `support` spacings; Green strain, hourglass control, energies not summed.
ElasticFigures elasticFigures(int n, double support, Precision precision, int repeat);

}  // namespace thaw::bench
