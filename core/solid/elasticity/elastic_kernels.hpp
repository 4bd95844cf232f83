// SPDX-License-Identifier: Apache-2.0
// The two bond loops, with one set per instruction set (elastic_isa.cpp). All sets give the same bits. Arrays
// are plain pointers, since code compiled for one instruction set must not emit copies of library functions
// for the linker.
#pragma once
#include <cstddef>
#include <cstdint>

#include "core/math/mat3.hpp"
#include "core/scene/scene.hpp"
#include "core/solid/laws/elastic_constants.hpp"

namespace thaw {

struct ElasticWork;
struct Solids;

/// Input and output of the loops. Real is float or double, by `precision`. Bond arrays are interleaved by 8
/// solids as in Bonds.
struct ElasticArrays {
  Precision precision = Precision::Single;
  bool vectors = false, periodic = false, damping = false, plastic = false, energy = true;
  std::size_t owned = 0, capacity = 0;
  const std::uint32_t* groups = nullptr;
  std::size_t groupCount = 0;
  const std::uint16_t* bondCount = nullptr;
  const std::uint8_t* singularLanes = nullptr;
  const std::uint8_t* ownFrames = nullptr;  ///< by group, as ElasticWork::ownFrames
  const std::uint32_t* neighbour = nullptr;
  /// Arrays of Real; null unless `vectors`.
  const void *x = nullptr, *y = nullptr, *z = nullptr, *rx = nullptr, *ry = nullptr, *rz = nullptr,
             *weight = nullptr;
  void* end = nullptr;           ///< BondEnd<Real> by row; float positions in units of `unit`
  const void* motion = nullptr;  ///< Real, 4 per row: velocity (m/s), drag
  double unit = 1;               ///< m
  double perSupport2 = 1;        ///< 1/m^2, inverse square of the bond support
  double period[3]{};            ///< in units of positions; 0: not periodic
  double dt = 0;
  double breakStretch2 = 0;  ///< square of the stretch above which `stretched` is set; 0: no fracture
  std::uint8_t* stretched = nullptr;
  bool keepDissipated = false;  ///< true: add to `dissipated` instead of overwriting it
  bool flow = true;             ///< plastic strain may change
  // By solid.
  const Sym3d* momentInverse = nullptr;
  const std::uint8_t* rank = nullptr;
  const double *perTrace = nullptr, *perWeight = nullptr, *volume = nullptr;
  Mat3d* plasticInverse = nullptr;
  Mat3d* lastGradient = nullptr;             ///< null: no limit of plastic strain
  const Mat3d* referenceGradient = nullptr;  ///< null: all solids have the first reference
  double* plasticPath = nullptr;             ///< null: no hardening
  std::uint8_t* flows = nullptr;             ///< set where plastic strain changed; null: not needed
  Mat3d* deformation = nullptr;              ///< null: not stored
  double *energyColumn = nullptr, *dragColumn = nullptr, *dissipated = nullptr;
  Vec3d* force = nullptr;
  const ElasticWork* work = nullptr;
  const Solids* solids = nullptr;
  const std::uint8_t* plasticFixed = nullptr;  ///< plastic strain is fixed; null: nowhere
  double* groupStretch2 = nullptr;             ///< by group, as maxStretch2; null: not needed
  const std::uint8_t* passive = nullptr;  ///< 1: energy and deformation do not change, and flux is 0; null:
                                          ///< nowhere
  // Results.
  std::int64_t inverted = 0, softenedParticles = 0;
  double maxStretch2 = 1;
};

/// Constants of the lanes of a group. Data of the material is reused for the next group.
struct alignas(64) LaneConstants {
  // hourglass: k, N/m; drag: kg/s.
  double lambda[8], mu[8], volumeStiffness[8], volume[8], hourglass[8], drag[8];
  double active[8];  // 0: no solid, or a passive one
  ElasticConstants constants[8];
  bool anyVolumeStiffness, anyHourglassYield;
  int laws;                // number of distinct laws in the group
  const BoundLaw* law[8];  // the first `laws` entries are valid, in the order of lanes
  unsigned lanesOf[8];     // bit mask of the lanes of each law
  int material = -1;       // common material of all lanes if all are fully solid; else -1
};

// These functions are out of line, in elastic.cpp.
void loadLaneConstants(const ElasticArrays& a, std::size_t solid0, int n, LaneConstants& out);
/// Applies completeGradient to one lane in place; gradU by [row][column][lane].
void completeLane(const ElasticArrays& a, std::size_t solidIndex, int lane, double gradU[9][8]);
/// Adds stressOfNormal of one flat lane to its flux (V P A^-1 - k grad u).
struct FlatLane {
  const double (*sum)[8], (*gradU)[8], (*stress)[8];
  double (*flux)[8];
};
void addNormalStress(const ElasticArrays& a, const LaneConstants& c, std::size_t solidIndex, int lane,
                     const FlatLane& of);
/// Limits the hourglass stress of one lane (hourglassEnergy). errors: sum w |x - F X|^2 (m^2), then the
/// energy (Pa) beyond that of the reduced stiffness.
void yieldHourglass(const ElasticArrays& a, std::size_t solidIndex, int lane, LaneConstants& c,
                    double (&errors)[8]);
/// Plastic flow of one lane: updates Solids::plasticInverse, records the loss, and returns Fe - 1 and Fp^-1 -
/// 1.
struct PlasticLanes {
  double elastic[9][8], inverse[9][8];
};
void flowLane(const ElasticArrays& a, const ElasticConstants& c, std::size_t solidIndex,
              const double gradU[9][8], int lane, PlasticLanes& out);

struct ElasticKernels {
  const char* name;  ///< "avx512", "avx2", "base"
  void (*deformation)(ElasticArrays&);
  void (*forces)(const ElasticArrays&);
};
/// Returns the set of that name, or the best one for this processor if the name is empty. Returns nullptr for
/// unknown or unsupported names.
const ElasticKernels* elasticKernels(const char* name = "");

}  // namespace thaw
