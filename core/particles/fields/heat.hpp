// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>

#include "core/fields/field_group.hpp"

namespace thaw {

/// Fields of heat, melting and freezing.
struct HeatFields : FieldGroup {
  using FieldGroup::FieldGroup;
  // clang-format off
  Column<double> enthalpy{table, "enthalpy", "J/kg", Keep::State,
      "0 at the solidus; at 0 K for materials that do not melt"};
  Column<double> temperature{table, "temperature", "K", Keep::State,
      "function of the enthalpy; a state variable of its own in the paper's heat model"};
  Column<double> heatFlow{table, "heatFlow", "W", Keep::Transient,
      "sum of all heat flows into the particle", Rows::Owned};
  Column<float> conductionCorrection{table, "conductionCorrection", "1", Keep::State,
      "factor of the conductivity minus 1 (core/heat/conduction_correction.hpp)"};
  Column<float> exposedArea{table, "exposedArea", "1", Keep::Transient,
      "area of the free surface in units of spacing^2 (core/heat/exposed_area.hpp)"};
  Column<float> absorbed{table, "absorbed", "W", Keep::State,
      "power of lamps, lasers and heated regions into the particle", Rows::Owned};
  Column<Vec3f> contactNormal{table, "contactNormal", "1", Keep::Transient,
      "normal of its contact with other bodies, away from them; 0: no contact (core/heat/contact_heat.hpp)"};
  Column<Vec3f> volumeGradient{table, "volumeGradient", "1", Keep::Transient,
      "spacing times the gradient of the neighbours' volume fraction: points into the body at its surface"};
  Column<double> vapour{table, "vapour", "kg", Keep::State,
      "mass that leaves it as vapour at the start of the next step", Rows::Owned};
  Column<double> vapourEnergy{table, "vapourEnergy", "J", Keep::State,
      "potential energy of pairs that leaves with it", Rows::Owned};
  Column<float> mushRate{table, "mushRate", "1/s", Keep::State,
      "rate at which the drag of a mush stops it relative to solidVelocity; 0: none", Rows::Owned};
  Column<Vec3d> solidVelocity{table, "solidVelocity", "m/s", Keep::State,
      "mean velocity of solid neighbours of a liquid in a mush", Rows::Owned};
  Column<float> liquid{table, "liquid", "1", Keep::State, "liquid fraction; blend parameter of the material"};
  Column<double> softening{table, "softening", "J", Keep::Transient,
      "d(compression and tension of all)/d(liquid fraction of this particle) at fixed positions; only where "
      "a material melts", Rows::Owned};
  // clang-format on
};

}  // namespace thaw
