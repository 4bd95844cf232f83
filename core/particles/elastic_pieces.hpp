// SPDX-License-Identifier: Apache-2.0
// Rigid pieces consist of rigid materials (core/rigid/), or are parts of elastic solids that do not deform
// (core/rigid/rigidify/). A scene has only one of these two types.
#pragma once
#include "core/particles/continuum.hpp"

namespace thaw {

/// Returns true if pieces are parts of elastic solids. Their particles keep bonds and contact forces.
inline bool piecesAreElastic(const Continuum& p) { return p.piece.active && !p.faceNormal.active; }

/// Returns true if a particle has the impulse contacts of a rigid piece (core/rigid/contact/).
inline bool touchesAsPiece(const Continuum& p, std::size_t i) {
  return isRigid(p, i) && !piecesAreElastic(p);
}

}  // namespace thaw
