// scaling --case fluid|corner --particles N [--copies] [--steps S] [--warm W]: one measurement of the scaling study, on the ranks that mpirun has
// started; prints one line of CSV (--head: the names of its columns). --copies: each rank runs a simulation of N particles of its own, all at the
// same time: what the machine does without any parallel program. The series are in benchmarks/scaling/run.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "core/setup/setup.hpp"
#include "io/commands/scene_for_all.hpp"
#include "io/run/traffic_summary.hpp"
#include "parallel/balance.hpp"
#include "parallel/bond_halo.hpp"
#include "parallel/cell_halo.hpp"

namespace {

using namespace thaw;
using WallClock = std::chrono::steady_clock;

struct Options {
  std::string name = "fluid";
  double particles = 100000;
  int steps = 50, warm = 25;
  bool copies = false;
};

std::string vec(double x, double y, double z) { return "[" + std::to_string(x) + "," + std::to_string(y) + "," + std::to_string(z) + "]"; }

/// A cube of particles. The corner scene has its cube in a corner and a film over the rest of a tray four times as wide.
std::vector<std::string> sizes(const Options& o) {
  const double dx = 0.01, across = std::max(8.0, std::round(std::cbrt(o.particles))), L = dx * across;
  if (o.name == "fluid")
    return {"domain.max=" + vec(L, L, 1.25 * L), "body.water.box.size=" + vec(L, L, L), "body.water.place.move=" + vec(0.5 * L, 0.5 * L, 0.5 * L)};
  const double pool = dx * std::round(0.4 * across), block = L - pool, film = 2 * dx, side = dx * std::round(3 * across) - dx;
  return {"domain.max=" + vec(4 * L, 4 * L, 1.5 * L),
          "body.pool.box.size=" + vec(L, L, pool), "body.pool.place.move=" + vec(0.5 * L, 0.5 * L, 0.5 * pool),
          "body.block.box.size=" + vec(L, L, block), "body.block.place.move=" + vec(0.5 * L, 0.5 * L, pool + 0.5 * block),
          "body.film.box.size=" + vec(side, 4 * L, film), "body.film.place.move=" + vec(4 * L - 0.5 * side, 2 * L, 0.5 * film)};
}

double median(std::vector<double> v) {
  std::sort(v.begin(), v.end());
  return v.empty() ? 0 : v[v.size() / 2];
}

/// Of values of a rank that are not negative.
struct Over { double mean, most; };
Over over(double mine, Reducer& all) {
  double most = mine;
  std::int64_t sum = std::llround(mine * 1e6);
  all.maximum({&most, 1});
  all.sum({&sum, 1});
  return {static_cast<double>(sum) * 1e-6 / all.size(), most};
}

constexpr const char* head =
    "series,case,ranks,particles,steps,ms_step,ms_step_mean,msteps_per_s,imbalance,imbalance_worst,particles_max_over_mean,halo_fraction,halo_fraction_max,"
    "neighbours,neighbours_max,messages,messages_max,kib,kib_max,kib_ghosts,kib_refresh,kib_bonds,messages_bonds,kib_migration,collectives,ms_work,ms_wait,ms_balance,start_s";

struct Measured {
  std::vector<double> steps;   // s, each
  double wall = 0, ghosts = 0, owned = 0, worst = 1, balance = 0;
  PhaseTimes work;
  Traffic before;
};

double since(WallClock::time_point t) { return std::chrono::duration<double>(WallClock::now() - t).count(); }

int measure(const Options& o, const Communicator& world) {
  const auto begin = WallClock::now();
  const Communicator comm(o.copies ? MPI_COMM_SELF : world.handle());
  World w;
  StepTools tools;
  w.scene = sceneForAll(comm, std::string(THAW_BENCHMARK_FOLDER) + "/scenes/" + o.name + ".toml", sizes(o));
  prepareWorld(w, tools, meshLoader());
  MpiReducer all(comm);
  MpiCellHalo cells(comm, w.grid);
  MpiBondHalo bonds(comm);
  const Halos halos{all, cells, bonds};
  startWorld(w, halos, tools, meshLoader());
  const double startSeconds = since(begin);

  WorkMeter meter;
  Measured m;
  double windowWork = 0;
  const auto oneStep = [&](int k) {
    if (!step(w, halos, tools, {}).finite) {
      std::fprintf(stderr, "scaling: the scene blew up\n");
      MPI_Abort(MPI_COMM_WORLD, 4);
    }
    if (k % 25 != 24) return;  // as thaw run does
    tools.times.start();
    balance(w, cells, tools, meter);
    tools.times.lap(StepPhase::Balance);
  };
  for (int k = 0; k < o.warm; k++) oneStep(o.warm < 25 && (k + 1) % std::max(1, o.warm / 2) == 0 ? 24 : k);  // at least two looks at the balance
  MPI_Barrier(world.handle());
  const PhaseTimes before = tools.times;
  m.before = comm.traffic();
  const double balanceBefore = tools.times[StepPhase::Balance];
  windowWork = workOf(tools.times);
  const auto start = WallClock::now();
  for (int k = 0; k < o.steps; k++) {
    const auto t = WallClock::now();
    oneStep(k);
    m.steps.push_back(since(t));
    m.ghosts += static_cast<double>(w.particles.ghosts) / o.steps;
    m.owned += static_cast<double>(w.particles.owned) / o.steps;
    if (k % 25 != 24) continue;
    const Traffic counted = comm.traffic();
    const Over now = over(workOf(tools.times) - windowWork, all);
    comm.traffic() = counted;  // without our own
    windowWork = workOf(tools.times);
    if (now.mean > 0) m.worst = std::max(m.worst, now.most / now.mean);
  }
  m.wall = since(start);
  const Traffic after = comm.traffic();
  m.balance = tools.times[StepPhase::Balance] - balanceBefore;
  MPI_Barrier(world.handle());  // copies: none stops while another one is measured

  const double n = o.steps;
  MpiReducer everyone(world);
  const Over work = over(workOf(tools.times) - workOf(before), everyone), mean = over(m.wall, everyone), start_s = over(startSeconds, everyone), balanced = over(m.balance, everyone);
  const Over stepTime = over(median(m.steps), everyone), owned = over(m.owned, everyone), halo = over(m.owned > 0 ? m.ghosts / m.owned : 0, everyone);
  const TrafficSummary t = gatherTraffic(after, m.before, everyone);
  // copies: the sum of what each does in the median of its steps
  const double particles = owned.mean * world.size(), rate = o.copies ? over(m.owned / median(m.steps), everyone).mean * world.size() : particles / stepTime.most;
  const auto& of = t.of;
  const auto at = [&](MessagesFor p) -> const TrafficSummary::Of& { return of[static_cast<std::size_t>(p)]; };
  if (world.rank() != 0) return 0;
  const double kib = 1024 * n;
  std::printf("%s,%s,%d,%.0f,%d,%.4f,%.4f,%.4f,%.4f,%.4f,%.4f,%.4f,%.4f,%.2f,%.2f,%.2f,%.2f,%.3f,%.3f,%.3f,%.3f,%.3f,%.2f,%.3f,%.3f,%.4f,%.4f,%.4f,%.2f\n", o.copies ? "copies" : "ranks", o.name.c_str(),
              world.size(), particles, o.steps, 1e3 * stepTime.most, 1e3 * mean.mean / n, rate / 1e6, work.mean > 0 ? work.most / work.mean : 1, m.worst, owned.most / owned.mean, halo.mean, halo.most,
              at(MessagesFor::Ghosts).messages.mean / n, at(MessagesFor::Ghosts).messages.most / n, t.messages.mean / n, t.messages.most / n, t.bytes.mean / kib, t.bytes.most / kib,
              at(MessagesFor::Ghosts).bytes.mean / kib, at(MessagesFor::Refresh).bytes.mean / kib, at(MessagesFor::Bonds).bytes.mean / kib, at(MessagesFor::Bonds).messages.mean / n,
              at(MessagesFor::Migration).bytes.mean / kib, static_cast<double>(t.collectives) / n, 1e3 * work.mean / n, 1e3 * t.waited.mean / n, 1e3 * balanced.mean / n, start_s.most);
  return 0;
}

int usage() {
  std::fprintf(stderr, "scaling --case fluid|corner --particles N [--copies] [--steps 50] [--warm 25] | --head\n");
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
    if (a + 1 == argc) return usage();
    const char* value = argv[++a];
    if (key == "--case") o.name = value;
    else if (key == "--particles") o.particles = std::atof(value);
    else if (key == "--steps") o.steps = std::atoi(value);
    else if (key == "--warm") o.warm = std::atoi(value);
    else return usage();
  }
  if ((o.name != "fluid" && o.name != "corner") || !(o.particles >= 1) || o.steps < 1 || o.warm < 0) return usage();
  MpiSession mpi(&argc, &argv);
  const Communicator world;
  return measure(o, world);
}
