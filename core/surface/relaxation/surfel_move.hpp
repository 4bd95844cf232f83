// SPDX-License-Identifier: Apache-2.0
// Motion of one surfel from the sums over its neighbours (K05 4.2.2, 4.2.3).
#pragma once
#include <vector>

#include "core/surface/data/surface_view.hpp"
#include "core/surface/relaxation/relax.hpp"
#include "core/surface/work/relax_tools.hpp"

namespace thaw {

struct MoveCounts {
  std::int64_t flipped = 0, keptNormals = 0;
};

/// Value of Surfels::moving for a surfel that stopped at the margin of its lists.
inline constexpr std::uint8_t stoppedAtMargin = 2;

/// Parameters common to all surfels.
struct MoveContext {
  ForceWeights weights;
  const LevelTable* level;
  double unit;        ///< m, unit of length of the sums
  double support;     ///< m, h_ps
  double slope;       ///< 1/m, factor of the gradient sum
  double nearSlope;   ///< 1/m, factor of the near gradient sum
  double isoScale;    ///< isoLevel / 0.5
  double leastScale;  ///< leastLevel / 0.5
  double longest;     ///< m, longest move
  double step;        ///< 1, move over force, normal to the surface
  double spread = 1;  ///< 1, factor of moves along the surface
  double ease = 1;    ///< 1, factor of moves normal to the surface
  double stray = 0;   ///< m, largest distance from the position at the last search
  const Vec3d* found = nullptr;
  bool plane;
};
MoveContext moveContext(const Scene& scene, const Surface& surface, const RelaxTools& tools,
                        const ForceWeights& weights);

/// Forces on a surfel normal to the surface.
struct NormalForce {
  Vec3d normal{}, outward{};  ///< new normal; normal of the iso-surface, where known
  double along = 0;           ///< m, force along the new normal
  double least = 0;           ///< m, smallest move into the body
  bool known = false, flipped = false, keptNormal = false;
};
NormalForce normalForceOn(const SurfaceView& view, const MoveContext& context, const SurfelSums& sums,
                          double isoOffset, std::size_t i);

/// Moves surfel i, rotates its frame, and sets Surfels::moving.
void moveSurfel(const SurfaceView& view, const MoveContext& context, const SurfelSums& sums, double isoOffset,
                std::size_t i, MoveCounts& counts);

}  // namespace thaw
