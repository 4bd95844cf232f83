// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>

#include "core/fields/field_group.hpp"

namespace thaw {

/// Fields of surface tension (core/fluid/laws/surface_energy.hpp, core/flow/curvature/).
struct TensionFields : FieldGroup {
  using FieldGroup::FieldGroup;
  // clang-format off
  Column<Vec3d> surfaceGradient{table, "surfaceGradient", "1", Keep::Transient,
      "colour gradient h sum V grad W: points into the liquid at its surface, 0 inside"};
  Column<double> surfaceColour{table, "surfaceColour", "1", Keep::Transient,
      "colour: sum V W over the neighbours"};
  Column<Vec3d> surfaceEnergyByGradient{table, "surfaceEnergyByGradient", "Pa", Keep::Transient,
      "derivative of the surface energy per volume with respect to surfaceGradient"};
  Column<double> surfaceEnergyByColour{table, "surfaceEnergyByColour", "Pa", Keep::Transient,
      "derivative of the surface energy per volume with respect to the colour"};
  Column<float> surfaceTension{table, "surfaceTension", "N/m", Keep::State,
      "surface tension at its temperature"};
  // clang-format on
};

}  // namespace thaw
