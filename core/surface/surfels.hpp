// The fields of surfels (K05 section 4), and of the copies of particles that a surface update works with: one
// line a field.
#pragma once
#include "core/particles/column.hpp"

namespace thaw {

/// Of particles that belong to no component yet.
inline constexpr std::uint64_t noComponent = 0;

/// Oriented discs on the surface of continuum bodies. Rows are owned by the rank that owns their cell of
/// Surface::grid.
struct Surfels : Table {
  Surfels() : Table("surfels") {}
  // clang-format off
  Column<std::uint64_t> id{*this, "id", "1", Keep::State,
      "of a body's mesh or shape: body << 40 | sample, with the top bit set; of births: a hash of parent, "
      "step and place"};
  Column<Vec3d> position{*this, "position", "m", Keep::State, "centre"};
  Column<Vec3d> normal{*this, "normal", "1", Keep::State, "unit, out of the body"};
  Column<Vec3d> tangent{*this, "tangent", "1", Keep::State,
      "unit, across the normal; the second one is normal x tangent"};
  Column<double> radius{*this, "radius", "m", Keep::State,
      "r_s: neighbours at most this far apart leave no hole; the wanted spacing"};
  Column<std::uint64_t> component{*this, "component", "1", Keep::State,
      "label of its component: 1 + the smallest id of a particle in it"};
  Column<std::uint32_t> colour{*this, "colour", "1", Keep::State,
      "of the surface, red | green << 8 | blue << 16"};
  Column<float> detail{*this, "detail", "1", Keep::State,
      "height of the mesh's detail that the surfel still carries, 1 at the start, 0 where it has melted"};
  Column<float> liquid{*this, "liquid", "1", Keep::State,
      "liquid fraction of the particles around: the share of the surface update (K05 4.5)"};
  Column<float> softened{*this, "softened", "1", Keep::State,
      "largest liquid fraction since it was solid, to which its marks have faded (blend.hpp); 0: none yet. "
      "Only with solids that melt"};
  Column<float> mark{*this, "mark", "m", Keep::State,
      "height over the smooth surface that it keeps, where softened > 0"};
  Column<float> temperature{*this, "temperature", "K", Keep::State,
      "of the particles around; only with heat"};
  Column<float> calm{*this, "calm", "1", Keep::State,
      "strain and moves in radii that it may still undergo before resampling looks at its surroundings; 0: "
      "at once"};
  Column<std::uint8_t> follows{*this, "follows", "1", Keep::State,
      "its place follows from that at the start (follow_start.hpp); only with solids"};
  Column<Vec3d> startPlace{*this, "startPlace", "m", Keep::State, "of what follows: place at the start"};
  Column<Vec3d> startNormal{*this, "startNormal", "1", Keep::State, "of what follows: normal at the start"};
  Column<Vec3d> startTangent{*this, "startTangent", "1", Keep::State,
      "of what follows: tangent at the start"};
  Column<Vec3d> pressed{*this, "pressed", "m", Keep::State,
      "by how far walls hold it off where its body has it: of what is solid; only with walls"};
  Column<std::uint64_t> cell{*this, "cell", "1", Keep::Local, "key of the cell at the last sort"};
  Column<std::uint64_t> nextCell{*this, "nextCell", "1", Keep::Local, "key of the cell now"};
  // of the update under way: active within it only, so that they are in no checkpoint
  Column<std::uint8_t> moving{*this, "moving", "1", Keep::State,
      "it moved in the last iteration (2: and has to wait for a search): it and its neighbours are worked "
      "on"};
  Column<float> pace{*this, "pace", "1", Keep::State,
      "share taken of the last step along its normal; negative: into the body; 0: none yet"};
  Column<float> ceiling{*this, "ceiling", "m", Keep::State,
      "height over its plane from which on particles are across a gap (gap_ceilings.hpp); infinity: there is "
      "none"};
  Column<std::uint8_t> standing{*this, "standing", "1", Keep::State,
      "the iterations found it on a wall that it faces (findStanding); only with walls"};
  Column<Vec3d> carried{*this, "carried", "m", Keep::State,
      "where the particles' displacement has carried it (displaceSurfels)"};
  Column<Vec3d> carriedNormal{*this, "carriedNormal", "1", Keep::State,
      "its normal there; 0: born in this update on the face of a crack"};
  Column<float> strain{*this, "strain", "1", Keep::State,
      "magnitude of the strain since the last update (displaceSurfels)"};
  Column<std::uint8_t> loose{*this, "loose", "1", Keep::State,
      "new on the face of a crack, or beside a seam of what has joined: it settles in this update, solid or "
      "not"};
  // of its components and measures
  Column<double> reach{*this, "reach", "m^2", Keep::Transient,
      "square of the distance to the farthest of the nearest surfels that it hangs together with"};
  Column<std::uint64_t> nearest{*this, "nearest", "1", Keep::Transient,
      "id of the nearest particle of its component, ~0 without one within h_ps"};
  Column<Vec3d> toNearest{*this, "toNearest", "m", Keep::Transient, "from it to that particle"};
  Column<std::uint64_t> part{*this, "part", "1", Keep::Transient,
      "label of what hangs together; top bit set: no particle does"};
  Column<double> area{*this, "area", "m^2", Keep::Transient,
      "its own share of the surface, at the end of an update"};
  Column<Vec3d> facets{*this, "facets", "m^2", Keep::Transient,
      "its share of the vector areas of the facets between it and its neighbours (facets.hpp)"};
  Column<double> bulge{*this, "bulge", "m^3", Keep::Transient,
      "its share of what the curved surface holds over those facets"};
  Column<double> rim{*this, "rim", "m", Keep::Transient,
      "length of its cell's border that no neighbour cuts: beside a hole"};
  Column<std::uint8_t> onWall{*this, "onWall", "1", Keep::Transient,
      "it lies on a wall that it faces; only with walls"};
  // of resampling
  Column<double> depth{*this, "depth", "m", Keep::State,
      "only in an OpenRegion: at least its distance from what was open when that was taken"};
  Column<double> wanted{*this, "wanted", "m", Keep::Transient, "radius that curvature asks for"};
  Column<std::uint8_t> wish{*this, "wish", "1", Keep::Transient,
      "bits: 1 a new surfel beside it, 2 one is too close, 4 it comes before all that are, 8 it goes or "
      "gives birth"};
  Column<Vec3d> offer{*this, "offer", "m", Keep::Transient, "from it to the place of the new surfel"};
  Column<Vec3d> offerNormal{*this, "offerNormal", "1", Keep::Transient, "of the surface there"};
  // clang-format on
};

/// Does a surfel move under the forces of an update? What is liquid does, and new faces once.
inline bool settles(const Surfels& s, std::size_t i) {
  return (s.liquid.active && s.liquid[i] > 0) || (s.loose.active && s.loose[i]);
}

/// By what share of an offset volume keeping moves a surfel: of a component that is liquid, and of one that
/// has frozen; a mesh's detail stays.
inline double liquidShare(const Surfels& s, std::size_t i) {
  return s.liquid.active ? static_cast<double>(s.liquid[i]) : 0;
}
inline double frozenShare(const Surfels& s, std::size_t i) {
  return liquidShare(s, i) > 0.5 ? 0 : 1 - static_cast<double>(s.detail[i]);
}

inline bool liesOnWall(const Surfels& s, std::size_t i) { return s.onWall.active && s.onWall[i]; }

/// Particles as a surface update sees them, on the rank that owns their cell of Surface::grid. Made anew for
/// each update.
struct SurfaceParticles : Table {
  SurfaceParticles() : Table("surface particles") {}
  // clang-format off
  Column<std::uint64_t> id{*this, "id", "1", Keep::State, "of the particle"};
  Column<Vec3d> position{*this, "position", "m", Keep::State,
      "at the last update, and from bringParticlesForward on now"};
  Column<Vec3d> displacement{*this, "displacement", "m", Keep::State,
      "since the last update; 0 of fresh ones"};
  Column<std::uint64_t> component{*this, "component", "1", Keep::State,
      "label, noComponent: fresh, since the last update"};
  Column<double> volume{*this, "volume", "m^3", Keep::State, "mass / density at rest"};
  Column<float> fill{*this, "fill", "1", Keep::State,
      "what of its body was around it at the start, over the mean (Continuum::surfaceFill); 0: as much as of "
      "any"};
  Column<double> share{*this, "share", "1", Keep::State,
      "volume that the surface is to hold for it over its own"};
  Column<double> mass{*this, "mass", "kg", Keep::State, "of the particle"};
  Column<float> liquid{*this, "liquid", "1", Keep::State, "liquid fraction"};
  Column<float> temperature{*this, "temperature", "K", Keep::State, "only with heat"};
  Column<std::uint16_t> body{*this, "body", "1", Keep::State, "index into bodies, then emitters"};
  Column<std::uint8_t> covered{*this, "covered", "1", Keep::State,
      "solid with all its bonds of the start, and without liquid beside it since then; only where there are "
      "solids"};
  Column<Vec3d> startPlace{*this, "startPlace", "m", Keep::State,
      "where it was when the surface was made; only with solids"};
  Column<float> colour{*this, "colour", "1", Keep::Transient,
      "colour field of its component at the particle (readyParticles)"};
  Column<float> smoothColour{*this, "smoothColour", "1", Keep::Transient,
      "the same, of particles weighted by their colour"};
  Column<std::uint64_t> home{*this, "home", "1", Keep::State, "rank << 32 | row of the particle itself"};
  Column<std::uint64_t> cell{*this, "cell", "1", Keep::Local, "key of the cell at the last sort"};
  Column<std::uint64_t> nextCell{*this, "nextCell", "1", Keep::Local, "key of the cell now"};
  Column<Mat3d> gradient{*this, "gradient", "1", Keep::State,
      "of the displacement, by moving least squares over the neighbours"};
  Column<std::uint64_t> part{*this, "part", "1", Keep::Transient,
      "label of what hangs together: 1 + the smallest id"};
  // clang-format on
};

}  // namespace thaw
