// Pairs of which one or both lie in a crease (ST92).
#pragma once
#include "core/oriented/pair_potential.hpp"

namespace thaw {

/// Energy, force and torque on i. A creased particle has no plane of its own: it keeps to the planes of its
/// neighbours beside the crease, on both sides, and so to where these meet; and its normal follows theirs
/// weakly (a tenth of co-normality). No co-circularity, no test of facing.
PairResult creasedPair(const PairPotential& p, const Vec3d& r, const Vec3d& ni, const Vec3d& nj,
                       bool iCreased, bool jCreased);

}  // namespace thaw
