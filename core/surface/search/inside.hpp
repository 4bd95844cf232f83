// SPDX-License-Identifier: Apache-2.0
// Inside-outside test of a position by the nearest surfels of a component.
#pragma once
#include <cstdint>
#include <vector>

#include "core/surface/data/surfels.hpp"
#include "core/surface/search/bins.hpp"

namespace thaw {

/// Position relative to the surface of a nearby component.
struct SurfaceSide {
  std::uint64_t component = noComponent;
  double distance = 0;  ///< m, to the nearest disc; negative inside
  Vec3d normal{};       ///< outward unit normal of the component, at the nearest surface
  double liquid = 0;    ///< mean liquid fraction of the surfels used
  int discsUsed = 0;
  std::uint32_t nearest = 0;  ///< row of the nearest surfel
};

/// Smallest number of surfels for a valid inside-outside test.
inline constexpr int leastDiscs = 3;

/// Buffers, kept between calls.
struct InsideTools {
  struct Candidate {
    std::uint64_t component;
    double distance;  // m, to the disc
    std::uint64_t id;
    std::uint32_t row;
  };
  struct VisibleSurfel {
    std::uint32_t row, group;  // group: index of its component
    double d2;                 // m^2, to the centre of the disc
  };
  struct Group {
    std::uint64_t component;
    double d2;  // m^2, to the nearest centre
  };
  std::vector<Candidate> near;
  std::vector<VisibleSurfel> seen;
  std::vector<Group> groups;
};

/// A position (m) and the components whose sides are sought within `reach` (m): all but `component` with
/// `others`, else only that one.
struct SideQuery {
  Vec3d position;
  std::uint64_t component;
  bool others;
  double reach;
};

/// Finds the sides of components within `reach` (m) of x, ascending by label. With `others`, these are all
/// components except `label`, else only `label`. bins: surfels, including ghosts. Each surfel counts as a
/// disc of half its radius, so neighbours touch but do not extend beyond edges. Up to 12 discs at most one
/// radius farther than the nearest disc count. The sign is that of the sum of (x - c) . n / |x - c|^2, with
/// the closest point c of each disc. It is correct at edges and on both sides of a thin sheet
/// (Inside.IsExactForACubeAndAThinSheet). Inside, x must also see the back of a disc at more than 30 degrees.
/// This excludes the open end of a parted neck.
void findSides(const Surfels& surfels, const Bins& bins, const SideQuery& query, InsideTools& tools,
               std::vector<SurfaceSide>& sides);

}  // namespace thaw
