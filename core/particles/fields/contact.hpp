// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>

#include "core/fields/field_group.hpp"

namespace thaw {

/// Fields of contacts with walls, other bodies and sheets. The owner of a particle computes its contact with
/// sheets (face_contact.hpp).
struct ContactFields : FieldGroup {
  using FieldGroup::FieldGroup;
  // clang-format off
  Column<float> contactOffset{table, "contactOffset", "1", Keep::State,
      "contact offset: distance from a wall, in spacings, at which a solid rests; below 1/2 if it froze "
      "closer"};
  Column<float> contactDepth{table, "contactDepth", "1", Keep::State,
      "depth below the surface of its body at the start, in spacings, at most 1/2; 0: 1/2"};
  Column<float> wallOffset{table, "wallOffset", "1", Keep::State,
      "distance from a wall, in spacings, at which the present contact begins; 0: no contact", Rows::Owned};
  Column<Vec3f> wallShear{table, "wallShear", "m", Keep::State,
      "displacement of the friction spring to obstacles", Rows::Owned};
  Column<float> contactRest{table, "contactRest", "1", Keep::State,
      "sum over the solids of other bodies at which contact with them begins; 0: not known yet "
      "(core/contact/body_contact.hpp)", Rows::Owned};
  Column<Vec3d> contactShear{table, "contactShear", "m", Keep::State,
      "displacement of the friction spring to other bodies", Rows::Owned};
  Column<Mat3f> bodyContact{table, "bodyContact", "m^2 J J, J, J", Keep::Transient,
      "contact with other bodies: factors of its forces; friction of its spring and of its dashpot"};
  Column<std::uint32_t> sheetFace{table, "sheetFace", "1", Keep::Transient,
      "1 + number of the sheet triangle with the deepest overlap; 0: no contact"};
  Column<Vec3d> sheetNormalForce{table, "sheetNormalForce", "N, N, N/m", Keep::Transient,
      "force along the gradient of its depth in the sheet, its dissipative part, and their derivative, for a "
      "triangle at a depth of 1 (face_contact.cpp)"};
  Column<Mat3d> sheetFriction{table, "sheetFriction", "N", Keep::Transient,
      "friction on the corners of the sheet triangle in contact, one row each"};
  Column<Vec3d> sheetContactData{table, "sheetContactData", "J, W/K, K", Keep::Transient,
      "energy and conductance to the sheet for a triangle at a depth of 1, and temperature of the particle"};
  // clang-format on
};

}  // namespace thaw
