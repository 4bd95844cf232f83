// Which surfels and particles hang together: the components of the surface (K05 4.4.1), over all ranks.
//
// Joined are, among those of one component so far,
// - surfels of which one is among the k = 10 nearest of the other, with normals within pi/4 (S_rest), unless
// their nearest particles are farther apart than 5/3 (of liquids 2) times the link below:
//   the skin over a crack, or between the ends of a neck that has parted, stretches for long;
// - each surfel with its nearest particle, so that the faces of a cube, which S_rest takes apart, are one
// body (docs/validation/stability.md B19);
// - particles closer than settings.linkLength * spacing.
// A component comes apart where no link is left.
#pragma once
#include <algorithm>

#include "core/halo/surface_halos.hpp"
#include "core/surface/bins.hpp"
#include "core/world.hpp"

namespace thaw {

/// Kept from update to update for its memory.
struct ComponentTools {
  Bins surfelBins, particleBins;
  std::vector<std::uint32_t> parent;  ///< of the union-find: rows of surfels, then of particles
  std::vector<std::uint64_t> least;   ///< smallest label of a root's set
  std::vector<std::uint8_t> dead;
  struct Near {
    double d2;  // m^2
    std::uint32_t row;
  };
  RowBlock block;
  std::vector<Near> near;
  struct Piece {
    std::uint64_t from, part;
    friend auto operator<=>(const Piece&, const Piece&) = default;
  };
  std::vector<Piece> pieces;  ///< of the last split: what each part was, ascending, the same on all ranks
  /// There are parts that may meet.
  bool several() const {
    return std::any_of(pieces.begin(), pieces.end(),
                       [&](const Piece& p) { return p.part != pieces.front().part; });
  }
};

/// Of how many nearest neighbours S_rest is taken.
inline constexpr int nearestSurfels = 10;

/// Particles that came since the last update take the component of the nearest particle that has one, hand
/// over hand, within linkLength * spacing; those that touch none are left. Surfels without a component take
/// that of the nearest particle (of the body in their id, if one is in reach). Needs placed rows with ghosts;
/// sends components. Collective.
void adoptFresh(World& world, SurfaceHalos halos, ComponentTools& tools);

/// Surfels::part and SurfaceParticles::part of owned and ghost rows: 1 + the smallest particle id that hangs
/// together with it; of surfels without particles a number with the top bit set. Needs placed rows with
/// ghosts. Collective; the rounds of exchange grow with the number of ranks that a body crosses, not with its
/// size.
void findParts(World& world, SurfaceHalos halos, ComponentTools& tools);

/// A part of particles without surfels that lies in the surface of its component so far, by one of its
/// particles at least, has not come off: it joins the part of the nearest surfel (of several the smallest;
/// K05: a particle belongs to the surface that it is inside of). Sparse liquids have gaps of more than the
/// length of a link near their surface. What is farther than h_ps from every surfel is not looked at. Needs
/// findParts. Collective.
void keepEnclosed(World& world, SurfaceHalos halos, ComponentTools& tools);

/// Parts become components. Components of several parts are counted and logged as split, in the order of
/// labels, and as renamed before that where the smallest label of their parts is another one than their own;
/// surfels without a particle are deleted and counted as lost; ghosts of surfels are dropped. Needs
/// findParts. Collective.
void splitComponents(World& world, SurfaceHalos halos, ComponentTools& tools);

/// Owned particle copies whose component has no surfel on any rank (a drop that came off, what an emitter
/// lets out): a surface is to be grown around them. Needs Surface::components as measured.
void listBareParticles(const Surface& surface, std::vector<std::uint32_t>& rows);

}  // namespace thaw
