// SPDX-License-Identifier: Apache-2.0
// Elastic laws by name, with stress, energy and stiffness. They belong to the library
// (core/solid/laws/laws.hpp) or to extensions (core/terms/extensions.hpp).
#pragma once
#include <array>
#include <functional>
#include <string>
#include <vector>

#include "core/math/mat3.hpp"
#include "core/math/vec3.hpp"
#include "core/solid/laws/law_point.hpp"

namespace thaw {

struct ElasticArrays;
struct ExtensionSettings;
struct Material;

/// Input and output of a law for eight particles of one material, or of materials with equal values. Lanes
/// without a particle have F = 1 and lambda = mu = 0.
struct LawGroup {
  const double (*gradient)[8];  ///< F - 1 by [row][column][lane]; with plastic flow, of the elastic part
  const double *lambda, *mu;    ///< Pa, Lame's constants by lane, at the particle's liquid fraction
  const LawValues& values;
  double (*stress)[8];  ///< Pa, out: first Piola stress by [row][column][lane]
  double* energy;       ///< Pa, out: energy density by lane; null: not needed
  bool single = false;  ///< bonds are in single precision (LawDefaults::doubleStress)
};

/// The loop over bonds that computes deformation and stress of groups.
using LawLoop = void (*)(ElasticArrays&);

/// Functions of a law on one instruction set, from lawKernels<Law>()
/// (core/solid/elasticity/extension_law_lanes.hpp), for THAW_CHOOSE (core/simd/choose.hpp).
struct LawKernels {
  void (*lanes)(const LawGroup&) = nullptr;
  /// The loop with the law inlined, for groups in which all solids have this law. Null: the loop of the
  /// library, which calls `lanes`.
  LawLoop deformation = nullptr;
};

/// Energy density and first Piola stress of one particle, both Pa.
struct LawResponse {
  double energy = 0;
  Mat3d stress{};
};

/// An elastic law, psi(F) with P = dpsi/dF. At rest psi = 0 and P = 0. Small strains follow Hooke's law with
/// lambda and mu, from which step limits are computed. Set either `kernels`, or `response`, which is called
/// for one particle at a time. Laws of the library come from laws.hpp.
struct ElasticLaw {
  LawKernels kernels = {};
  std::function<LawResponse(const Mat3d& gradU, double lambda, double mu, const LawValues&)> response = {};
  /// Principal Kirchhoff stresses (Pa) for principal stretches, for plastic flow. Empty: computed from the
  /// stress of the diagonal F.
  std::function<Vec3d(const Vec3d& stretch, double lambda, double mu, const LawValues&)> principal = {};
  /// Largest tangent modulus, divided by lambda + 2 mu, for squared stretches up to the given one; at
  /// least 1. Empty: 1, for laws that do not stiffen.
  std::function<double(double largestStretch2, const LawValues&)> stiffening = {};
  bool resistsInversion = false;  ///< an inverted particle recovers
  bool boundsStress = false;      ///< as LawDefaults::boundsStress
  int builtIn = -1;  ///< index in BuiltInLaws of a law that the library's loop inlines; -1: law of an
                     ///< extension
};

/// A law with the values of a material. Equal values give the same object.
struct BoundLaw {
  const ElasticLaw* law = nullptr;
  LawValues values{};
};

/// A law of the library, as listed in the registry of extensions.
struct BuiltInLaw {
  std::string name, about;
  std::vector<LawKey> keys;
  ElasticLaw law;
};
/// Returns the laws of the library, in the order of the table in laws.hpp.
const std::vector<BuiltInLaw>& builtInLaws();

/// Makes a law known by its name. keys: names of its keys. Throws std::invalid_argument for a law without
/// `kernels` and `response`, or with more than mostLawKeys keys.
void addElasticLaw(const std::string& name, ElasticLaw law, std::vector<std::string> keys);
/// Returns the law and the values of a material. The reference stays valid. Throws std::invalid_argument if
/// there is no such law.
const BoundLaw& boundLaw(const Material& material);
/// The same for the law's name and values. In laws of the library, keys without a value get their default.
const BoundLaw& boundLaw(const ExtensionSettings& settings);

/// Response for F = 1 + gradU.
LawResponse responseOf(const BoundLaw& bound, const Mat3d& gradU, double lambda, double mu);
/// Principal Kirchhoff stresses (Pa), P F^T of a diagonal F.
Vec3d principalOf(const BoundLaw& bound, const Vec3d& stretch, double lambda, double mu);
/// Replaces values by their natural logarithms.
void takeLogarithmsOfLanes(double values[8]);
/// Sets the stress and energy of all lanes of the group.
void respondGroup(const ElasticLaw& law, const LawGroup& group);

}  // namespace thaw
