// SPDX-License-Identifier: Apache-2.0
// Packing of the fields of pair sums into records of four values (128-bit loads and a transpose, no gathers).
#pragma once
#include <cstdint>
#include <vector>

#include "core/fluid/pair_sums/pair_sums.hpp"
#include "core/materials/liquid_materials.hpp"
#include "core/neighbours/grid.hpp"
#include "core/particles/continuum.hpp"
#include "core/scene/modules.hpp"

namespace thaw {

/// Parameters that depend on liquid fraction and temperature only.
struct MaterialParameters {
  double viscosity = 0, conductivity = 0;
};

/// Records of all rows and the dummy row behind them; bytes, because they are float or double.
struct PairRecords {
  AlignedVector<std::byte> fixed;   ///< fixed-point positions and V0 / h^3, float; positionVolume of single
                                    ///< precision
  AlignedVector<std::byte> middle;  ///< positionVolume halfway along the last step; only with carried
                                    ///< densities
  AlignedVector<std::uint16_t> coarse[3];  ///< x, y, z for the search (coarsePosition)
  AlignedVector<std::byte> positionVolume, velocityViscosity, pressurePhaseHeat, surface, pressureDiagonal,
      pressureOffDiagonal, surfaceEnergyDerivatives;
  std::vector<double> volumePerMass;         ///< 1/kg, V0 / h^3 over the mass, by material
  std::vector<MaterialParameters> constant;  ///< by material, if constant
};

/// Properties of the run for packing. With Modules::uniform there is no pressurePhaseHeat, and
/// velocityViscosity contains the pressure term instead of the viscosity. With heat, velocityViscosity
/// contains the temperature instead. After the density sums, positionVolume then contains the pressure term
/// instead of the volume.
struct RecordContext {
  const Scene& scene;
  const Modules& modules;
  const CellGrid& grid;
  const std::vector<LiquidMaterial>& liquids;
  int substeps = 1;    ///< substeps of solids in the last step
  double elapsed = 0;  ///< s, last step
};

/// Packs rows [begin, end): positions, volumes, velocities, liquid fraction, temperature and material
/// parameters.
void packRecords(const RecordContext& context, const Continuum& particles, std::size_t begin, std::size_t end,
                 PairRecords& records);

/// Makes room for `rows` rows and the dummy row, which gets zero volume.
void resizeRecords(const RecordContext& context, std::size_t rows, PairRecords& records);

/// Compression energy (J) of a particle with liquid fraction f. With a carried density f is ignored.
double compressionOf(const RecordContext& context, const Continuum& particles, std::size_t row, double f);
/// Compression energy (J) at a given relative density.
double compressionAt(const RecordContext& context, const Continuum& particles, std::size_t row, double f,
                     double relativeDensity);

/// Packs the pressure terms of rows [begin, end) from their relative density. The printed pressure form also
/// packs the volume V0 over relative density. Adds the compression energy of owned rows to
/// Continuum::interaction, except for one liquid (Modules::uniform), where it is computed on demand
/// (core/simulation/sums/stored_energy.hpp).
void packPressure(const RecordContext& context, Continuum& particles, std::size_t begin, std::size_t end,
                  PairRecords& records);

/// Packs the strength of cohesion of rows [begin, end) again after their liquid fractions changed.
void packCohesion(const RecordContext& context, const Continuum& particles, std::size_t begin,
                  std::size_t end, PairRecords& records);

/// Packs Continuum::surfaceEnergyByGradient and surfaceEnergyByColour of rows [begin, end).
void packSurfaceEnergyDerivatives(const RecordContext& context, const Continuum& particles, std::size_t begin,
                                  std::size_t end, PairRecords& records);

/// Makes all rows liquid with pressure terms of 1 Pa and without viscosity, for the relaxation of body
/// packings.
void setUnitPressure(const RecordContext& context, std::size_t rows, PairRecords& records);

/// Call it after setUnitPressure. Sets the pressure terms (Pa) to the excess of the relative density over 1
/// for liquid particles, and to 0 for others. It is used in the relaxation of body packings.
void setExcessPressure(const RecordContext& context, const Continuum& particles, PairRecords& records);

}  // namespace thaw
