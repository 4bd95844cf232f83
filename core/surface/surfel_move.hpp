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

struct MoveCounts {
  std::int64_t flipped = 0, keptNormals = 0;
};

/// Surfels::moving of one that would go on, but has come to the end of what its lists allow.
inline constexpr std::uint8_t heldAtMargin = 2;

/// What all surfels share.
struct MoveContext {
  ForceWeights weights;
  const LevelTable* level;
  double unit;        ///< m, of the sums' lengths
  double support;     ///< m, h_ps
  double slope;       ///< 1/m, of the gradient's sum
  double nearSlope;   ///< 1/m, of the sum of near ones
  double isoScale;    ///< isoLevel / .5
  double leastScale;  ///< leastLevel / .5
  double longest;     ///< m, of a move
  double step;        ///< move over the force across the surface
  double spread = 1;  ///< factor of moves along the surface
  double ease = 1;    ///< and of those across it
  double stray = 0;   ///< m, that a surfel may be from where the last search found it
  const Vec3d* found = nullptr;
  bool plane;
};
MoveContext moveContext(const World& world, const RelaxTools& tools, const ForceWeights& weights);

/// m, how far the surface of a component is held off its level; 0 of those that are not listed.
double raisedOf(const std::vector<RaisedComponent>& raised, std::uint64_t component);

/// What the forces across the surface ask of a surfel.
struct Pull {
  Vec3d normal{}, outward{};  ///< its new normal; that of the iso-surface through it, where that is known
  double along = 0;           ///< m, along the new normal
  double least = 0;           ///< m, how far into the body at least
  bool known = false, flipped = false, keptNormal = false;
};
Pull pullOn(const World& world, const MoveContext& context, const SurfelSums& sums, double raised,
            std::size_t i);

/// Moves surfel i and turns its frame and sets Surfels::moving.
void moveSurfel(World& world, const MoveContext& context, const SurfelSums& sums, double raised,
                std::size_t i, MoveCounts& counts);

}  // namespace thaw
