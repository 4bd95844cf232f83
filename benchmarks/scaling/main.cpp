// SPDX-License-Identifier: Apache-2.0
// scaling --case fluid|corner --particles N [--copies] [--cpu-time] [--steps S] [--warm W]: one measurement
// of the scaling study on all ranks. Prints one line of CSV (--head: the column names). --copies: in turn
// with the measured run, ten steps each, every rank runs its own simulation of N / ranks particles, all at
// the same time. Both thus see the same state of a machine whose speed changes. --cpu-time: phases are
// measured in processor time, for more ranks than cores. benchmarks/scaling/series.py defines the series.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <string>
#include <vector>

#include "io/run/reports/communication_summary.hpp"
#include "io/scene/scene_for_all.hpp"
#include "parallel/balance.hpp"
#include "parallel/mpi_simulation.hpp"

namespace {

using namespace thaw;
using WallClock = std::chrono::steady_clock;

struct Options {
  std::string name = "fluid";
  double particles = 100000;
  int steps = 50, warm = 25;
  bool copies = false, counts = false, cpuTime = false;
};

std::string vec(double x, double y, double z) {
  return "[" + std::to_string(x) + "," + std::to_string(y) + "," + std::to_string(z) + "]";
}

/// Sizes of a cube of particles. The corner scene has its cube in a corner, and a film over the rest of a
/// tray four times as wide.
std::vector<std::string> sizes(const Options& o) {
  const double dx = 0.01, across = std::max(8.0, std::round(std::cbrt(o.particles))), L = dx * across;
  if (o.name == "fluid")
    return {"domain.max=" + vec(L, L, 1.25 * L), "body.water.box.size=" + vec(L, L, L),
            "body.water.place.move=" + vec(0.5 * L, 0.5 * L, 0.5 * L)};
  const double pool = dx * std::round(0.4 * across), block = L - pool, film = 2 * dx,
               side = dx * std::round(3 * across) - dx;
  return {"domain.max=" + vec(4 * L, 4 * L, 1.5 * L),
          "body.pool.box.size=" + vec(L, L, pool),
          "body.pool.place.move=" + vec(0.5 * L, 0.5 * L, 0.5 * pool),
          "body.block.box.size=" + vec(L, L, block),
          "body.block.place.move=" + vec(0.5 * L, 0.5 * L, pool + 0.5 * block),
          "body.film.box.size=" + vec(side, 4 * L, film),
          "body.film.place.move=" + vec(4 * L - 0.5 * side, 2 * L, 0.5 * film)};
}

double median(std::vector<double> v) {
  std::sort(v.begin(), v.end());
  return v.empty() ? 0 : v[v.size() / 2];
}

/// Mean and maximum over ranks of a non-negative value.
struct Over {
  double mean, most;
};
Over over(double mine, Reducer& all) {
  double most = mine;
  std::int64_t sum = std::llround(mine * 1e6);
  all.maximum({&most, 1});
  all.sum({&sum, 1});
  return {static_cast<double>(sum) * 1e-6 / all.size(), most};
}

constexpr const char* head =
    "case,ranks,particles,steps,ms_step,ms_step_mean,msteps_per_s,copies_msteps_per_s,efficiency,imbalance,"
    "imbalance_worst,particles_max_over_mean,halo_fraction,halo_fraction_max,"
    "neighbours,neighbours_max,messages,messages_max,kib,kib_max,kib_ghosts,kib_refresh,kib_bonds,messages_"
    "bonds,kib_migration,collectives,ms_work,ms_wait,ms_balance,start_s";

constexpr int look = 25;  // steps between balance checks, as in thaw run
double since(WallClock::time_point t) { return std::chrono::duration<double>(WallClock::now() - t).count(); }

/// A simulation with a communicator of its own and balance checks.
struct Run {
  Communicator comm;
  MpiSimulation simulation{comm};
  World& w = simulation.world;
  StepTools& tools = simulation.tools;
  bool byTime;  // cells are redistributed by their measured time
  WorkMeter meter;

  Run(MPI_Comm ranks, const Options& o) : comm(ranks), byTime(!o.counts) {
    w.scene = sceneForAll(comm, std::string(THAW_BENCHMARK_FOLDER) + "/scenes/" + o.name + ".toml", sizes(o));
    simulation.prepare(meshLoader());
    simulation.start(meshLoader());
  }
  Run(const Run&) = delete;

  void step(bool balanceAfter) {
    if (!simulation.step().finite) {
      std::fprintf(stderr,
                   "scaling: the scene blew up; its parameters in benchmarks/scaling/scenes are unstable\n");
      MPI_Abort(MPI_COMM_WORLD, 4);
    }
    if (!balanceAfter || !byTime) return;
    tools.times.start();
    balance(w, *simulation.tables.cells, tools, meter);
    tools.times.lap(StepPhase::Balance);
  }
  void warm(int steps) {  // at least two balance checks
    for (int k = 0; k < steps; k++)
      step(k % look == look - 1 || (steps < look && (k + 1) % std::max(1, steps / 2) == 0));
  }
};

/// Times of the steps of a run.
struct Measured {
  std::vector<double> steps;  // s, each
  std::vector<double> rates;  // particle-steps/s of all ranks, of each block
  double ghosts = 0, owned = 0, worst = 1;
};

/// Runs a block of steps and appends its rate: for copies the sum of the ranks' rates, else the total over
/// the slowest rank's time.
void stepBlock(Run& r, Measured& m, int from, int steps, bool copies, Reducer& everyone) {
  const auto start = WallClock::now();
  for (int k = from; k < from + steps; k++) {
    const auto t = WallClock::now();
    r.step(k % look == look - 1);
    m.steps.push_back(since(t));
    m.ghosts += static_cast<double>(r.w.particles.ghosts);
    m.owned += static_cast<double>(r.w.particles.owned);
  }
  const double took = since(start), owned = static_cast<double>(r.w.particles.owned);
  const CommunicationStatistics counted = r.comm.statistics();
  m.rates.push_back(
      steps * everyone.size() *
      (copies ? over(owned / took, everyone).mean : over(owned, everyone).mean / over(took, everyone).most));
  r.comm.statistics() = counted;  // without the messages of the measurement
}

int measure(const Options& o, const Communicator& world) {
  const auto begin = WallClock::now();
  Run r(world.handle(), o);
  const double startSeconds = since(begin);
  r.tools.times.onCore = o.cpuTime;
  r.warm(o.warm);
  std::unique_ptr<Run> copy;
  if (o.copies) {
    Options own = o;
    own.particles /= world.size();
    copy = std::make_unique<Run>(MPI_COMM_SELF, own);
    copy->warm(std::min(o.warm, 10));
  }
  MpiReducer everyone(world);
  MPI_Barrier(world.handle());
  const PhaseTimes before = r.tools.times;
  const CommunicationStatistics statisticsBefore = r.comm.statistics();
  Measured m, alone;
  double windowWork = workOf(before);
  const int block = o.copies ? 10 : look;
  for (int k = 0; k < o.steps; k += block) {
    stepBlock(r, m, k, std::min(block, o.steps - k), false, everyone);
    if (o.copies) {
      MPI_Barrier(world.handle());
      stepBlock(*copy, alone, k, std::min(block, o.steps - k), true, everyone);
      MPI_Barrier(world.handle());
      continue;
    }
    const CommunicationStatistics counted = r.comm.statistics();
    const Over now = over(workOf(r.tools.times) - windowWork, everyone);
    r.comm.statistics() = counted;
    windowWork = workOf(r.tools.times);
    if (now.mean > 0) m.worst = std::max(m.worst, now.most / now.mean);
  }
  const CommunicationStatistics after = r.comm.statistics();
  double wall = 0;
  for (const double s : m.steps) wall += s;

  const double n = o.steps;
  const Over work = over(workOf(r.tools.times) - workOf(before), everyone), mean = over(wall, everyone),
             start_s = over(startSeconds, everyone);
  const Over balanced = over(r.tools.times[StepPhase::Balance] - before[StepPhase::Balance], everyone),
             stepTime = over(median(m.steps), everyone);
  const Over owned = over(m.owned / n, everyone), halo = over(m.owned > 0 ? m.ghosts / m.owned : 0, everyone);
  const CommunicationSummary t = gatherCommunication(after, statisticsBefore, everyone);
  double copiesRate = 0, efficiency = 0;
  if (o.copies) {
    std::vector<double> ratios;
    for (std::size_t k = 0; k < m.rates.size(); k++) ratios.push_back(m.rates[k] / alone.rates[k]);
    copiesRate = median(alone.rates), efficiency = median(ratios);
  }
  const auto at = [&](MessagesFor p) -> const CommunicationSummary::Of& {
    return t.of[static_cast<std::size_t>(p)];
  };
  if (world.rank() != 0) return 0;
  const double kib = 1024 * n;
  std::printf(
      "%s,%d,%.0f,%d,%.4f,%.4f,%.4f,%.4f,%.4f,%.4f,%.4f,%.4f,%.4f,%.4f,%.2f,%.2f,%.2f,%.2f,%.3f,%.3f,%.3f,%."
      "3f,%.3f,%.2f,%.3f,%.3f,%.4f,%.4f,%.4f,%.2f\n",
      o.name.c_str(), world.size(), owned.mean * world.size(), o.steps, 1e3 * stepTime.most,
      1e3 * mean.mean / n, median(m.rates) / 1e6, copiesRate / 1e6, efficiency,
      work.mean > 0 ? work.most / work.mean : 1, m.worst, owned.most / owned.mean, halo.mean, halo.most,
      at(MessagesFor::Ghosts).messages.mean / n, at(MessagesFor::Ghosts).messages.most / n,
      t.messages.mean / n, t.messages.most / n, t.bytes.mean / kib, t.bytes.most / kib,
      at(MessagesFor::Ghosts).bytes.mean / kib, at(MessagesFor::Refresh).bytes.mean / kib,
      at(MessagesFor::Bonds).bytes.mean / kib, at(MessagesFor::Bonds).messages.mean / n,
      at(MessagesFor::Migration).bytes.mean / kib, static_cast<double>(t.collectives) / n,
      1e3 * work.mean / n, 1e3 * t.waited.mean / n, 1e3 * balanced.mean / n, start_s.most);
  return 0;
}

int usage() {
  std::fprintf(stderr,
               "scaling --case fluid|corner --particles N [--copies | --counts] [--cpu-time] [--steps 50] "
               "[--warm 25] | --head\n");
  return 2;
}

}  // namespace

int main(int argc, char** argv) {
  Options o;
  for (int a = 1; a < argc; a++) {
    const std::string key = argv[a];
    if (key == "--head") return std::puts(head) < 0;
    if (key == "--copies") {
      o.copies = true;
      continue;
    }
    if (key == "--cpu-time") {
      o.cpuTime = true;
      continue;
    }
    if (key == "--counts") {
      o.counts = true;
      continue;
    }
    if (a + 1 == argc) return usage();
    const char* value = argv[++a];
    if (key == "--case") o.name = value;
    else if (key == "--particles") o.particles = std::atof(value);
    else if (key == "--steps") o.steps = std::atoi(value);
    else if (key == "--warm") o.warm = std::atoi(value);
    else return usage();
  }
  if ((o.name != "fluid" && o.name != "corner") || !(o.particles >= 1) || o.steps < 1 || o.warm < 0)
    return usage();
  MpiSession mpi(&argc, &argv);
  const Communicator world;
  return measure(o, world);
}
