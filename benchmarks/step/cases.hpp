// The scenes that the step benchmark measures, and what speed they are held against.
#pragma once
#include <string>
#include <vector>

#include "core/scene/scene.hpp"

namespace thaw::bench {

enum class Kind { Fluid, Heat, Elastic, Mixed, Mesh, Carried };
inline constexpr const char* kindNames[] = {"fluid", "heat", "elastic", "mixed", "mesh", "carried"};
inline bool isElastic(Kind k) { return k == Kind::Elastic || k == Kind::Mesh; }

/// Support radii, in spacings, with which a particle of the jittered block has 33 and 74 neighbours in the
/// mean, free faces included, as the targets count them (2 has 27.6: six of the 33 of the lattice, itself
/// among them, lie on the very edge of the support).
inline constexpr double support33 = 2.13, support74 = 2.6;

/// One measurement. support: of sums and of bonds, in spacings.
struct Case {
  Kind kind = Kind::Fluid;
  Precision precision = Precision::Single, elastic = Precision::Single;  ///< elastic: of bonds
  double support = support33;
  std::size_t particles = 100000;
};

/// A jittered block that flies through an open domain, with a free surface. Fluid: pressure and viscosity.
/// Heat: also conduction. Elastic: Green strain. Mixed: the middle third melts, solid below, liquid above,
/// with latent heat and contact. Mesh: an elastic ball from a file of 100,000 triangles, for its set-up.
Scene sceneOf(const Case& c, const std::string& ball);

/// Times the plain scalar code (benchmarks/support/yardstick.hpp): what counts as excellent, and what
/// prototypes without MPI reached; 0: nothing to compare with. From the figures of one core, over the 1.08
/// (0.61 with 74 neighbours) million particle-steps a second of the scalar code there. There are figures
/// without AVX-512 for liquids in single precision with 33 neighbours only, for any size; other cases keep
/// those with it.
struct Targets {
  double excellent = 0, limit = 0;
};
Targets targetsOf(const Case& c, bool avx512);

/// ns a particle of the prototypes' phases, as times the scalar code's: sort, search, density, forces with
/// leap-frog.
std::vector<double> limitPhases(const Case& c);

}  // namespace thaw::bench
