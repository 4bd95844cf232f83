// Energy and stress of a material at one particle: its law, plastic strain and volume force together.
#pragma once
#include "core/math/mat3.hpp"
#include "core/solid/elastic_constants.hpp"

namespace thaw {

struct ElasticResponse {
  double energy = 0;  ///< Pa, energy density of the reference configuration
  Mat3d stress{};     ///< Pa, first Piola stress
};

/// Plastic strain eps_p enters every law as an eigenstrain of the Green strain:
///   psi(F, eps_p) = psi_law(F) - eps : C : eps_p + eps_p : C : eps_p / 2,   P = P_law(F) - F C : eps_p.
/// For Green strain this is exactly Hooke's law of eps - eps_p (OBH02); for the other laws it agrees with that where strains
/// are small, stays objective, and forces remain the derivative of the energy.
ElasticResponse elasticResponse(const ElasticConstants& c, const Mat3d& gradU, const Sym3d& plasticStrain);

/// Cauchy stress P F^T / det F, Pa; zero where det F is not positive.
Sym3d cauchyStress(const Mat3d& piola, const Mat3d& gradU);

}  // namespace thaw
