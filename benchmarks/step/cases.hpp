// SPDX-License-Identifier: Apache-2.0
// Scenes of the step benchmark and their target rates.
#pragma once
#include <string>
#include <vector>

#include "core/scene/scene.hpp"

namespace thaw::bench {

enum class Kind { Fluid, Heat, Elastic, Mixed, Mesh, Carried };
inline constexpr const char* caseNames[] = {"fluid", "heat", "elastic", "mixed", "mesh", "carried"};
inline bool isElastic(Kind k) { return k == Kind::Elastic || k == Kind::Mesh; }

/// Support radii in spacings that give a particle of the jittered block 33 and 74 neighbours on average, free
/// faces included. A radius of 2 gives 27.6: six of the lattice's 33 lie on the edge of the support.
inline constexpr double support33 = 2.13, support74 = 2.6;

/// One measurement. `support` is that of sums and bonds, in spacings.
struct Case {
  Kind kind = Kind::Fluid;
  Precision precision = Precision::Single, elastic = Precision::Single;  ///< elastic: precision of bonds
  double support = support33;
  std::size_t particles = 100000;
};

/// A jittered block that flies through an open domain, with a free surface. Fluid: pressure and viscosity.
/// Heat: also conduction. Elastic: Green strain. Mixed: solid below, liquid above, a melting third between,
/// with latent heat and contact. Mesh: set-up of an elastic ball from a file of 100,000 triangles.
Scene sceneOf(const Case& c, const std::string& ball);

/// Rates relative to the plain scalar code (benchmarks/support/yardstick.hpp): the target, and an upper
/// bound; 0 if there is none. Rates without AVX-512 exist for liquids in single precision with 33 neighbours
/// only; other cases keep those with AVX-512.
struct Targets {
  double target = 0, limit = 0;
};
Targets targetsOf(const Case& c, bool avx512);

/// Time per particle of the prototypes' phases, relative to the scalar code's: sort, search, density, forces
/// with leap-frog.
std::vector<double> limitPhases(const Case& c);

}  // namespace thaw::bench
