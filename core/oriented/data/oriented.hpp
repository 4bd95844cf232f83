// SPDX-License-Identifier: Apache-2.0
// Fields of oriented particles (ST92), one per line.
#pragma once
#include "core/math/quat.hpp"
#include "core/neighbours/grid.hpp"
#include "core/particles/body_type_rows.hpp"

namespace thaw {

/// Bits of Oriented::flags.
// newborn: created in this evaluation, not yet in neighbour lists; emerging: born within reach of the
// continuum, and not yet separated from it
inline constexpr std::uint8_t creased = 1, fixedPosition = 2, fixedOrientation = 4, newborn = 8,
                              emerging = 16;

struct Oriented : BodyTypeRows {
  Oriented() : BodyTypeRows("oriented") {}
  // clang-format off
  Column<Quat> orientation{*this, "orientation", "1", Keep::State,
      "unit quaternion; it rotates e_z to the normal"};
  Column<Vec3d> spin{*this, "spin", "rad/s", Keep::State, "angular velocity"};
  Column<double> inertia{*this, "inertia", "kg m^2", Keep::State, "moment of inertia about any axis"};
  Column<Vec3d> force{*this, "force", "N", Keep::State,
      "force of the last evaluation without gravity, used by the next step"};
  Column<Vec3d> torque{*this, "torque", "N m", Keep::State, "torque of the last evaluation"};
  Column<Vec3d> external{*this, "external", "N", Keep::State,
      "contact force of the continuum and sheets, constant over a step"};
  Column<Vec3d> dissipativeForce{*this, "dissipativeForce", "N", Keep::State,
      "dissipative part of external: dashpots and friction"};
  Column<std::uint32_t> group{*this, "group", "1", Keep::State,
      "number of its surface, that of its body until a weld"};
  Column<std::uint64_t> cutSides{*this, "cutSides", "1", Keep::State,
      "two bits per cut of the scene: 0 away from it, 1 and 2 its sides, which do not interact"};
  Column<std::uint8_t> flags{*this, "flags", "1", Keep::State,
      "bits: 1 creased, 2 fixed position, 4 fixed orientation, 16 born in contact"};
  Column<std::uint16_t> constraint{*this, "constraint", "1", Keep::State,
      "index of its constraint in its body"};
  Column<Vec3d> restPosition{*this, "restPosition", "m", Keep::State,
      "initial position of constrained particles"};
  Column<Quat> restOrientation{*this, "restOrientation", "1", Keep::State,
      "initial orientation of constrained particles"};
  Column<Vec3d> normal{*this, "normal", "1", Keep::Transient, "e_z rotated by the orientation"};
  Column<double> stiffness{*this, "stiffness", "1/s^2", Keep::Transient,
      "bound of its squared angular frequency"};
  Column<Vec3d> candidate{*this, "candidate", "m", Keep::Transient, "displacement to the candidate particle"};
  Column<std::uint64_t> candidatePriority{*this, "candidatePriority", "1", Keep::Transient,
      "priority of the candidate: 0 none, else the smallest wins"};
  // columns of the implicit solver
  Column<Vec3d> search{*this, "search", "m/s", Keep::Transient, "velocities to multiply by the stiffness"};
  Column<Vec3d> searchSpin{*this, "searchSpin", "rad/s", Keep::Transient,
      "angular velocities to multiply by the stiffness"};
  // clang-format on
};

/// The oriented bodies on one rank.
struct OrientedBodies {
  Oriented rows;
  bool exceededReach = false;  ///< in the last step, a row of this rank moved farther than the range of its
                               ///< forces: the simulation has failed
  CellTable cells;
};

}  // namespace thaw
