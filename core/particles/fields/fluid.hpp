// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>

#include "core/fields/field_group.hpp"

namespace thaw {

/// Fields of liquids: density, shifting, viscosity, free surface.
struct FluidFields : FieldGroup {
  using FieldGroup::FieldGroup;
  // clang-format off
  Column<float> relativeDensity{table, "relativeDensity", "1", Keep::Transient,
      "relative density: delta = sum V0_j W_ij over its lattice value; density = delta * rest density"};
  Column<double> restDensity{table, "restDensity", "kg/m^3", Keep::State,
      "density at rest, of materials whose phases differ in density"};
  Column<double> compression{table, "compression", "1", Keep::State,
      "carried relative density minus 1; in solids, that of adjacent liquid, else 0"};
  Column<float> compressionRate{table, "compressionRate", "1/s", Keep::State,
      "rate of the relative density in the last step; bulk damping uses it", Rows::Owned};
  Column<Sym3f> midCorrection{table, "midCorrection", "1", Keep::State,
      "inverse of the moment minus 1, at the last mid-step", Rows::Owned};
  Column<Sym3f> correction{table, "correction", "1", Keep::Transient,
      "gradient correction of the pressure, extrapolated to the end of the step"};
  Column<Vec3f> relief{table, "relief", "N", Keep::Transient,
      "force on liquid from all its solid neighbours (core/fluid/laws/lattice_relief.hpp)"};
  Column<Vec3d> shiftingVelocity{table, "shiftingVelocity", "m/s", Keep::State,
      "XSPH and shifting velocity; a particle moves with the sum of this and velocity"};
  Column<Vec3f> concentrationGradient{table, "concentrationGradient", "1", Keep::Transient,
      "concentration gradient times h", Rows::Owned};
  Column<Vec3d> positionForce{table, "positionForce", "N", Keep::State,
      "surface tension and pair forces of extensions; their work on shifting is recorded", Rows::Owned};
  Column<std::uint8_t> atSurface{table, "atSurface", "1", Keep::State,
      "1: at the free surface in the last step (core/fluid/laws/free_surface.hpp)"};
  Column<float> freeSurfaceIndicator{table, "freeSurfaceIndicator", "1", Keep::Transient,
      "free-surface indicator; 1 for a column of particles below a flat surface"};
  Column<double> buoyancy{table, "buoyancy", "1", Keep::State,
      "its relative deficit of density in the last evaluation: its buoyant force over its weight, upwards "
      "(core/terms/buoyant_force.hpp)", Rows::Owned};
  Column<float> viscosityCorrection{table, "viscosityCorrection", "1", Keep::State,
      "factor of the viscosity minus 1 (core/fluid/laws/viscosity_factor.hpp)"};
  Column<float> apparentViscosity{table, "apparentViscosity", "Pa s", Keep::State,
      "viscosity at the shear rate of the last step (core/flow/rheology/)"};
  Column<Vec3d> viscousAcceleration{table, "viscousAcceleration", "m/s^2", Keep::State,
      "from implicit viscosity in the last step; initial guess of the next solve"};
  Column<Vec3d> viscousSearch{table, "viscousSearch", "m/s", Keep::Transient,
      "velocities that the implicit viscosity solver exchanges with ghosts"};
  // clang-format on
};

}  // namespace thaw
