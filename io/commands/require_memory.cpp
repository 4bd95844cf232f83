#include "io/commands/require_memory.hpp"

#include <fmt/format.h>
#include <mpi.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <stdexcept>
#include <string>

#include "core/setup/expected_particles.hpp"

namespace thaw {
namespace {

// Least bytes of a particle: columns and neighbour list; and its solid record with the bonds.
constexpr double leastBytes = 400, leastSolidBytes = 600;
// The same of the good state that is kept for retries (core/watch/good_state.hpp).
constexpr double pi = 3.14159265358979323846;
constexpr double leastKeptBytes = 120, leastKeptSolidBytes = 400;

/// Least bytes of a surfel: its columns, and the lists of particles and surfels around it (4 bytes each).
double leastSurfelBytes(const Scene& s) {
  const double particles = 2.0 / 3 * pi * std::pow(s.surface.particleSupport * s.numerics.support, 3), surfels = pi * s.surface.support * s.surface.support;
  return 150 + 4 * (particles + surfels);
}

/// Memory of this machine, in bytes.
double memoryHere() {
  double bytes = static_cast<double>(::sysconf(_SC_PHYS_PAGES)) * static_cast<double>(::sysconf(_SC_PAGESIZE));
  std::ifstream limit("/sys/fs/cgroup/memory.max");  // says "max" where there is no limit
  if (double most = 0; limit >> most && most > 0) bytes = std::min(bytes, most);
  return bytes;
}

}  // namespace

void requireMemory(const Communicator& comm, const World& world, const MeshLoader& load) {
  std::vector<std::shared_ptr<const SignedDistance>> shapes;
  for (const Body& b : world.scene.bodies) shapes.push_back(makeSignedDistance(b.shape, load));
  const double particles = expectedParticles(shapes, world.scene.spacing);
  MPI_Comm machine;
  MPI_Comm_split_type(comm.handle(), MPI_COMM_TYPE_SHARED, comm.rank(), MPI_INFO_NULL, &machine);
  int ranksHere = 1;
  MPI_Comm_size(machine, &ranksHere);
  MPI_Comm_free(&machine);
  const double kept = world.scene.numerics.retryEvery > 0 ? 1 : 0;
  const double all = particles * (leastBytes + kept * leastKeptBytes + (world.modules.solid ? leastSolidBytes + kept * leastKeptSolidBytes : 0)), here = memoryHere();
  const double surfels = world.modules.surface ? expectedSurfels(world.scene, shapes) : 0, surface = surfels * (leastSurfelBytes(world.scene) + kept * leastKeptBytes);
  double worst[2] = {(all + surface) * ranksHere / comm.size() / here, -here};
  MPI_Allreduce(MPI_IN_PLACE, worst, 2, MPI_DOUBLE, MPI_MAX, comm.handle());
  if (!(worst[0] > 1)) return;
  const bool bySurface = surface > all;
  throw std::runtime_error(fmt::format("{} and at least {:.3g} GB of memory, but a machine of this run has {:.3g} GB; make {} larger, or run on more machines",
                                       bySurface ? fmt::format("the surface would take about {:.1e} surfels", surfels) : fmt::format("the bodies would take about {:.1e} particles", particles),
                                       (all + surface) / 1e9, -worst[1] / 1e9, bySurface ? "surface.spacing" : "the spacing"));
}

double expectedSurfels(const Scene& s, const std::vector<std::shared_ptr<const SignedDistance>>& shapes) {
  const double spacing = s.surface.spacing > 0 ? s.surface.spacing : 0.5 * s.spacing;
  return 1.15 * expectedArea(shapes) / (spacing * spacing);  // in hexagons
}

}  // namespace thaw
