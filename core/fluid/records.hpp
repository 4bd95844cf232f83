// Packs the fields that pair sums read into records of four values (128-bit loads and a transpose, no
// gathers).
#pragma once
#include <cstdint>
#include <vector>

#include "core/fluid/liquid_materials.hpp"
#include "core/fluid/pair_sums.hpp"
#include "core/neighbours/grid.hpp"
#include "core/particles/continuum.hpp"
#include "core/scene/modules.hpp"

namespace thaw {

/// Parameters that depend on the liquid fraction and temperature only.
struct MaterialParameters {
  double viscosity = 0, conductivity = 0;
};

/// Records of all rows and the dummy behind them; bytes, because they are float or double.
struct PairRecords {
  AlignedVector<std::byte> fixed;  ///< fixed-point positions and V0 / h^3, float: place in single precision
  AlignedVector<std::uint16_t> coarse[3];  ///< x, y, z for the search (coarsePlace)
  AlignedVector<std::byte> place, motion, state, surface, diagonal, mixed, pull;
  std::vector<double> volumePerMass;         ///< 1/kg, V0 / h^3 over the mass, by material
  std::vector<MaterialParameters> constant;  ///< by material, of those that do not change
};

/// What packing needs to know of the run. With Modules::uniform there is no state, and motion gets the
/// pressure term in place of the viscosity; with heat it gets the temperature, and place the pressure term in
/// place of the volume, once the densities are found.
struct RecordContext {
  const Scene& scene;
  const Modules& modules;
  const CellGrid& grid;
  const std::vector<LiquidMaterial>& liquids;
  int substeps = 1;  ///< substeps of solids in the last step
};

/// Packs rows [begin, end): positions, volumes, velocities, liquid fraction, temperature and material
/// parameters.
void packRecords(const RecordContext& context, const Continuum& particles, std::size_t begin, std::size_t end,
                 PairRecords& records);

/// Room for `rows` rows and the dummy, which gets zero volume.
void resizeRecords(const RecordContext& context, std::size_t rows, PairRecords& records);

/// Compression energy (J) of a particle with liquid fraction f. With a carried density f is ignored.
double compressionOf(const RecordContext& context, const Continuum& particles, std::size_t row, double f);

/// Pressure of rows [begin, end) from their filling, into the state records (with the printed pressure
/// form also the volume V0 / filling); adds the energy of compression to Continuum::interaction of those that
/// are owned, but where all is one liquid (Modules::uniform): there it is found when it is asked for
/// (core/stored_energy.hpp).
void packPressure(const RecordContext& context, Continuum& particles, std::size_t begin, std::size_t end,
                  PairRecords& records);

/// Continuum::surfacePull and surfaceDraw of rows [begin, end).
void packSurfacePull(const RecordContext& context, const Continuum& particles, std::size_t begin,
                     std::size_t end, PairRecords& records);

/// Pressure terms of 1 Pa, all liquid, no viscosity: for the packing of bodies.
void setUnitPressure(const RecordContext& context, std::size_t rows, PairRecords& records);

/// Pressure terms (Pa) after that: what the filling of a liquid particle has above 1; nothing for others. For
/// the settling of bodies.
void setExcessPressure(const RecordContext& context, const Continuum& particles, PairRecords& records);

}  // namespace thaw
