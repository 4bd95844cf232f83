#include "benchmarks/accuracy/trial.hpp"

#include <cmath>
#include <ctime>

#include "core/math/exact_sum.hpp"
#include "io/commands/scene_for_all.hpp"
#include "parallel/balance.hpp"

namespace thaw::accuracy {
namespace {

/// Of this process; unlike wall-clock time it does not depend on what else runs on the machine.
double processorSeconds() {
  timespec t{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

}  // namespace

void run(const Case& c, Trial& r, const std::vector<std::string>& overrides) {
  const std::string file = std::string(THAW_BENCHMARK_FOLDER) + "/scenes/" + (c.scene ? c.scene : c.name) + ".toml";
  World& w = r.world;
  w.scene = sceneForAll(r.comm, file, overrides);
  if (c.adapt) c.adapt(w.scene);
  prepareWorld(w, r.tools, meshLoader());
  r.cells = std::make_unique<MpiCellHalo>(r.comm, w.grid);
  r.bonds = std::make_unique<MpiBondHalo>(r.comm);
  sampleWorld(w, r.halos(), r.tools, meshLoader());
  if (c.place) c.place(r);
  r.tools.bondsAtStart = w.modules.solid;
  r.tools.emitFirst = true;
  takeStock(w, r.halos(), r.tools);
  if (c.start) {
    c.start(r);
    takeStock(w, r.halos(), r.tools);
  }
  if (c.watch) c.watch(r);
  WorkMeter meter;
  const double begin = processorSeconds();
  while (w.clock.time < w.clock.end && r.finite) {
    r.finite = step(w, r.halos(), r.tools, {}).finite;
    if (c.watch) c.watch(r);
    if (w.clock.step % 25 == 0) balance(w, *r.cells, r.tools, meter);
  }
  r.coreSeconds = processorSeconds() - begin;
  ExactSum all;
  all.add(r.coreSeconds);
  all.carry();
  r.all.sum(all.digit);
  r.coreSeconds = all.value();
}

void makeThin(Scene& s) {
  const double width = std::max(6.0, std::ceil(3 * s.numerics.support)) * s.spacing;  // three cells
  for (int a = 0; a < 3; a++) {
    if (s.domain.side[static_cast<std::size_t>(a)][0] != Side::Periodic) continue;
    s.domain.min[a] = 0;
    s.domain.max[a] = width;
    for (Body& b : s.bodies) {
      b.shape.size[a] = width;
      b.shape.move[a] = 0.5 * width;
    }
  }
}

double sum(Trial& r, const OfParticle& f) {
  ExactSum s;
  for (std::size_t i = 0; i < r.world.particles.owned; i++) s.add(f(r.world, i));
  s.carry();
  r.all.sum(s.digit);
  return s.value();
}

double largest(Trial& r, const OfParticle& f) {
  double most = -never;
  for (std::size_t i = 0; i < r.world.particles.owned; i++) most = std::max(most, f(r.world, i));
  r.all.maximum({&most, 1});
  return most;
}

double rootMeanSquare(Trial& r, const OfParticle& f) {
  const double n = sum(r, [](const World&, std::size_t) { return 1.0; });
  return std::sqrt(sum(r, [&](const World& w, std::size_t i) { const double v = f(w, i); return v * v; }) / n);
}

}  // namespace thaw::accuracy
