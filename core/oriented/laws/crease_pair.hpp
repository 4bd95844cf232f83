// SPDX-License-Identifier: Apache-2.0
// Potential of pairs with creased particles (ST92).
#pragma once
#include "core/oriented/laws/pair_potential.hpp"

namespace thaw {

/// Returns energy, force and torque on i. A creased particle has no plane of its own. It stays in the
/// planes of its neighbours on both sides of the crease. Its normal follows their normals with a tenth of
/// co-normality. Co-circularity and the facing test are off.
PairResult creasedPair(const PairPotential& p, const Vec3d& r, const Vec3d& ni, const Vec3d& nj,
                       bool iCreased, bool jCreased);

}  // namespace thaw
