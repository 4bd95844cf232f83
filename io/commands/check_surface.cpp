#include "io/commands/check_surface.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <chrono>
#include <fstream>

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

SurfaceTrial::SurfaceTrial(const Communicator& comm, World& w, const MeshLoader& load) : comm_(comm), world_(w), halos_(comm, w.modules.surface ? w.surface.grid : w.grid) {
  if (!w.modules.surface) return;
  std::vector<std::shared_ptr<const SignedDistance>> shapes;
  for (const Body& b : w.scene.bodies) shapes.push_back(makeSignedDistance(b.shape, load));
  expected_ = expectedSurfels(w.scene, shapes);
  tools_.load = load;
  const double before = residentNow(), start = secondsNow();
  startSurface(w, halos_.halos(), tools_);
  start_ = secondsNow() - start;
  bytes_ += std::max(0.0, residentNow() - before);
}

void SurfaceTrial::update() {
  if (!world_.modules.surface) return;
  const double before = residentNow(), start = secondsNow();
  updateSurface(world_, halos_.halos(), tools_);
  each_ = secondsNow() - start;
  bytes_ += std::max(0.0, residentNow() - before);
}

std::vector<std::string> SurfaceTrial::lines(int ranks) {
  const World& w = world_;
  if (!w.modules.surface) return {};
  std::int64_t counts[2] = {static_cast<std::int64_t>(w.surface.surfels.owned), std::llround(bytes_)};
  double times[2] = {start_, each_};
  MpiReducer all(comm_);
  all.sum(counts);
  all.maximum(times);
  const double surfels = static_cast<double>(std::max<std::int64_t>(1, counts[0])), perRank = static_cast<double>(counts[1]) / ranks;
  const Surface& s = w.surface;
  const SurfaceSettings& set = w.scene.surface;
  std::vector<std::string> lines{
      fmt::format("{} surfels at the start ({:.0f} expected by the area of the bodies), {} component{}", counts[0], expected_, s.components.size(), s.components.size() == 1 ? "" : "s"),
      fmt::format("surfels {:g} m apart; they act on each other within {:g} m (about {:.0f} neighbours), particles on them within {:g} m (about {:.0f})", s.spacing, s.surfelSupport,
                  1.15 * pi * set.support * set.support, s.particleSupport, 2.0 / 3 * pi * std::pow(s.particleSupport / w.scene.spacing, 3)),
      fmt::format("memory a rank: {} with {} ranks ({:.0f} bytes a surfel, work lists included)", bytesText(perRank), ranks, static_cast<double>(counts[1]) / surfels),
      fmt::format("the start took {:.3g} s, one update after a few steps {:.3g} s, on {} rank{}", times[0], times[1], comm_.size(), comm_.size() == 1 ? "" : "s")};
  for (const std::string& line : surfaceAdvice(w.scene)) lines.push_back("note: " + line);
  return lines;
}

std::vector<std::string> surfaceAdvice(const Scene& scene) {
  const SurfaceSettings& s = scene.surface;
  std::vector<std::string> notes;
  const double spacing = s.spacing > 0 ? s.spacing : 0.5 * scene.spacing;
  if (spacing > scene.spacing) notes.push_back(fmt::format("surface.spacing ({:g} m) is above spacing ({:g} m): the surface is coarser than the particles", spacing, scene.spacing));
  if (s.everySteps == 0 && s.everyMove == 0) notes.push_back("surface.every_steps and surface.every_move are 0: the surface is updated at frames only, however far particles move in between");
  if (s.everyMove > 1) notes.push_back(fmt::format("surface.every_move is {:g}: particles come further than their neighbourhood between two updates, and the surface is carried less well", s.everyMove));
  if (s.support > 5) notes.push_back(fmt::format("surface.support is {:g}: about {:.0f} surfels act on each surfel, and time and memory grow with it", s.support, 1.15 * pi * s.support * s.support));
  return notes;
}

}  // namespace thaw
