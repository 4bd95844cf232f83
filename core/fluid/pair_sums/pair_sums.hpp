// SPDX-License-Identifier: Apache-2.0
// Sums over unbonded neighbours. The summand is a pure function of two particles' records
// (pair_sums_isa.cpp). One driver loops over groups of eight particles. Each lane adds its own neighbours in
// (cell, id) order.
#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/kernels/viscous_weight.hpp"
#include "core/math/mat3.hpp"
#include "core/math/vec3.hpp"
#include "core/neighbours/neighbour_lists.hpp"
#include "core/scene/scene.hpp"

namespace thaw {

struct CarryStep;

/// Share of no-slip walls in the sums of a particle.
struct WallShare {
  float density = 0, shear = 0;  ///< 1, as in WallIntegrals
};

struct GroupRange {
  std::size_t begin, end;
};

/// Two solid particles closer than the contact distance; `own` is an owned row.
struct ClosePair {
  std::uint32_t own, other;
};
struct ClosePairs {
  std::vector<ClosePair> list;
  /// This function is out of line for the reason given in neighbour_lists.hpp.
  static void append(ClosePairs& pairs, std::uint32_t own, std::uint32_t other);
};

/// Temperature (K) that marks the dummy row if records hold no volume, for one liquid (Modules::uniform) with
/// heat.
inline constexpr double dummyTemperature = -1e30;
/// Pressure term (Pa) of the dummy row in records of a carried density.
inline constexpr double dummyPressure = -1e24;

/// Input and output of the pair sums. Records are four values per row, float or double by `precision`, for
/// all owned and ghost rows and the dummy row behind them. Lengths in records are in support radii h.
struct PairSums {
  const NeighbourLists* lists = nullptr;
  KernelKind kernel = KernelKind::WendlandC2;
  Precision precision = Precision::Single;
  PairForm pressureForm = PairForm::Consistent;
  ViscosityForm viscosityForm = ViscosityForm::Pairwise;
  bool viscous = true;          ///< forces include viscosity; false if it is solved implicitly
  ViscousWeight viscousWeight;  ///< for the pairwise form
  bool printedTension = false;  ///< colour field as in K05 instead of pair cohesion
  /// One liquid (Modules::uniform) has no pressurePhaseHeat records. The fourth value of velocityViscosity is
  /// the pressure term. With heat it is the temperature, and the fourth value of positionVolume becomes the
  /// pressure term. With a carried density it is the compression until the pressure is packed. A negative
  /// volume marks the free surface. The sum of forces overwrites its results; the other terms add to theirs.
  bool uniform = false;
  double volume = 0;                                       ///< V0 / h^3 of all particles of that liquid
  double viscosity = 0, conductivity = 0, artificial = 0;  ///< Pa s, W/(m K), Pa s, of that liquid;
                                                           ///< artificial = 0: no artificial viscosity
  bool heat = false;                                       ///< forces include heat conduction
  double conductionScale = 1;       ///< factor of heat conduction (kernels/lattice.hpp)
  double support = 0;               ///< h, m
  double relativeDensityScale = 0;  ///< 1/m^3, SumScales::inverseLatticeSum / h^3
  double selfExcess = 0;  ///< subtracted from a particle's relative density, per V0 / h^3 of its own
  const void* positionVolume = nullptr;     ///< x, y, z (fixed point in single precision), V0 / h^3 (V / h^3
                                            ///< with the printed pressure)
  const void* velocityViscosity = nullptr;  ///< velocity (m/s), viscosity (Pa s)
  /// Four values: pressure term (Pa), liquid fraction f, temperature (K), conductivity (W/(m K)). The
  /// pressure term is f p / (relative density)^2, or f p with the printed pressure. In sums of densities it
  /// is the carried compression in units of stiffness, and f is negative at the free surface.
  const void* pressurePhaseHeat = nullptr;
  const void* surface = nullptr;  ///< square root of the liquid's surface tension (N/m)^1/2; 1 if solid, else
                                  ///< 0; artificial viscosity (Pa s); XSPH factor
  double closeDistance = 0;       ///< for closePairs, in support radii
  double freeSurfaceIndicatorScale = 0;  ///< m, scale of the free-surface indicator
  // Results, added to owned rows (float results are overwritten).
  float* relativeDensity = nullptr;
  Vec3d* force = nullptr;                          ///< N
  double* heatFlow = nullptr;                      ///< W
  double* dissipation = nullptr;                   ///< W
  double* interaction = nullptr;                   ///< J, half of each pair's potential energy
  float* freeSurfaceIndicator = nullptr;           ///< 1
  const void* surfaceEnergyDerivatives = nullptr;  ///< records of surface_energy.hpp: derivatives of the
                                                   ///< surface energy with respect to gradient and colour, Pa
  Vec3d* surfaceGradient = nullptr;                ///< 1 (overwritten)
  double* surfaceColour = nullptr;                 ///< 1 (overwritten)
  /// Pressure tensors (Pa): xx yy zz and xy xz yz. Uniform: pressureDiagonal is zz xy xz yz; positionVolume
  /// has xx as its fourth value, velocityViscosity yy.
  const void *pressureDiagonal = nullptr, *pressureOffDiagonal = nullptr;
  bool carried = false;                    ///< liquids carry their density
  const CarryStep* carry = nullptr;        ///< with `carried`: density sums advance the carried densities
  Vec3f* concentrationGradient = nullptr;  ///< 1, h times the gradient of the relative density, with summed
                                           ///< densities; null: not needed
  float* viscosityCorrection = nullptr;    ///< 1, viscosityFactor() minus 1
  const WallShare* viscosityWalls = nullptr;  ///< by owned row; null: no walls
  double largestViscosityFactor = 1;
  bool relief = false;        ///< records have forces of core/fluid/laws/lattice_relief.hpp
  Vec3d* smoothed = nullptr;  ///< m/s, velocity change by XSPH
  // Incompressible solver (terms/incompressible.hpp); all overwritten.
  const Sym3f* correction = nullptr;  ///< 1, inverse of the moment minus 1; null: gradients are not corrected
  Vec3d* impulse = nullptr;       ///< N s, of impulse; for response the gradient of the relative density, 1/m
  double* compression = nullptr;  ///< 1/s, of compression
  Sym3d* moment = nullptr;        ///< 1, of response
  Sym3d* otherResponse = nullptr;      ///< 1/(m^2 kg), of response: contribution of the neighbours
  std::int64_t* coincident = nullptr;  ///< counts particles at the position of another particle
};

/// Velocity (m/s) for the viscous operator, with the particle's viscosity (Pa s) and liquid fraction; the
/// size of four doubles.
struct alignas(32) ViscousRecord {
  double x = 0, y = 0, z = 0;
  float viscosity = 0, liquid = 0;
};

/// Start: also the diagonal blocks; Apply: the operator only; Force: also the dissipation.
enum class ViscousPass { Start, Apply, Force };

/// Input and output of the viscous operator of the implicit solver, besides PairSums::positionVolume. Rows
/// without liquid neighbours are not written.
struct ViscousSums {
  ViscousPass pass = ViscousPass::Apply;
  const ViscousRecord* velocity = nullptr;  ///< all rows and the dummy
  const ViscousRecord* middle = nullptr;  ///< m/s, velocities at which the force dissipates energy; only with
                                          ///< Force
  Vec3d* result = nullptr;                ///< N, minus the viscous force for these velocities; overwritten
  Sym3d* block = nullptr;                 ///< kg/s, diagonal block; overwritten by Start
  double* lost = nullptr;                 ///< W, dissipation, added by Force
};

}  // namespace thaw
