#include "io/commands/check_surface.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <chrono>
#include <fstream>

#include "core/fluid/liquid_materials.hpp"
#include "core/surface/prepare_surface.hpp"
#include "io/commands/require_memory.hpp"

namespace thaw {
namespace {

double secondsNow() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

/// Resident memory of this process, in bytes.
double residentNow() {
  std::ifstream file("/proc/self/statm");
  double all = 0, resident = 0;
  file >> all >> resident;
  return resident * static_cast<double>(::sysconf(_SC_PAGESIZE));
}

constexpr double pi = 3.14159265358979323846;

std::string bytesText(double b) { return b > 1e9 ? fmt::format("{:.2f} GB", b / 1e9) : fmt::format("{:.1f} MB", b / 1e6); }

}  // namespace

// Sets surface.spacing so that no more are made: `thaw check` is to answer in seconds.
const CellGrid& SurfaceTrial::gridOfTrial(const MeshLoader& load) {
  constexpr double most = 1e5;
  World& w = world_;
  if (!w.modules.surface) return w.grid;
  std::vector<std::shared_ptr<const SignedDistance>> shapes;
  for (const Body& b : w.scene.bodies) shapes.push_back(makeSignedDistance(b.shape, load));
  expected_ = expectedSurfels(w.scene, shapes);
  spacing_ = w.surface.spacing;
  if (expected_ > most) {
    w.scene.surface.spacing = spacing_ * std::sqrt(expected_ / most);
    prepareSurface(w);
  }
  return w.surface.grid;
}

SurfaceTrial::SurfaceTrial(const Communicator& comm, World& w, const MeshLoader& load) : comm_(comm), world_(w), halos_(comm, gridOfTrial(load)) {
  if (!w.modules.surface) return;
  tools_.load = load;
  const double before = residentNow(), start = secondsNow();
  startSurface(w, halos_.halos(), tools_);
  start_ = secondsNow() - start;
  bytes_ += std::max(0.0, residentNow() - before);
  const double coarser = w.surface.spacing / spacing_;
  perMeasured_ = coarser * coarser;
}

void SurfaceTrial::update() {
  if (!world_.modules.surface) return;
  const double before = residentNow(), start = secondsNow();
  updateSurface(world_, halos_.halos(), tools_);
  each_ = secondsNow() - start;
  bytes_ += std::max(0.0, residentNow() - before);
}

SurfaceTrial::Forecast SurfaceTrial::forecast(double steps) const {
  const World& w = world_;
  Forecast f;
  if (!w.modules.surface) return f;
  std::int64_t counts[2] = {static_cast<std::int64_t>(w.surface.surfels.owned), std::llround(bytes_)};
  double times[2] = {start_, each_};
  MpiReducer all(comm_);
  all.sum(counts);
  all.maximum(times);
  f.surfels = perMeasured_ * static_cast<double>(counts[0]);
  f.bytes = perMeasured_ * static_cast<double>(counts[1]);
  f.frames = std::floor(w.scene.end / w.scene.output.every) + 1;
  f.updates = expectedUpdates(w, steps);
  f.seconds = perMeasured_ * (times[0] + f.updates * times[1]) * comm_.size();
  return f;
}

std::vector<std::string> SurfaceTrial::lines(const Forecast& f, int ranks) const {
  const World& w = world_;
  if (!w.modules.surface) return {};
  double times[2] = {start_, each_};
  MpiReducer(comm_).maximum(times);
  const Surface& s = w.surface;
  const SurfaceSettings& set = w.scene.surface;
  std::vector<std::string> lines{
      fmt::format("{:.0f} surfels at the start ({:.0f} expected by the area of the bodies), {} component{}", f.surfels, expected_, s.components.size(), s.components.size() == 1 ? "" : "s"),
      fmt::format("surfels {:g} m apart; they act on each other within {:g} m (about {:.0f} neighbours), particles on them within {:g} m (about {:.0f})", spacing_, set.support * spacing_,
                  1.15 * pi * set.support * set.support, s.particleSupport, 2.0 / 3 * pi * std::pow(s.particleSupport / w.scene.spacing, 3)),
      fmt::format("memory a rank: {} with {} ranks ({:.0f} bytes a surfel, work lists included)", bytesText(f.bytes / ranks), ranks, f.bytes / std::max(1.0, f.surfels)),
      fmt::format("the start {} {:.3g} s, one update after a few steps {:.3g} s, on {} rank{}", perMeasured_ > 1 ? "would take about" : "took", perMeasured_ * times[0], perMeasured_ * times[1], comm_.size(),
                  comm_.size() == 1 ? "" : "s"),
      fmt::format("about {:.0f} updates until the end, {:.0f} of them at frames{}", f.updates, f.frames,
                  set.everyMove > 0 ? fmt::format("; the others as particles come {:g} m, at half of {:.3g} m/s, the largest speed expected", set.everyMove * w.grid.support, expectedSpeed(w.scene)) : set.everySteps > 0 ? "" : ", however far particles move in between")};
  if (perMeasured_ > 1) lines.push_back(fmt::format("these figures are scaled up from {:.0f} surfels {:.3g} m apart", f.surfels / perMeasured_, s.spacing));
  if (w.modules.melting || w.modules.fluid) lines.push_back("an update takes longer the more of the surface is liquid and moves: two to five times as long as of a solid");
  return lines;
}

double expectedUpdates(const World& w, double steps) {
  const SurfaceSettings& s = w.scene.surface;
  double updates = std::floor(w.scene.end / w.scene.output.every) + 1;
  if (s.everySteps > 0) updates += steps / static_cast<double>(s.everySteps);
  else if (s.everyMove > 0) updates += 0.5 * expectedSpeed(w.scene) * w.scene.end / (s.everyMove * w.grid.support);
  return std::min(updates, steps + 1);
}

}  // namespace thaw
