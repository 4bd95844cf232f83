// Corotated linear elasticity: mu |F - R|^2 + lambda/2 tr(R^T F - 1)^2 with the rotation R nearest to F
// (Mueller & Gross 2004; its invertible form: Irving, Teran, Fedkiw 2004). Linear in stretch, so it neither softens in compression nor stays
// inverted: R is a proper rotation even where det F < 0.
#pragma once
#include "core/math/mat3.hpp"

namespace thaw {

/// The rotation R (det R = +1) that maximises tr(R^T F): of the polar decomposition; where det F < 0 the smallest singular
/// value counts as negative. Any F, zero included.
Mat3d nearestRotation(const Mat3d& f);

/// psi, Pa.
double corotatedEnergy(const Mat3d& f, double lambda, double mu);
/// First Piola stress P = 2 mu (F - R) + lambda tr(R^T F - 1) R, Pa.
Mat3d corotatedStress(const Mat3d& f, double lambda, double mu);

}  // namespace thaw
