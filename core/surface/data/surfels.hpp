// SPDX-License-Identifier: Apache-2.0
// Fields of surfels (K05 section 4), and of the particle copies of a surface update.
#pragma once
#include "core/fields/column.hpp"

namespace thaw {

/// Component label of particles that do not belong to a component yet.
inline constexpr std::uint64_t noComponent = 0;

/// Oriented discs on the surface of continuum bodies. A row belongs to the rank that owns its cell of
/// Surface::grid.
struct Surfels : Table {
  Surfels() : Table("surfels") {}
  // clang-format off
  Column<std::uint64_t> id{*this, "id", "1", Keep::State,
      "samples of meshes and shapes: body << 40 | sample, with the top bit set; births: a hash of parent, "
      "step and position"};
  Column<Vec3d> position{*this, "position", "m", Keep::State, "centre"};
  Column<Vec3d> normal{*this, "normal", "1", Keep::State, "outward unit normal"};
  Column<Vec3d> tangent{*this, "tangent", "1", Keep::State,
      "unit tangent; the second one is normal x tangent"};
  Column<double> radius{*this, "radius", "m", Keep::State,
      "r_s, target spacing: neighbours at most this far apart leave no hole"};
  Column<std::uint64_t> component{*this, "component", "1", Keep::State,
      "component label: 1 + the smallest id of its particles"};
  Column<std::uint32_t> colour{*this, "colour", "1", Keep::State,
      "surface colour, red | green << 8 | blue << 16"};
  Column<float> detail{*this, "detail", "1", Keep::State,
      "remaining fraction of the mesh's detail, 1 at the start, 0 after melting"};
  Column<float> liquid{*this, "liquid", "1", Keep::State,
      "liquid fraction of the surrounding particles: weight of the surface update (K05 4.5)"};
  Column<float> maxLiquidFraction{*this, "maxLiquidFraction", "1", Keep::State,
      "largest liquid fraction since it was solid, which has faded its detail (blend.hpp); 0: none yet. Only "
      "with solids that melt"};
  Column<float> detailHeight{*this, "detailHeight", "m", Keep::State,
      "remaining height of detail over the smooth surface, where maxLiquidFraction > 0"};
  Column<float> temperature{*this, "temperature", "K", Keep::State,
      "temperature of the surrounding particles; only with heat"};
  Column<float> resampleMargin{*this, "resampleMargin", "1", Keep::State,
      "remaining strain and moves in radii before resampling inspects its surroundings; 0: at once"};
  Column<std::uint8_t> hasReference{*this, "hasReference", "1", Keep::State,
      "1: it has a reference position and frame (reference_motion.hpp); only with solids"};
  Column<Vec3d> referencePosition{*this, "referencePosition", "m", Keep::State, "reference position"};
  Column<Vec3d> referenceNormal{*this, "referenceNormal", "1", Keep::State, "reference normal"};
  Column<Vec3d> referenceTangent{*this, "referenceTangent", "1", Keep::State, "reference tangent"};
  Column<Vec3d> wallOffset{*this, "wallOffset", "m", Keep::State,
      "displacement of a solid's surfel by walls from its position on the body; only with walls"};
  Column<std::uint64_t> cell{*this, "cell", "1", Keep::Local, "key of the cell at the last sort"};
  Column<std::uint64_t> nextCell{*this, "nextCell", "1", Keep::Local, "key of the cell now"};
  // fields of the current update: inactive outside of it, and not in checkpoints
  Column<std::uint8_t> moving{*this, "moving", "1", Keep::State,
      "1: moved in the last iteration; 2: stopped at the margin until the next search"};
  Column<float> stepShare{*this, "stepShare", "1", Keep::State,
      "fraction of the last step along its normal; negative: into the body; 0: none yet"};
  Column<float> gapCutoff{*this, "gapCutoff", "m", Keep::State,
      "height over its plane above which particles are across a gap (gap_cutoffs.hpp); infinity: no gap"};
  Column<std::uint8_t> wallAligned{*this, "wallAligned", "1", Keep::State,
      "1: rests on a wall that it faces during iterations (alignWithWalls); only with walls"};
  Column<Vec3d> carried{*this, "carried", "m", Keep::State,
      "position after the particles' displacement (displaceSurfels)"};
  Column<Vec3d> carriedNormal{*this, "carriedNormal", "1", Keep::State,
      "normal after the displacement; 0: born in this update on a crack face"};
  Column<float> strain{*this, "strain", "1", Keep::State,
      "magnitude of the strain since the last update (displaceSurfels)"};
  Column<std::uint8_t> relaxesOnce{*this, "relaxesOnce", "1", Keep::State,
      "1: new on a crack face, or beside a seam of a merge; it relaxes in this update even if solid"};
  // fields of components and measures
  Column<double> linkRadius2{*this, "linkRadius2", "m^2", Keep::Transient,
      "squared distance to the farthest of the nearest surfels that it may link to"};
  Column<std::uint64_t> nearest{*this, "nearest", "1", Keep::Transient,
      "id of the nearest particle of its component, ~0 without one within h_ps"};
  Column<Vec3d> toNearest{*this, "toNearest", "m", Keep::Transient, "from the surfel to that particle"};
  Column<std::uint64_t> part{*this, "part", "1", Keep::Transient,
      "label of its connected part; top bit set: a part without particles"};
  Column<double> area{*this, "area", "m^2", Keep::Transient, "area of its cell, at the end of an update"};
  Column<Vec3d> facets{*this, "facets", "m^2", Keep::Transient,
      "part of the vector areas of the facets between it and its neighbours (facets.hpp)"};
  Column<double> bulge{*this, "bulge", "m^3", Keep::Transient,
      "part of the volume between these facets and the curved surface"};
  Column<double> rim{*this, "rim", "m", Keep::Transient,
      "length of its cell's border without a neighbour, as beside a hole"};
  Column<std::uint8_t> onWall{*this, "onWall", "1", Keep::Transient,
      "1: lies on a wall that it faces; only with walls"};
  // fields of resampling
  Column<double> depth{*this, "depth", "m", Keep::State,
      "only in an ActiveSet: lower bound of the distance to surfels that were open when it was made"};
  Column<double> targetRadius{*this, "targetRadius", "m", Keep::Transient, "target radius from curvature"};
  Column<std::uint8_t> resampleFlags{*this, "resampleFlags", "1", Keep::Transient,
      "resampling flags: 1 birth candidate, 2 crowded, 4 precedes all that are too close, 8 dies or gives "
      "birth"};
  Column<Vec3d> candidateOffset{*this, "candidateOffset", "m", Keep::Transient,
      "vector from the surfel to the birth candidate"};
  Column<Vec3d> candidateNormal{*this, "candidateNormal", "1", Keep::Transient,
      "surface normal at the candidate"};
  // clang-format on
};

/// Returns true if the forces of an update move a surfel. They move surfels of liquids, and, once, new
/// surfels of crack faces.
inline bool mayRelax(const Surfels& s, std::size_t i) {
  return (s.liquid.active && s.liquid[i] > 0) || (s.relaxesOnce.active && s.relaxesOnce[i]);
}

/// Return the fractions of an offset by which volume enforcement moves a surfel, in liquid and in frozen
/// components. The frozen fraction excludes mesh detail.
inline double liquidShare(const Surfels& s, std::size_t i) {
  return s.liquid.active ? static_cast<double>(s.liquid[i]) : 0;
}
inline double frozenShare(const Surfels& s, std::size_t i) {
  return liquidShare(s, i) > 0.5 ? 0 : 1 - static_cast<double>(s.detail[i]);
}

inline bool liesOnWall(const Surfels& s, std::size_t i) { return s.onWall.active && s.onWall[i]; }

/// Particle copies of a surface update, on the rank that owns their cell of Surface::grid. Every update makes
/// new copies.
struct SurfaceParticles : Table {
  SurfaceParticles() : Table("surface particles") {}
  // clang-format off
  Column<std::uint64_t> id{*this, "id", "1", Keep::State, "id of the particle"};
  Column<Vec3d> position{*this, "position", "m", Keep::State,
      "position at the last update; current after advanceParticles"};
  Column<Vec3d> displacement{*this, "displacement", "m", Keep::State,
      "displacement since the last update; 0 for new particles"};
  Column<std::uint64_t> component{*this, "component", "1", Keep::State,
      "component label; noComponent: new since the last update"};
  Column<double> volume{*this, "volume", "m^3", Keep::State, "mass over rest density"};
  Column<float> fill{*this, "fill", "1", Keep::State,
      "initial fraction of its cell inside the body, over the mean (Continuum::initialFill); 0: the mean"};
  Column<double> volumeRatio{*this, "volumeRatio", "1", Keep::State,
      "target volume inside the surface over its own volume"};
  Column<double> mass{*this, "mass", "kg", Keep::State, "mass of the particle"};
  Column<float> liquid{*this, "liquid", "1", Keep::State, "liquid fraction"};
  Column<float> temperature{*this, "temperature", "K", Keep::State, "temperature; only with heat"};
  Column<std::uint16_t> body{*this, "body", "1", Keep::State, "index into bodies, then emitters"};
  Column<std::uint8_t> covered{*this, "covered", "1", Keep::State,
      "1: solid with all initial bonds, and never adjacent to liquid; only with solids"};
  Column<Vec3d> referencePosition{*this, "referencePosition", "m", Keep::State,
      "position when the surface was made; only with solids"};
  Column<float> colour{*this, "colour", "1", Keep::Transient,
      "colour field of its component at the particle (prepareParticles)"};
  Column<float> smoothColour{*this, "smoothColour", "1", Keep::Transient,
      "colour field of particles weighted by their colour"};
  Column<std::uint64_t> source{*this, "source", "1", Keep::State,
      "rank << 32 | row of the original particle"};
  Column<std::uint64_t> cell{*this, "cell", "1", Keep::Local, "key of the cell at the last sort"};
  Column<std::uint64_t> nextCell{*this, "nextCell", "1", Keep::Local, "key of the cell now"};
  Column<Mat3d> gradient{*this, "gradient", "1", Keep::State,
      "displacement gradient, by moving least squares over the neighbours"};
  Column<std::uint64_t> part{*this, "part", "1", Keep::Transient,
      "label of its connected part: 1 + the smallest id"};
  // clang-format on
};

/// Deactivates a column: its memory is freed, and checkpoints no longer contain it.
inline void deactivate(AnyColumn& c) {
  c.active = false;
  c.bytes.clear();
}

}  // namespace thaw
