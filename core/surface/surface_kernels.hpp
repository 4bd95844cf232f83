// What is worked out for eight surfels at a time, one set for each instruction set: the sums of an iteration
// over the particles and surfels around them (forces_isa.cpp), how particles carry them along
// (carry_isa.cpp), their own areas (areas_isa.cpp), what lies near a box (near_box_isa.cpp), and the surface
// of a patch (patch_isa.cpp); every set gives the same bits. Only plain pointers here: code compiled for one
// instruction set must not leave copies of library functions to the linker.
#pragma once
#include <cstddef>
#include <cstdint>

namespace thaw {

/// Sums over particles, by channel. u = 1 - (r/h_ps)^2, d from the particle to the surfel in units of the
/// grid's support radius. Near: u with nearSupport (level_table.hpp) in place of h_ps.
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
/// Sums over surfels. Plane: Mean (d) and Moment (d d^T) for the plane of the neighbours; sphere: Height and
/// Normal.
enum SurfelSum {
  Weight,
  Height,
  Normal,
  Mean = Normal,
  Repulsion = Normal + 3,
  Stiffness = Repulsion + 3,
  Stirred,
  Coincident,
  Moment,
  sphereSums = Moment,
  planeSums = Moment + 6
};

/// What the sums read and write. Records are four floats; positions in them are the bits of fixed-point
/// numbers (grid.hpp), lengths are in support radii of the grid. The lists of a group hold what is near any
/// of its eight surfels, in an order that is the same on every rank; what is out of a surfel's reach adds
/// nothing to its sums, so neither the grouping nor the lists' margin changes a bit.
struct ForceSums {
  const float* place = nullptr;     ///< of surfels: x, y, z; 1 if it is moving, else 0
  const float* normal = nullptr;    ///< of surfels: normal, radius
  const float* particle = nullptr;  ///< x, y, z; V c_j over the lattice's sum of weights (level_table.hpp)
  const float* particleColour = nullptr;  ///< V a_j likewise
  const std::uint32_t* self = nullptr;    ///< 8 rows of surfels a group; short groups repeat their first one
  const std::uint64_t *firstSurfel = nullptr, *firstParticle = nullptr;  ///< of each group, and one behind
  const std::uint32_t *surfel = nullptr, *particleRow = nullptr;
  const std::uint32_t* groups = nullptr;  ///< to work on
  std::size_t groupCount = 0;
  float perParticleSupport2 = 0;  ///< 1 / h_ps^2
  float perNearSupport2 = 0;      ///< 1 / nearSupport^2
  float support = 0;              ///< h_ss over a surfel's radius
  float repelRange = 0;           ///< surfels closer than this times the mean of their radii repel each other
  float sameSide = 0;             ///< cosine of the angle of normals up to which neighbours are smoothed over
  const float* ceiling = nullptr;  ///< of surfels: height over their plane from which on particles are across
                                   ///< a gap (gap_ceilings.hpp), or infinity
  const std::uint8_t* ceilingOfGroup = nullptr;  ///< whether a surfel of the group has one; none: null
  float perSide = 0;                             ///< 1 / from there to where they count in full
  float apart = 0;     ///< and from which on they are across a gap or a sheet and do not repel (B20, B22)
  bool plane = false;  ///< SmoothingForm::Plane
  // results: channel c of lane l of group g at (g * channels + c) * 8 + l
  float* overParticles = nullptr;  ///< particleSums channels
  float* overSurfels = nullptr;    ///< sphereSums or planeSums channels
};

/// Sums of displaceSurfels: of the weights, then of what a particle's values are, times the weight, then of
/// the weights of its motion. In the values of the motion (carryMotion of them) what is more molten than the
/// surfel counts less: the surface of a solid goes with the solid, whatever melt tears off it. What the
/// surfel is warmed and melted by are all alike.
inline constexpr std::size_t carryValues = 14, carryMotion = 12, carrySums = 2 + carryValues;
inline constexpr double leastCarry = 0.02;  ///< of its weight, what is molten by 1 beside a surfel that is
                                            ///< not at all
struct CarrySums {
  const double* place = nullptr;        ///< m, of surfels: three a row
  const float* liquid = nullptr;        ///< 1, of surfels; null: all are liquid
  const double* particle = nullptr;     ///< carryRecord doubles a particle, in the order of the bins: x, y, z
                                        ///< (m), liquid fraction, values
  const std::uint32_t* self = nullptr;  ///< as in ForceSums
  const std::uint64_t* firstParticle = nullptr;
  const std::uint32_t* particleRow = nullptr;
  double perSupport2 = 0;  ///< 1/m^2, 1 / h_ps^2
  // of the second pass
  double origin[3] = {0, 0, 0};  ///< m: a particle's value at x is values[0..2] + G (x - origin), G =
                                 ///< values[3..11] by rows
  const double* mean = nullptr;  ///< m, weighted mean of these at the group's surfels: component a of lane l
                                 ///< at 8 a + l
};
inline constexpr std::size_t carryRecord = 4 + carryValues;
/// Sums of the second pass: (value of a particle - mean) x (surfel - particle) u^2, by rows, u = 1 -
/// (r/h_ps)^2.
inline constexpr std::size_t bendSums = 9;

/// Voronoi cells of eight surfels in their tangent planes (findSurfelAreas says among whom). Records are four
/// doubles.
struct AreaCells {
  const double* place = nullptr;        ///< of all rows: x, y, z, radius; m
  const double* normal = nullptr;       ///< normal, one unused
  const std::uint32_t* self = nullptr;  ///< 8 rows
  const std::uint32_t* near = nullptr;  ///< 8 rows each of `count` neighbours in an order that is the same on
                                        ///< every rank; a lane that has fewer repeats itself
  std::size_t count = 0;
  double cosFlat = 0, cosBack = 0;  ///< of the angles of normals between which neighbours are over an edge,
                                    ///< and beyond which on another sheet
  double* turn = nullptr;  ///< result, 8 a neighbour: ascends with the direction to it, from 0 to 4 round the
                           ///< normal; -1: the cell does not border on its
};
/// Most neighbours of AreaCells.
inline constexpr std::size_t mostAreaNeighbours = 24;

/// Places on the surface round a surfel, at a distance that is the unit of length.
inline constexpr std::size_t circlePlaces = 24;
struct CirclePlaces {
  const float *cosine, *sine;  ///< of their directions, from the tangent on
  float normal[3], tangent[3], across[3];
  float curvature[3];  ///< along tangent and tangent, tangent and across, across and across
  float side;          ///< cosine of the angle between normals below which a disc is not of their side
};

/// Discs of the surface around a particle, field by field; behind the last one there are seven of radius 0.
struct DiscsAround {
  const float *x, *y, *z, *nx, *ny, *nz, *radius2;  ///< m, 1, m^2
  std::size_t count;
  float most;  ///< m: what is farther above or below is not asked
  float side;  ///< as in CirclePlaces
};

/// The discs of a patch around eight places.
struct PatchPlaces {
  const double* disc = nullptr;  ///< six a disc: place (m), normal
  std::size_t discs = 0;
  const double* place = nullptr;  ///< m; axis a of lane l at 8 a + l
  double reach2 = 0, back2 = 0;   ///< m^2, square of the distance at which weights end; its inverse
};
/// Sums of weights (1 - r^2 / reach^2)^3, of weight x normal . d, weight x normal, weight x d; d from the
/// disc to the place.
enum PatchSum {
  PatchWeight,
  PatchAlong,
  PatchNormal,
  PatchAway = PatchNormal + 3,
  patchSums = PatchAway + 3
};

/// A box grown by a distance, in floats.
struct NearBox {
  float middle[3], half[3];
  float reach2;  ///< square of the distance
};
/// nearBox reads up to so many places behind the last one, and writes so many words behind the last it finds.
inline constexpr std::size_t nearBoxMore = 8;

struct SurfaceKernels {
  const char* name;  ///< "avx512", "avx2", "base"
  void (*overParticles)(const ForceSums&);
  void (*overSurfels)(const ForceSums&);
  void (*carry)(const CarrySums&, std::size_t group, double* sums);  ///< channel c of lane l at 8 c + l
  void (*bend)(const CarrySums&, std::size_t group, double* sums);   ///< the second pass
  /// Areas (m^2), and the squares of the distances (m^2) to the farthest corners: infinite where a neighbour
  /// is over an edge.
  void (*areas)(const AreaCells&, double* area, double* farthest2);
  /// open[k]: 1 where no disc of the side of place k is within the circle's radius of it, else 0. Discs: six
  /// floats each, place and normal.
  void (*openPlaces)(const CirclePlaces&, const float* disc, std::size_t discs, float* open);
  /// is a disc that faces the same way above, below or beside a place?
  bool (*covered)(const DiscsAround&, const float* place, const float* normal);
  void (*betweenDiscs)(const PatchPlaces&, double* sums);  ///< sum c of lane l at 8 c + l
  /// Those of `count` places nearer to the box than its distance, ascending; returns how many.
  std::uint32_t (*nearBox)(const NearBox&, const float* x, const float* y, const float* z,
                           std::uint32_t count, std::uint32_t* found);
};
/// By name, or the best for this processor where the name is empty. Unknown or unsupported names give
/// nullptr.
const SurfaceKernels* surfaceKernels(const char* name = "");
/// The best for this processor.
const SurfaceKernels& bestSurfaceKernels();

}  // namespace thaw
