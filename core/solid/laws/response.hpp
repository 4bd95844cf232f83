// SPDX-License-Identifier: Apache-2.0
// Energy and stress of a material at one particle: law, plastic flow and volume force. Vector form:
// core/solid/elasticity/law_lanes.hpp. To add a law: docs/developer/extend.md.
#pragma once
#include "core/math/mat3.hpp"
#include "core/solid/laws/elastic_constants.hpp"

namespace thaw {

struct ElasticResponse {
  double energy = 0;  ///< Pa, energy per stress-free volume
  Mat3d stress{};     ///< Pa, first Piola stress times reference volume over stress-free volume
};

/// Response for F = 1 + grad u = Fe Fp: psi = psi_law(Fe), P = P_law(Fe) Fp^-T (plasticity.hpp), with
/// plasticInverse = Fp^-1 - 1.
ElasticResponse elasticResponse(const ElasticConstants& c, const Mat3d& gradU, const Mat3d& plasticInverse);
/// As above without plastic flow: Fe from Fe - 1.
ElasticResponse elasticResponse(const ElasticConstants& c, const Mat3d& gradU);

/// Principal Kirchhoff stresses (Pa) for principal elastic stretches. The volume force is excluded, since it
/// has no deviator.
Vec3d principalKirchhoff(const ElasticConstants& c, const Vec3d& stretch);

/// Cauchy stress P F^T / det F (Pa); zero if det F <= 0. With plastic flow, pass Fe and P_law(Fe).
Sym3d cauchyStress(const Mat3d& piola, const Mat3d& gradU);

}  // namespace thaw
