// SPDX-License-Identifier: Apache-2.0
#include "io/commands/check/check_surface.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <fstream>
#include <numbers>

#include "core/materials/liquid_materials.hpp"
#include "core/simulation/setup/prepare_surface.hpp"
#include "core/simulation/views/views.hpp"
#include "core/time/seconds_now.hpp"
#include "io/run/require_memory.hpp"
#include "io/text/bytes_text.hpp"
#include "io/text/duration_text.hpp"

namespace thaw {
namespace {

using std::numbers::pi;

/// Resident memory of this process, in bytes.
double residentNow() {
  std::ifstream file("/proc/self/statm");
  double all = 0, resident = 0;
  file >> all >> resident;
  return resident * static_cast<double>(::sysconf(_SC_PAGESIZE));
}

// Core seconds per surfel and update of molten material, measured over an hour of keiser/melting_fast. Used
// for scenes without surfels at the start.
constexpr double secondsPerSurfel = 2e-5;
constexpr double bytesPerSurfel = 2800;  // measured with scenes/melt, work lists included; used for few
                                         // surfels, whose memory is mostly fixed
constexpr std::int64_t few = 500;

/// Turns everything that can be liquid into liquid and moves it as between two updates. Displacements are up
/// to 0.1 support radii, with a period of four.
void meltWorld(Continuum& p, const CellGrid& grid, const Scene& scene) {
  const double h = grid.support, k = 0.5 * pi / h;
  for (std::size_t i = 0; i < p.owned; i++) {
    const Material& m = scene.materials[p.material[i]];
    if (m.canBeSolid() && !m.melts() && !m.liquidAtStart) continue;
    p.phase[i] = Liquid;
    if (p.liquid.active) p.liquid[i] = 1;
    if (p.solidIndex.active) p.solidIndex[i] = noSolid;
    const Vec3d x = p.position[i];
    p.position[i] += 0.1 * h * Vec3d{std::sin(k * x.y), std::sin(k * x.z), std::sin(k * x.x)};
  }
}

}  // namespace

// Returns the grid of the surface. Coarsens Surface::spacing to at most 1e5 surfels, so that `thaw check`
// takes seconds.
const CellGrid& SurfaceTrial::gridOfTrial(const MeshLoader& load) {
  constexpr double most = 1e5;
  World& w = world_;
  if (!w.modules.surface) return w.grid;
  std::vector<std::shared_ptr<const SignedDistance>> shapes;
  for (const Body& b : w.scene.bodies) shapes.push_back(makeSignedDistance(b.shape, load));
  expected_ = expectedSurfels(w.scene, shapes);
  spacing_ = w.surface.spacing;
  if (expected_ > most) {
    const double wanted = w.scene.surface.spacing;
    w.scene.surface.spacing = spacing_ * std::sqrt(expected_ / most);
    prepareSurface(w);
    w.scene.surface.spacing = wanted;  // messages name the spacing of the scene
  }
  return w.surface.grid;
}

SurfaceTrial::SurfaceTrial(const Communicator& comm, World& w, const MeshLoader& load)
    : comm_(comm), world_(w), halos_(comm, gridOfTrial(load)) {
  if (!w.modules.surface) return;
  tools_.load = load;
  const double before = residentNow(), start = secondsNow();
  startSurface(surfaceView(w), halos_.halos(), tools_);
  start_ = secondsNow() - start;
  bytes_ += std::max(0.0, residentNow() - before);
  const double coarser = w.surface.spacing / spacing_;
  perMeasured_ = coarser * coarser;
}

double SurfaceTrial::timeOfUpdate() {
  const double before = residentNow(), start = secondsNow();
  updateSurface(surfaceView(world_), halos_.halos(), tools_);
  bytes_ += std::max(0.0, residentNow() - before);
  return secondsNow() - start;
}

void SurfaceTrial::update() {
  if (!world_.modules.surface) return;
  surfels_ = static_cast<std::int64_t>(world_.surface.surfels.owned);
  MpiReducer(comm_).sum({&surfels_, 1});
  each_ = flowing_ = timeOfUpdate();
  if (!world_.modules.fluid) return;
  meltWorld(world_.particles, world_.grid, world_.scene);
  flowing_ = timeOfUpdate();
}

SurfaceTrial::Forecast SurfaceTrial::forecast(double steps, double particles) const {
  const World& w = world_;
  Forecast f;
  if (!w.modules.surface) return f;
  std::int64_t bytes = std::llround(bytes_);
  double times[2] = {start_, flowing_};
  MpiReducer all(comm_);
  all.sum({&bytes, 1});
  all.maximum(times);
  const double spacing = w.scene.spacing, perArea = 1.15 / (spacing_ * spacing_);  // on a hexagonal lattice
  f.surfels = perMeasured_ * static_cast<double>(surfels_);
  double most = f.surfels, surfels = f.surfels;
  // Each particle is a drop.
  if (w.modules.fluid) most = std::max(most, perArea * pi * spacing * spacing * particles);
  // A puddle has twice the area of a ball.
  if (w.modules.emitters)
    surfels = std::max(surfels, perArea * 2 * 4.84 * spacing * spacing * std::cbrt(particles * particles));
  most = std::max(most, surfels);
  f.surfelsTogether = surfels;
  f.surfelsMost = most;
  // Memory grows with the surfels that emitters add.
  if (surfels_ > few)
    f.bytes = perMeasured_ * static_cast<double>(bytes) * std::max(1.0, f.surfelsTogether / f.surfels);
  else f.bytes = static_cast<double>(bytes) + bytesPerSurfel * f.surfelsTogether;
  f.frames = std::floor(w.scene.end / w.scene.output.every) + 1;
  f.updates = expectedUpdates(w.scene, w.grid, steps);
  const double perSurfel = surfels_ > few ? times[1] * comm_.size() / static_cast<double>(surfels_)
                                          : secondsPerSurfel,
               start = perMeasured_ * times[0] * comm_.size();
  f.seconds = start + f.updates * surfels * perSurfel;
  f.secondsMost = start + f.updates * most * perSurfel;
  return f;
}

std::vector<std::string> SurfaceTrial::lines(const Forecast& f, int ranks) const {
  const World& w = world_;
  if (!w.modules.surface) return {};
  double times[3] = {start_, each_, flowing_};
  MpiReducer(comm_).maximum(times);
  const Surface& s = w.surface;
  const SurfaceSettings& set = w.scene.surface;
  std::vector<std::string> lines{
      fmt::format("{} surfels at the start ({} expected from the area of the bodies), {} component{}",
                  countText(f.surfels), countText(expected_), s.components.size(),
                  s.components.size() == 1 ? "" : "s"),
      fmt::format("surfels {:g} m apart; they act on each other within {:g} m (about {:.0f} neighbours), "
                  "particles on them within {:g} m (about {:.0f})",
                  spacing_, set.support * spacing_, 1.15 * pi * set.support * set.support, s.particleSupport,
                  2.0 / 3 * pi * std::pow(s.particleSupport / w.scene.spacing, 3)),
      fmt::format("memory per rank: {} with {} rank{} ({:.0f} bytes per surfel, work lists included)",
                  bytesText(f.bytes / ranks), ranks, ranks == 1 ? "" : "s",
                  f.bytes / std::max(1.0, f.surfelsTogether)),
      fmt::format(
          "initial sampling {} {:.3g} s, an update {:.3g} s{}, on {} rank{}",
          perMeasured_ > 1 ? "would take about" : "took", perMeasured_ * times[0], perMeasured_ * times[1],
          w.modules.fluid ? fmt::format(", an update of flowing liquid {:.3g} s", perMeasured_ * times[2])
                          : "",
          comm_.size(), comm_.size() == 1 ? "" : "s"),
      fmt::format("about {} updates until the end, {} of them at frames{}", countText(f.updates),
                  countText(f.frames),
                  set.everyMove > 0    ? fmt::format("; the others each time particles have moved {:g} m, at "
                                                        "half the largest expected speed of {:.3g} m/s",
                                                     set.everyMove * w.grid.support, expectedSpeed(w.scene))
                  : set.everySteps > 0 ? ""
                                       : ", however far particles move in between")};
  if (perMeasured_ > 1)
    lines.push_back(fmt::format("extrapolated from a coarser sample: {:.0f} surfels {:.3g} m apart",
                                f.surfels / perMeasured_, s.spacing));
  if (w.modules.fluid)
    lines.push_back(
        fmt::format("time and memory scale with the number of surfels: {} if the liquid stays together, up "
                    "to {} if all of it breaks up into drops",
                    countText(f.surfelsTogether), countText(f.surfelsMost)));
  return lines;
}

double expectedUpdates(const Scene& scene, const CellGrid& grid, double steps) {
  const SurfaceSettings& s = scene.surface;
  double updates = std::floor(scene.end / scene.output.every) + 1;
  if (s.everySteps > 0) updates += steps / static_cast<double>(s.everySteps);
  else if (s.everyMove > 0) updates += 0.5 * expectedSpeed(scene) * scene.end / (s.everyMove * grid.support);
  return std::min(updates, steps + 1);
}

}  // namespace thaw
