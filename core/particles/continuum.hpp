// SPDX-License-Identifier: Apache-2.0
// The table of continuum particles (K05). Its fields are declared in core/particles/fields/, each once. A
// scene activates the fields of the modules that it uses.
#pragma once
#include <memory>
#include <string_view>
#include <vector>

#include "core/fields/added_column.hpp"
#include "core/fields/column.hpp"
#include "core/particles/fields/contact.hpp"
#include "core/particles/fields/fluid.hpp"
#include "core/particles/fields/heat.hpp"
#include "core/particles/fields/motion.hpp"
#include "core/particles/fields/pressure.hpp"
#include "core/particles/fields/rigid.hpp"
#include "core/particles/fields/solid.hpp"
#include "core/particles/fields/surface.hpp"
#include "core/particles/fields/tension.hpp"

namespace thaw {

inline constexpr std::uint32_t noSolid = 0xffffffffu;

enum Phase : std::uint8_t { Solid = 0, Liquid = 1 };

inline constexpr std::uint8_t fixedInPlace = 1, driven = 2,
                              fixedByPiece = 3;  ///< values of Continuum::clamped

inline constexpr std::uint64_t notRigid = 0;  ///< value of Continuum::piece

inline constexpr double atFracture = -1;  ///< value of Continuum::touchTime

struct Continuum : Table,
                   MotionFields,
                   FluidFields,
                   PressureFields,
                   TensionFields,
                   HeatFields,
                   SolidFields,
                   RigidFields,
                   ContactFields,
                   SurfaceFields {
  Continuum();

  /// Fields of extensions, the last of `columns`.
  std::vector<std::unique_ptr<AddedColumn>> added;
  /// Declares the added fields of another table that this one lacks.
  void declareLike(const Continuum& other) {
    for (std::size_t k = added.size(); k < other.added.size(); k++)
      added.push_back(std::make_unique<AddedColumn>(*this, *other.added[k]));
  }
  /// Returns the added field of that name, or null.
  AddedColumn* addedField(std::string_view name) const {
    for (const auto& c : added)
      if (name == c->name) return c.get();
    return nullptr;
  }
};

inline Continuum::Continuum()
    : Table("continuum"),
      MotionFields(this),
      FluidFields(this),
      PressureFields(this),
      TensionFields(this),
      HeatFields(this),
      SolidFields(this),
      RigidFields(this),
      ContactFields(this),
      SurfaceFields(this) {}

/// Returns true if a particle belongs to a rigid piece.
inline bool isRigid(const Continuum& p, std::size_t i) { return p.piece.active && p.piece[i] != notRigid; }

/// Returns true if a particle takes substeps (core/simulation/solid_substeps.hpp). Particles that melted or
/// froze at the end of the last step have no bonds and take none.
inline bool takesSubsteps(const Continuum& p, std::size_t i) {
  return p.solidIndex[i] != noSolid && p.phase[i] == Solid && !(p.justFrozen.active && p.justFrozen[i]);
}

}  // namespace thaw
