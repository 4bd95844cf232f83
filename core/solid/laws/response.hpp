// Energy and stress of a material at one particle: its law, plastic flow and volume force together.
#pragma once
#include "core/math/mat3.hpp"
#include "core/solid/elastic_constants.hpp"

namespace thaw {

struct ElasticResponse {
  double energy = 0;  ///< Pa, energy density of the volume without stress
  Mat3d stress{};     ///< Pa, first Piola stress times the reference volume over the volume without stress
};

/// Of F = 1 + grad u = Fe Fp: psi = psi_law(Fe), P = P_law(Fe) Fp^-T (plasticity.hpp), with plasticInverse =
/// Fp^-1 - 1.
ElasticResponse elasticResponse(const ElasticConstants& c, const Mat3d& gradU, const Mat3d& plasticInverse);
/// The same without plastic flow: of Fe from Fe - 1.
ElasticResponse elasticResponse(const ElasticConstants& c, const Mat3d& gradU);

/// Principal Kirchhoff stresses of these principal elastic stretches, Pa; without the volume force, which has
/// no deviator.
Vec3d principalKirchhoff(const ElasticConstants& c, const Vec3d& stretch);

/// Cauchy stress P F^T / det F, Pa; zero where det F is not positive. Of Fe and P_law(Fe) where there is
/// plastic flow.
Sym3d cauchyStress(const Mat3d& piola, const Mat3d& gradU);

}  // namespace thaw
