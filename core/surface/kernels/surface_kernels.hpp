// SPDX-License-Identifier: Apache-2.0
// Kernels for eight surfels at a time, one set for each instruction set. They are for sums over particles and
// surfels (forces_isa.cpp), displacement (carry_isa.cpp), areas (areas_isa.cpp), positions near a box
// (near_box_isa.cpp), and patches (patch_isa.cpp). Every set gives the same bits. The interface uses plain
// pointers, because code for one instruction set must not give copies of library functions to the linker.
#pragma once
#include <cstddef>
#include <cstdint>

namespace thaw {

/// Channels of sums over particles. u = 1 - (r/h_ps)^2; d from the particle to the surfel, in units of the
/// grid's support radius. Near uses nearSupport (level_table.hpp) in place of h_ps.
enum ParticleSum {
  Colour,
  SmoothColour,
  Gradient,
  Attraction = Gradient + 3,
  SmoothGradient = Attraction + 3,
  Near = SmoothGradient + 3,
  NearGradient,
  particleSums = NearGradient + 3
};
/// Channels of sums over surfels. Plane: Mean (d) and Moment (d d^T) for the plane of the neighbours. Sphere:
/// Height and Normal.
enum SurfelSum {
  Weight,
  Height,
  Normal,
  Mean = Normal,
  Repulsion = Normal + 3,
  Stiffness = Repulsion + 3,
  MovedNearby,
  Coincident,
  Moment,
  sphereSums = Moment,
  planeSums = Moment + 6
};

/// Input and output of the sums. Records are four floats; positions are bits of fixed-point numbers
/// (grid.hpp), lengths are in support radii of the grid. The lists of a group hold the neighbours of any of
/// its eight surfels, in an order that is the same on every rank. Neighbours out of a surfel's range add
/// nothing to its sums, so grouping and margin do not change any bit.
struct ForceSums {
  const float* place = nullptr;           ///< surfels: x, y, z; 1 if moving, else 0
  const float* normal = nullptr;          ///< surfels: normal, radius
  const float* particle = nullptr;        ///< particles: x, y, z; V c_j over the lattice's sum of weights
                                          ///< (level_table.hpp)
  const float* particleColour = nullptr;  ///< particles: V a_j over the same sum
  const std::uint32_t* self = nullptr;    ///< 8 rows of surfels a group; short groups repeat their first row
  const std::uint64_t *firstSurfel = nullptr, *firstParticle = nullptr;  ///< start of each group's list, and
                                                                         ///< the end of the last
  const std::uint32_t *surfel = nullptr, *particleRow = nullptr;
  const std::uint32_t* groups = nullptr;  ///< indices of the groups to process
  std::size_t groupCount = 0;
  float perParticleSupport2 = 0;  ///< 1 / h_ps^2
  float perNearSupport2 = 0;      ///< 1 / nearSupport^2
  float support = 0;              ///< h_ss over a surfel's radius
  float repelRange = 0;           ///< range of repulsion over the mean radius of two surfels
  float sameSide = 0;             ///< least cosine of the angle between normals for smoothing
  /// surfels: gap cutoff, the height above their plane beyond which particles are across a gap
  /// (gap_cutoffs.hpp), or infinity
  const float* gapCutoff = nullptr;
  /// flags of groups with a finite gap cutoff; null: no such groups
  const std::uint8_t* groupHasGapCutoff = nullptr;
  float perSide = 0;  ///< 1 / increase of the cosine over sameSide at which weights become 1
  /// cosine of the angle between normals below which surfels are across a gap or a sheet. Such surfels do not
  /// repel (stability rows 20 and 22)
  float apart = 0;
  bool plane = false;  ///< SmoothingForm::Plane
  // results: channel c of lane l of group g at (g * channels + c) * 8 + l
  float* overParticles = nullptr;  ///< particleSums channels
  float* overSurfels = nullptr;    ///< sphereSums or planeSums channels
};

/// Sums of displaceSurfels: weights; values times weights; weights of the motion. For the first carryMotion
/// values, particles more molten than the surfel have reduced weights. A solid's surface then moves with the
/// solid, not with separating melt. For temperature and liquid fraction, all particles have full weights.
inline constexpr std::size_t carryValues = 14, carryMotion = 12, carrySums = 2 + carryValues;
/// Factor of the weight of a fully molten particle at a solid surfel.
inline constexpr double leastMotionWeight = 0.02;
struct CarrySums {
  const double* place = nullptr;  ///< m, positions of surfels: three a row
  const float* liquid = nullptr;  ///< 1, liquid fractions of surfels; null: all are liquid
  /// carryRecord doubles per particle, in the order of the bins: x, y, z (m), liquid fraction, values
  const double* particle = nullptr;
  const std::uint32_t* self = nullptr;  ///< as in ForceSums
  const std::uint64_t* firstParticle = nullptr;
  const std::uint32_t* particleRow = nullptr;
  double perSupport2 = 0;  ///< 1/m^2, 1 / h_ps^2
  // fields of the second pass
  /// m: a particle's value at x is values[0..2] + G (x - origin), G = values[3..11] by rows
  double origin[3] = {0, 0, 0};
  /// m, weighted mean of these values at the group's surfels: component a of lane l at 8 a + l
  const double* mean = nullptr;
};
inline constexpr std::size_t carryRecord = 4 + carryValues;
/// Sums of the second pass: (value of a particle - mean) x (surfel - particle) u^2, by rows, u = 1 -
/// (r/h_ps)^2.
inline constexpr std::size_t bendSums = 9;

/// Voronoi cells of eight surfels in their tangent planes (see findSurfelAreas). Records are four doubles.
struct AreaCells {
  const double* place = nullptr;        ///< m, all rows: x, y, z, radius
  const double* normal = nullptr;       ///< all rows: normal, one unused
  const std::uint32_t* self = nullptr;  ///< 8 rows
  /// 8 rows for each of `count` neighbours, in an order that is the same on every rank. Lanes with fewer
  /// neighbours repeat their own surfel
  const std::uint32_t* near = nullptr;
  std::size_t count = 0;
  /// Cosines of angles between normals: below cosFlat a neighbour is across an edge, below cosBack on another
  /// sheet.
  double cosFlat = 0, cosBack = 0;
  /// Result, 8 per neighbour. It increases from 0 to 4 with the direction around the normal. -1: not adjacent
  /// to the cell.
  double* turn = nullptr;
};
/// Largest number of neighbours of AreaCells.
inline constexpr std::size_t mostAreaNeighbours = 24;

/// Number of points on the surface around a surfel.
inline constexpr std::size_t circlePlaces = 24;
struct CirclePlaces {
  const float *cosine, *sine;  ///< directions, relative to the tangent
  float normal[3], tangent[3], across[3];
  float curvature[3];  ///< components tangent-tangent, tangent-across, across-across
  float side;          ///< smallest cosine between the normals of a point and of a disc on its side
};

/// Discs of the surface around a particle, as separate arrays. Seven discs of radius 0 follow the last disc.
struct DiscsAround {
  const float *x, *y, *z, *nx, *ny, *nz, *radius2;  ///< m, 1, m^2
  std::size_t count;
  float most;  ///< m, largest height above or below a position
  float side;  ///< as in CirclePlaces
};

/// Discs of a patch around eight positions.
struct PatchPlaces {
  const double* disc = nullptr;  ///< six per disc: position (m), normal
  std::size_t discs = 0;
  const double* place = nullptr;  ///< m; axis a of lane l at 8 a + l
  double reach2 = 0, back2 = 0;   ///< squared distance (m^2) at which weights vanish, and its inverse (1/m^2)
};
/// Sums of weights (1 - r^2 / reach^2)^3, and of weight x normal . d, weight x normal, weight x d, with d
/// from the disc to the position.
enum PatchSum {
  PatchWeight,
  PatchAlong,
  PatchNormal,
  PatchAway = PatchNormal + 3,
  patchSums = PatchAway + 3
};

/// Box grown by a distance, in floats.
struct NearBox {
  float middle[3], half[3];
  float reach2;  ///< squared distance
};
/// Padding for nearBox, which may read this many positions and write this many words beyond the end.
inline constexpr std::size_t nearBoxMore = 8;

struct SurfaceKernels {
  const char* name;  ///< "avx512", "avx2", "base"
  void (*overParticles)(const ForceSums&);
  void (*overSurfels)(const ForceSums&);
  void (*carry)(const CarrySums&, std::size_t group, double* sums);  ///< channel c of lane l at 8 c + l
  void (*bend)(const CarrySums&, std::size_t group, double* sums);   ///< the second pass
  /// Computes areas (m^2) and squared distances to the farthest corners (m^2), infinite where a neighbour is
  /// across an edge.
  void (*areas)(const AreaCells&, double* area, double* farthest2);
  /// Sets open[k] to 1 if no disc on the side of point k lies within the circle's radius of that point, else
  /// 0. A disc has six floats: position and normal.
  void (*openPlaces)(const CirclePlaces&, const float* disc, std::size_t discs, float* open);
  /// Returns whether a disc of the same orientation lies above, below or beside a position.
  bool (*covered)(const DiscsAround&, const float* place, const float* normal);
  void (*betweenDiscs)(const PatchPlaces&, double* sums);  ///< sum c of lane l at 8 c + l
  /// Lists the positions, of `count`, within the box's distance, ascending. Returns their number.
  std::uint32_t (*nearBox)(const NearBox&, const float* x, const float* y, const float* z,
                           std::uint32_t count, std::uint32_t* found);
};
/// Returns the kernels with this name, or the best kernels for this processor if the name is empty. Returns
/// null for unknown or unsupported names.
const SurfaceKernels* surfaceKernels(const char* name = "");
/// Returns the best kernels for this processor.
const SurfaceKernels& bestSurfaceKernels();

}  // namespace thaw
