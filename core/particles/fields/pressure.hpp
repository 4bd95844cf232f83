// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>

#include "core/fields/field_group.hpp"

namespace thaw {

/// Fields of incompressible liquids (core/flow/incompressible/).
struct PressureFields : FieldGroup {
  using FieldGroup::FieldGroup;
  // clang-format off
  Column<float> densityPressure{table, "densityPressure", "Pa", Keep::State,
      "density pressure (DFSPH) of the next step, over the step; initial guess of the next solve"};
  Column<float> divergencePressure{table, "divergencePressure", "Pa", Keep::State,
      "divergence pressure (DFSPH) of the last step, over the step; initial guess of the next solve"};
  Column<Vec3d> pressureImpulse{table, "pressureImpulse", "m/s", Keep::State,
      "velocity change due to the density pressure, added at the start of the next step"};
  Column<Vec3d> drag{table, "drag", "N", Keep::Transient,
      "dissipative part of the force: viscosity, drag of walls"};
  Column<float> trialPressure{table, "trialPressure", "Pa s", Keep::Transient,
      "pressure of the current iteration times the step"};
  Column<Vec3d> trialVelocity{table, "trialVelocity", "m/s", Keep::Transient,
      "velocity that follows from trialPressure"};
  // clang-format on
};

}  // namespace thaw
