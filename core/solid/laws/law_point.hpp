// SPDX-License-Identifier: Apache-2.0
// Input of an elastic law, and defaults for optional parts of a law of the library. T is double, or lanes of
// float or double. This file has only plain data, since code that is compiled per instruction set includes
// it.
#pragma once
#include <array>
#include <cmath>
#include <cstddef>

#include "core/math/mat3.hpp"

namespace thaw {

inline constexpr std::size_t mostLawKeys = 8;
/// Values of a law's keys (SI), in the order of their declaration.
using LawValues = std::array<double, mostLawKeys>;

/// A key of a law of the library: a number with a unit.
struct LawKey {
  const char *name, *unit;  ///< unit in SI, "" for none
  double standard, least, most;
  const char* about;
};

/// A deformation gradient F (its elastic part with plastic flow), and the constants of the material.
template<class T> struct LawPoint {
  Mat3<T> f;
  T lambda, mu;  ///< Pa, Lame's constants
  const LawValues& values;
  Mat3<T> gradient;  ///< F - 1: its rounding is small at small strains
};

/// Natural logarithm. For lanes: core/solid/elasticity/law_lanes.hpp.
inline double logarithm(double a) { return std::log(a); }

/// Base of the laws of the library (laws.hpp). Laws of extensions also derive from it if they change a
/// member. A law of the library has `name`, `about`, and
///   template<class T> static Mat3<T> stress(const LawPoint<T>&);  // Pa, first Piola stress
///   template<class T> static T energy(const LawPoint<T>&);        // Pa, energy density
/// and may have
///   template<class T> static auto shared(const LawPoint<T>&);     // given to both as second argument
///   static Vec3d principal(const Vec3d& stretch, double lambda, double mu, const LawValues&);
///   static double stiffening(double largestStretch2, const LawValues&);
///   template<class T> static unsigned softened(const LawPoint<T>&, const Shared&);  // bits of lanes
/// `principal` and `stiffening` are as in ElasticLaw. `softened` returns the lanes that
/// Counters::softenedParticles counts.
struct LawDefaults {
  static constexpr std::array<LawKey, 0> keys{};
  /// true: stress or energy needs double precision even if bonds are in single precision.
  static constexpr bool doubleStress = true, doubleEnergy = true;
  static constexpr bool resistsInversion = false;  ///< an inverted particle returns
  /// true: |dev sigma|/2G is at most |dev E| (1 + (8 + 4 lambda/mu) |E|) for |E| < 0.1, with Green's strain
  /// E. Plastic flow then skips particles that are certainly below the yield stress.
  static constexpr bool boundsStress = false;
};

/// Returns LawDefaults::doubleStress of a law; true for laws without it.
template<class Law> constexpr bool stressInDouble() {
  if constexpr (requires { Law::doubleStress; }) return Law::doubleStress;
  else return true;
}
/// The same for doubleEnergy.
template<class Law> constexpr bool energyInDouble() {
  if constexpr (requires { Law::doubleEnergy; }) return Law::doubleEnergy;
  else return true;
}

struct NoSharedTerms {};
/// Returns the data that stress and energy of a law share.
template<class Law, class T> [[gnu::always_inline]] inline auto sharedOf(const LawPoint<T>& at) {
  if constexpr (requires { Law::shared(at); }) return Law::shared(at);
  else return NoSharedTerms{};
}
template<class Law, class T, class Shared>
[[gnu::always_inline]] inline Mat3<T> stressOf(const LawPoint<T>& at, const Shared& shared) {
  if constexpr (requires { Law::stress(at, shared); }) return Law::stress(at, shared);
  else return Law::stress(at);
}
template<class Law, class T, class Shared>
[[gnu::always_inline]] inline T energyOf(const LawPoint<T>& at, const Shared& shared) {
  if constexpr (requires { Law::energy(at, shared); }) return Law::energy(at, shared);
  else return Law::energy(at);
}

}  // namespace thaw
