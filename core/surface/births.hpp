// New surfels among old ones.
#pragma once
#include <vector>

#include "core/halo/surface_halos.hpp"
#include "core/surface/local_surface.hpp"

namespace thaw {

/// All that a surfel has, apart from the table.
struct SurfelRow {
  std::uint64_t id = 0, component = noComponent;
  Vec3d position{}, normal{0, 0, 1}, tangent{1, 0, 0};  ///< m, unit, unit
  double radius = 0;                                    ///< m
  std::uint32_t colour = 0;
  float detail = 0, liquid = 0, temperature = 0, softened = 0, mark = 0;
  bool follows = false;  ///< as it would have been at the start (follow_start.hpp):
  Vec3d startPlace{}, startNormal{}, startTangent{};  ///< m, unit, unit
  static constexpr std::uint32_t none = 0xffffffffu;
  std::uint32_t particle = none;  ///< row of the particle copy that it is grown around; none: of surfels
};

/// A surfel at p, with what the patch's surfels have there: weights fall to 0 at one and a half radii. Its id
/// is the caller's.
SurfelRow blendedSurfel(const Patch& patch, const SurfacePoint& p);

/// Appends rows behind the owned ones. The table must not have ghosts. Ids are not looked at: addSurfels
/// does.
void appendSurfels(Surfels& surfels, const std::vector<SurfelRow>& rows);

/// The same for births on all ranks: those whose id is there already, or among `others`, get another one
/// (renameTwins). Collective.
void addSurfels(Surfels& surfels, const std::vector<SurfelRow>& rows, std::uint64_t seed, Reducer& all,
                const Surfels* others = nullptr);

}  // namespace thaw
