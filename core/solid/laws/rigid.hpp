// SPDX-License-Identifier: Apache-2.0
// Solids that do not deform (core/rigid/). Their pieces have no elastic stress and no elastic energy.
#pragma once
#include "core/solid/laws/law_point.hpp"

namespace thaw {

struct RigidLaw : LawDefaults {
  static constexpr const char* name = "rigid";  // as Material::isRigid
  static constexpr const char* about =
      "connected particles move as one rigid body until they melt; `poisson`, `volume_stiffness`, "
      "`hourglass` and `damping` are then not used, and `young` only with `strength`";
  static constexpr bool resistsInversion = true;
  template<class T> static Mat3<T> stress(const LawPoint<T>&) { return {}; }
  template<class T> static T energy(const LawPoint<T>&) { return T(0.0); }
};

}  // namespace thaw
