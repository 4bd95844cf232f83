// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>

#include "core/fields/field_group.hpp"

namespace thaw {

/// Fields of rigid pieces (core/rigid/).
struct RigidFields : FieldGroup {
  using FieldGroup::FieldGroup;
  // clang-format off
  Column<std::uint64_t> piece{table, "piece", "1", Keep::State,
      "rigid piece: 1 + smallest id of its particles; 0: none"};
  Column<Vec3d> bodyPosition{table, "bodyPosition", "m", Keep::State,
      "position in the body frame of its piece", Rows::Owned};
  Column<std::uint32_t> pieceRow{table, "pieceRow", "1", Keep::Local, "row of its piece on this rank"};
  Column<std::uint64_t> setLabel{table, "setLabel", "1", Keep::Transient,
      "smallest label found so far in its set of connected rows (core/halo/spread_labels.hpp)"};
  Column<std::uint8_t> exposed{table, "exposed", "1", Keep::State,
      "1: rigid particle that the initial surface may no longer cover; only with a surface", Rows::Owned};
  Column<Vec3f> faceNormal{table, "faceNormal", "1", Keep::State,
      "surface of its rigid piece: normal, or vector to a sharp edge (surface_element.hpp); body frame"};
  Column<float> faceOffset{table, "faceOffset", "m", Keep::State,
      "distance from the surface of its rigid piece; 0: inside, so it has no contacts"};
  Column<float> faceRadius{table, "faceRadius", "m", Keep::State,
      "radius of curvature of the surface of its rigid piece; infinite: plane; its offset: round; negative: "
      "code of a sharp edge (core/rigid/contact/edge_code.hpp)"};
  Column<double> touchTime{table, "touchTime", "s", Keep::State,
      "time for which a hot surface particle has touched another hot piece of its material; -1: at a "
      "fracture that has been hot since; only with welding of rigid pieces"};
  Column<std::uint64_t> contactPartner{table, "contactPartner", "1", Keep::State,
      "rigid piece or obstacle that pressed on it most in the last step; 0: none", Rows::Owned};
  Column<Vec3d> contactImpulse{table, "contactImpulse", "N s", Keep::State,
      "impulse of that contact; first guess of the next solve", Rows::Owned};
  Column<Vec3d> rollingImpulse{table, "rollingImpulse", "N m s", Keep::State,
      "angular impulse of that contact by rolling friction; first guess of the next solve", Rows::Owned};
  // clang-format on
};

}  // namespace thaw
