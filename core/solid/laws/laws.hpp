// SPDX-License-Identifier: Apache-2.0
// The table of elastic laws of the library. Its rows are compiled into the bond loops
// (core/solid/elasticity/elastic_isa.cpp). They are also entered into the registry of extensions
// (core/terms/extensions.hpp), which scenes, documents, checks and restarts use.
// To add a law: docs/developer/extend.md.
#pragma once
#include "core/solid/laws/corotated.hpp"
#include "core/solid/laws/green.hpp"
#include "core/solid/laws/neo_hookean.hpp"
#include "core/solid/laws/rigid.hpp"

namespace thaw {

template<class... Laws> struct LawList {
  /// Calls f.template operator()<Law>() for the law at this index. Returns false if there is none.
  template<class F> [[gnu::always_inline]] static inline bool at(int place, F&& f) {
    int k = 0;
    return ((place == k++ ? (f.template operator()<Laws>(), true) : false) || ...);
  }
  /// Calls f.template operator()<Law>() for each law in order.
  template<class F> static void each(F&& f) { (f.template operator()<Laws>(), ...); }
};

// clang-format off
using BuiltInLaws = LawList<
    GreenLaw,
    NeoHookeanLaw,
    CorotatedLaw,
    RigidLaw>;
// clang-format on

}  // namespace thaw
