// The fields of oriented particles (ST92): one line a field.
#pragma once
#include "core/kinds/kind_rows.hpp"
#include "core/math/quat.hpp"
#include "core/neighbours/grid.hpp"

namespace thaw {

/// Bits of Oriented::flags.
// newborn: until it has its neighbours, within an evaluation; emerging: born within reach of the continuum,
// and not yet out of it
inline constexpr std::uint8_t creased = 1, heldPlace = 2, heldNormal = 4, newborn = 8, emerging = 16;

struct Oriented : KindRows {
  Oriented() : KindRows("oriented") {}
  // clang-format off
  Column<Quat> orientation{*this, "orientation", "1", Keep::State,
      "unit quaternion; the normal is where it turns e_z"};
  Column<Vec3d> spin{*this, "spin", "rad/s", Keep::State, "angular velocity"};
  Column<double> inertia{*this, "inertia", "kg m^2", Keep::State, "of its rotation, about any axis"};
  Column<Vec3d> force{*this, "force", "N", Keep::State,
      "of the last evaluation, without gravity; the next step uses it"};
  Column<Vec3d> torque{*this, "torque", "N m", Keep::State, "the same"};
  Column<Vec3d> external{*this, "external", "N", Keep::State,
      "its part by contact with the continuum and sheets, held over a step; only where there are any"};
  Column<Vec3d> resisting{*this, "resisting", "N", Keep::State,
      "the part of external that takes mechanical energy away: dashpots, friction"};
  Column<std::uint32_t> group{*this, "group", "1", Keep::State,
      "number of the surface that it belongs to: its body's until a weld"};
  Column<std::uint64_t> cutSides{*this, "cutSides", "1", Keep::State,
      "two bits a cut of the scene: 0 not at it, 1 and 2 the sides, which do not act on each other"};
  Column<std::uint8_t> flags{*this, "flags", "1", Keep::State,
      "bits: 1 in a crease, 2 held in place, 4 held in orientation, 16 born in contact"};
  Column<std::uint16_t> anchor{*this, "anchor", "1", Keep::State,
      "number of the anchor that holds it in its body"};
  Column<Vec3d> home{*this, "home", "m", Keep::State, "place at the start, of what is anchored"};
  Column<Quat> homeTurn{*this, "homeTurn", "1", Keep::State, "orientation at the start, of what is anchored"};
  Column<Vec3d> normal{*this, "normal", "1", Keep::Transient, "where the orientation turns e_z"};
  Column<double> stiffness{*this, "stiffness", "1/s^2", Keep::Transient,
      "bound of the square of its fastest frequency"};
  Column<Vec3d> offer{*this, "offer", "m", Keep::Transient, "place of a particle that it would make"};
  Column<std::uint64_t> offerRank{*this, "offerRank", "1", Keep::Transient,
      "what decides between offers: 0 none, else the smallest wins"};
  // of the implicit integrator's solve
  Column<Vec3d> search{*this, "search", "m/s", Keep::Transient,
      "velocities that are multiplied with the stiffness"};
  Column<Vec3d> searchSpin{*this, "searchSpin", "rad/s", Keep::Transient, "the same"};
  // clang-format on
};

/// All of the oriented bodies on one rank.
struct OrientedBodies {
  Oriented rows;
  bool overran = false;  ///< one of this rank's went further in the last step than its forces reach: that is
                         ///< no simulation any more
  CellTable cells;
};

}  // namespace thaw
