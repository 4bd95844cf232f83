// Whether a place is inside a component's surface: by the surfels nearest to it.
#pragma once
#include <cstdint>
#include <vector>

#include "core/surface/bins.hpp"
#include "core/surface/surfels.hpp"

namespace thaw {

/// A component's surface as seen from a place near it.
struct SurfaceSide {
  std::uint64_t component = noComponent;
  double distance = 0;  ///< m, to the nearest disc; below 0: inside
  Vec3d normal{};       ///< out of the component, there
  double liquid = 0;    ///< mean liquid fraction of the surfels that were asked
  int asked = 0;
  std::uint32_t nearest = 0;  ///< row of the nearest surfel
};

/// Fewer surfels say nothing about inside and outside.
inline constexpr int leastAsked = 3;

/// Kept for its memory.
struct InsideTools {
  struct Candidate {
    std::uint64_t component;
    double distance;  // to the disc
    std::uint64_t id;
    std::uint32_t row;
  };
  struct Seen {
    std::uint32_t row, group;  // group: of its component
    double d2;                 // to the middle of the disc
  };
  struct Group {
    std::uint64_t component;
    double d2;  // of the nearest middle
  };
  std::vector<Candidate> near;
  std::vector<Seen> seen;
  std::vector<Group> groups;
};

/// The sides of components within `reach` (m) of x, ascending by label; others: of all but component `label`,
/// else of that alone. `bins` are of the surfels, ghosts included. Each surfel is a disc of half its radius
/// (so that neighbours touch; whole discs stick out over edges). Of the discs not more than one radius
/// farther than the nearest one, at most 12, the sum of (x - c).n / |x - c|^2, c the closest point of the
/// disc, gives the sign: at an edge one disc may say inside, but the one that x is truly in front of is
/// nearer or looks straighter at it. Both faces of a sheet, however thin, say inside between them; in front
/// of it the nearer one outweighs the other (docs/validation/stability.md B20). Inside is only what looks at
/// the back of some disc at more than 30 degrees: not what lies beyond the open end of a neck that has just
/// parted.
void findSides(const Surfels& surfels, const Bins& bins, const Vec3d& x, std::uint64_t label, bool others,
               double reach, InsideTools& tools, std::vector<SurfaceSide>& sides);

}  // namespace thaw
