// SPDX-License-Identifier: Apache-2.0
#include "io/run/require_memory.hpp"

#include <fmt/format.h>
#include <mpi.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <numbers>
#include <stdexcept>
#include <string>

#include "core/geometry/basic/shape_error.hpp"
#include "core/simulation/setup/estimates/expected_particles.hpp"
#include "core/simulation/setup/estimates/expected_rows.hpp"
#include "core/simulation/setup/estimates/size_hint.hpp"

namespace thaw {
namespace {

constexpr double manyToSample = 5e4;     // particles on a surface: sampling takes some 20 s
constexpr double leastSolidBytes = 600;  // lower bound for a solid particle's record with its bonds
// The snapshot for retries has lower bounds of its own (core/simulation/monitor/snapshot.hpp).
using std::numbers::pi;
constexpr double leastKeptBytes = 75, leastKeptSolidBytes = 400;

/// Returns a lower bound for the bytes of a surfel: columns, and neighbour lists of 4 bytes per entry.
double leastSurfelBytes(const Scene& s) {
  const double particles = 2.0 / 3 * pi * std::pow(s.surface.particleSupport * s.numerics.support, 3),
               surfels = pi * s.surface.support * s.surface.support;
  return 150 + 4 * (particles + surfels);
}

/// Returns the memory of this machine, in bytes.
double memoryHere() {
  double bytes = static_cast<double>(::sysconf(_SC_PHYS_PAGES)) *
                 static_cast<double>(::sysconf(_SC_PAGESIZE));
  std::ifstream limit("/sys/fs/cgroup/memory.max");  // contains "max" without a limit
  if (double most = 0; limit >> most && most > 0) bytes = std::min(bytes, most);
  return bytes;
}

int ranksOfMachine(const Communicator& comm) {
  MPI_Comm machine;
  MPI_Comm_split_type(comm.handle(), MPI_COMM_TYPE_SHARED, comm.rank(), MPI_INFO_NULL, &machine);
  int ranks = 1;
  MPI_Comm_size(machine, &ranks);
  MPI_Comm_free(&machine);
  return ranks;
}

/// Refuses surfels farther apart than half the width of a body.
void refuseWideSurfels(const Scene& s, const std::vector<std::shared_ptr<const SignedDistance>>& shapes) {
  SceneProblems problems;
  for (std::size_t b = 0; b < shapes.size(); b++) {
    const Bounds box = shapes[b]->bounds();
    const double widest = std::max({box.max.x - box.min.x, box.max.y - box.min.y, box.max.z - box.min.z});
    if (s.surface.spacing > 0.5 * widest)
      problems.add(s.bodies[b].where,
                   fmt::format("`surface.spacing` ({:g} m) is more than half the width of body '{}' ({:.3g} "
                               "m); expected less, or 0 for half the spacing of particles",
                               s.surface.spacing, s.bodies[b].name, widest) +
                       sizeHint(s, s.bodies[b].shape, box));
  }
  problems.raise();
}

}  // namespace

std::vector<std::string> requireMemoryForBodyTypes(const Communicator& comm, const Scene& scene,
                                                   const MeshLoader& load) {
  std::vector<std::string> slow;
  if (scene.oriented.empty() && scene.sheets.empty()) return slow;
  const double ranksHere = ranksOfMachine(comm), here = memoryHere();
  SceneProblems problems;
  for (const ExpectedRows& e : expectedRows(scene, load)) {
    if (e.spread && e.rows > manyToSample)
      slow.push_back(
          fmt::format("{}: sampling its surface with about {:.1e} {} takes a while", e.name, e.rows, e.word));
    const double bytes = ranksHere * (e.bytesEverywhere + e.bytesShared / comm.size());
    double worst[3] = {bytes / here, bytes, -here};
    MPI_Allreduce(MPI_IN_PLACE, worst, 3, MPI_DOUBLE, MPI_MAX, comm.handle());
    const bool many = e.rows > mostRowsPerBody;
    if (!(worst[0] > 1) && !many) continue;
    const double fits = 1.1 * e.spacing * std::sqrt(std::max(worst[0], e.rows / mostRowsPerBody));
    problems.add(
        e.where,
        fmt::format("{}: at a spacing of {:.3g} m it would have about {:.1e} {}, which take {:.3g} GB on a "
                    "machine that has {:.3g} GB; expected a spacing of at least {:.2g} m, or a smaller body",
                    e.name, e.spacing, e.rows, e.word, worst[1] / 1e9, -worst[2] / 1e9, fits));
  }
  problems.raise();
  return slow;
}

void requireMemory(const Communicator& comm, const Modules& modules, const Scene& scene,
                   const std::vector<std::shared_ptr<const SignedDistance>>& shapes) {
  if (modules.surface) refuseWideSurfels(scene, shapes);
  double particles = 0, most = -1;
  std::size_t largest = 0;  // named in the message
  for (std::size_t b = 0; b < shapes.size(); b++) {
    const double own = expectedParticles({shapes[b]}, scene.spacing);
    particles += own;
    if (own > most) most = own, largest = b;
  }
  const int ranksHere = ranksOfMachine(comm);
  const double kept = scene.numerics.retryEvery > 0 ? 1 : 0;
  const double all = particles * (leastParticleBytes + kept * leastKeptBytes +
                                  (modules.solid ? leastSolidBytes + kept * leastKeptSolidBytes : 0)),
               here = memoryHere();
  const double surfels = modules.surface ? expectedSurfels(scene, shapes) : 0,
               surface = surfels * (leastSurfelBytes(scene) + kept * leastKeptBytes);
  double worst[2] = {(all + surface) * ranksHere / comm.size() / here, -here};
  MPI_Allreduce(MPI_IN_PLACE, worst, 2, MPI_DOUBLE, MPI_MAX, comm.handle());
  if (!(worst[0] > 1)) return;
  const bool bySurface = surface > all;
  const std::string text = fmt::format(
      "{}, and at least {:.3g} GB of memory, but a machine of this run has {:.3g} GB: "
      "{}, or more machines",
      bySurface ? fmt::format("the surface needs about {:.1e} surfels", surfels)
                : fmt::format("the bodies need about {:.1e} particles", particles),
      (all + surface) / 1e9, -worst[1] / 1e9,
      bySurface
          ? "use a larger `surface.spacing`"
          : fmt::format("use a spacing of at least {:.2g} m", 1.1 * scene.spacing * std::cbrt(worst[0])));
  if (shapes.empty()) throw std::runtime_error(text);
  const Body& body = scene.bodies[largest];
  SceneProblems problem;
  problem.add(body.where,
              "body '" + body.name + "': " + text + sizeHint(scene, body.shape, shapes[largest]->bounds()));
  problem.raise();
}

double expectedSurfels(const Scene& s, const std::vector<std::shared_ptr<const SignedDistance>>& shapes) {
  const double spacing = surfelSpacing(s);
  return 1.1 * expectedArea(shapes) / (spacing * spacing);  // measured: 1.06 for boxes, 1.10 for balls, 1.12
                                                            // for cylinders; 1.155 on a hexagonal lattice
}

}  // namespace thaw
