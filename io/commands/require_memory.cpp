#include "io/commands/require_memory.hpp"

#include <fmt/format.h>
#include <mpi.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <stdexcept>
#include <string>

#include "core/setup/expected_particles.hpp"

namespace thaw {
namespace {

// Least bytes of a particle: columns and neighbour list; and its solid record with the bonds.
constexpr double leastBytes = 400, leastSolidBytes = 600;
// The same of the good state that is kept for retries (core/watch/good_state.hpp).
constexpr double leastKeptBytes = 120, leastKeptSolidBytes = 400;

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
  double worst[2] = {all * ranksHere / comm.size() / here, -here};
  MPI_Allreduce(MPI_IN_PLACE, worst, 2, MPI_DOUBLE, MPI_MAX, comm.handle());
  if (worst[0] > 1)
    throw std::runtime_error(fmt::format("the bodies would take about {:.1e} particles and at least {:.3g} GB of memory, but a machine of this run has {:.3g} GB; "
                                         "make the spacing larger, or run on more machines",
                                         particles, all / 1e9, -worst[1] / 1e9));
}

}  // namespace thaw
