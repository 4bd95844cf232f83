// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>

#include "core/fields/field_group.hpp"

namespace thaw {

/// Fields of motion, in all scenes except where noted.
struct MotionFields : FieldGroup {
  using FieldGroup::FieldGroup;
  // clang-format off
  Column<std::uint64_t> id{table, "id", "1", Keep::State,
      "body or emitter number << 40 | number of the sample in it"};
  Column<Vec3d> position{table, "position", "m", Keep::State, "centre"};
  Column<Vec3d> velocity{table, "velocity", "m/s", Keep::State, "at the same time as the position"};
  Column<Vec3d> acceleration{table, "acceleration", "m/s^2", Keep::State,
      "from the last force evaluation; the next half kick uses it", Rows::Owned};
  Column<Vec3d> fastAcceleration{table, "fastAcceleration", "m/s^2", Keep::State,
      "part that substeps apply: bonds, and contacts of solids with walls", Rows::Owned};
  Column<Vec3d> stepMeanVelocity{table, "stepMeanVelocity", "m/s", Keep::State,
      "mean velocity over the step, of particles with substeps"};
  Column<double> mass{table, "mass", "kg", Keep::State, "constant, except in liquids that evaporate"};
  Column<std::uint16_t> material{table, "material", "1", Keep::State, "index into the scene's materials"};
  Column<std::uint16_t> body{table, "body", "1", Keep::State, "index into bodies, then emitters"};
  Column<std::uint8_t> phase{table, "phase", "1", Keep::State,
      "Solid: has or may have bonds; Liquid: has none"};
  Column<std::uint8_t> clamped{table, "clamped", "1", Keep::State,
      "1: fixed until it melts; 2: driven by its emitter at constant velocity; 3: part of a rigid piece with "
      "fixed particles"};
  Column<std::uint64_t> cell{table, "cell", "1", Keep::Local,
      "key of the cell at the last sort", Rows::Owned};
  GuestColumn<std::uint64_t> nextCell{table, "nextCell", "1", Keep::Local,
      "key of the current cell, valid from the drift to the sort; shares the memory of "
      "`dissipation`", Rows::Owned};
  Column<Vec3d> unwrappedPosition{table, "unwrappedPosition", "m", Keep::Transient,
      "position without the shift of periodic images; only with periodic sides"};
  GuestColumn<Vec3d> force{table, "force", "N", Keep::Transient,
      "sum of all forces; shares the memory of `acceleration` where possible, until the kick converts it "
      "(forceOf, core/simulation/time/integrate.hpp)", Rows::Owned};
  Column<Vec3d> outsideForce{table, "outsideForce", "N", Keep::State,
      "part of the force that the program adds (core/terms/outside_forces.hpp)", Rows::Owned};
  Column<double> dissipation{table, "dissipation", "W", Keep::Transient,
      "rate of mechanical energy loss at this particle", Rows::Owned};
  Column<double> dissipated{table, "dissipated", "J", Keep::State,
      "mechanical energy lost at this particle so far", Rows::Owned};
  Column<double> interaction{table, "interaction", "J", Keep::State,
      "potential energy of pair and wall contacts, this particle's half; migrates with the particle, also "
      "right after a restart", Rows::Owned};
  // clang-format on
};

}  // namespace thaw
