// From the sums over its neighbours to the move of one surfel (K05 4.2.2, 4.2.3).
#pragma once
#include <vector>

#include "core/surface/relax.hpp"
#include "core/surface/relax_tools.hpp"
#include "core/world.hpp"

namespace thaw {

/// The sums of one lane: channel c at [8 c + lane].
struct SurfelSums {
  const float *surfels, *particles;
  int lane;
  double surfel(int channel) const { return static_cast<double>(surfels[8 * channel + lane]); }
  double particle(int channel) const { return static_cast<double>(particles[8 * channel + lane]); }
};

struct MoveCounts { std::int64_t flipped = 0, keptNormals = 0; };

/// What all surfels share.
struct MoveContext {
  ForceWeights weights;
  const LevelTable* level;
  double unit;          ///< m, of the sums' lengths
  double support;       ///< m, h_ps
  double slope;         ///< 1/m, of the gradient's sum
  double isoScale;      ///< isoLevel / .5
  double leastScale;    ///< leastLevel / .5
  double longest;       ///< m, of a move
  double spread = 1;    ///< factor of moves along the surface
  bool plane;
};
MoveContext moveContext(const World& world, const RelaxTools& tools, const ForceWeights& weights);

double pushOf(const std::vector<ComponentPush>& pushes, std::uint64_t component);

/// Moves surfel i and turns its frame; returns how far it went (m).
double moveSurfel(World& world, const MoveContext& context, const SurfelSums& sums, double push, std::size_t i, MoveCounts& counts);

}  // namespace thaw
