// SPDX-License-Identifier: Apache-2.0
// step: particle-steps per second and core of whole steps, with MPI and halos, on the ranks of the launch.
// benchmarks/step/run starts it on 1, 2 and 4. `default` is the precision of scenes: sums over neighbours in
// single, bonds in double.
//   step [--cases fluid,heat,elastic,mixed,mesh,carried] [--precisions single,double,default]
//   [--supports 2.13,2.6] [--sizes 100000,1000000] [--repeat 7] [--seconds 0.6] [--csv FILE] [--append 1]
//   [--memory 1]
// A plain scalar neighbour-list code (yardstick) runs in turn with each case on as many ranks, so that the
// ratio does not depend on the machine or its load. Rows also have the bytes that a step moves, and those of
// a copy in the same time.
#include <malloc.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <string>
#include <vector>

#include "benchmarks/step/ball.hpp"
#include "benchmarks/step/cases.hpp"
#include "benchmarks/support/options.hpp"
#include "benchmarks/support/rig.hpp"
#include "benchmarks/support/yardstick.hpp"
#include "core/math/hash_random.hpp"
#include "core/simulation/memory.hpp"
#include "io/scene/scene_for_all.hpp"

namespace {

using namespace thaw;
using namespace thaw::bench;
using Watch = std::chrono::steady_clock;

double secondsSince(Watch::time_point t) { return std::chrono::duration<double>(Watch::now() - t).count(); }

double median(std::vector<double> v) {
  std::sort(v.begin(), v.end());
  return v[v.size() / 2];
}

double sumOver(const Communicator& comm, double mine) {
  double all = 0;
  MPI_Allreduce(&mine, &all, 1, MPI_DOUBLE, MPI_SUM, comm.handle());
  return all;
}
double mostOf(const Communicator& comm, double mine) {
  double all = 0;
  MPI_Allreduce(&mine, &all, 1, MPI_DOUBLE, MPI_MAX, comm.handle());
  return all;
}

/// Resident memory of this process, in bytes.
double residentBytes() {
  std::ifstream file("/proc/self/statm");
  double pages = 0, resident = 0;
  file >> pages >> resident;
  return resident * 4096;
}

/// Moves particles by up to a tenth of a spacing along each axis and turns the block by one radian about (1,
/// 2, 2), so that no row of particles changes cells at once.
void jitter(Continuum& p, const Scene& scene) {
  const Vec3d axis{1.0 / 3, 2.0 / 3, 2.0 / 3}, centre = scene.bodies[0].shape.move;
  for (std::size_t i = 0; i < p.owned; i++) {
    Vec3d x = p.position[i] - centre;
    for (int a = 0; a < 3; a++)
      x[a] += 0.1 * scene.spacing *
              (2 * randomUniform(1, Purpose::Separate, p.id[i], static_cast<std::uint64_t>(a)) - 1);
    p.position[i] = centre + x * std::cos(1.0) + cross(axis, x) * std::sin(1.0) +
                    axis * (dot(axis, x) * (1 - std::cos(1.0)));
  }
}

/// Bytes per second and rank that a copy reads and writes on all ranks at once.
double copySpeed(const Communicator& comm) {
  const std::size_t n = 16 << 20;  // four times the largest caches
  std::vector<double> from(n, 1), to(n, 0);
  std::vector<double> speed;
  for (int r = 0; r < 7; r++) {
    MPI_Barrier(comm.handle());
    const auto t = Watch::now();
    for (std::size_t i = 0; i < n; i++) to[i] = from[i];
    speed.push_back(16.0 * static_cast<double>(n) / secondsSince(t));
    from[static_cast<std::size_t>(r)] = to[static_cast<std::size_t>(r) + 1] + 1;
  }
  return median(speed);
}

/// Minimum number of bytes that a step moves. Neighbour lists and pair records are written once and read
/// twice, bonds are read twice, particles and slots are read and written.
double bytesMoved(const Rig& rig) {
  double sum = 0;
  for (const MemoryUse& u : memoryOf(rig.w, rig.tools)) {
    const std::string name = u.what;
    sum += u.bytes * (name == "neighbour lists" || name == "pair records" ? 3 : 2);
  }
  return sum;
}

struct Options {
  std::vector<Kind> kinds{Kind::Fluid, Kind::Heat, Kind::Elastic, Kind::Mixed};
  /// precisions of sums over neighbours and of bonds
  std::vector<std::pair<Precision, Precision>> precisions{{Precision::Single, Precision::Single}};
  std::vector<double> supports{support33};
  std::vector<std::size_t> sizes{100000};
  int repeat = 7;
  double seconds = 0.6;  ///< seconds of steps between two measurements of the scalar code
  const char* csv = nullptr;
  bool append = false, memory = false, help = false;
};

/// The phase furthest above its limit where the prototypes' phases are known (forces include leap-frog), else
/// the longest phase.
std::string limitingPhase(const Case& c, const PhaseTimes& t, double perNs, double yardNs, bool atLimit) {
  if (atLimit) return "none: at the limit";
  const std::vector<double> limits = limitPhases(c);
  std::string most;
  double worst = 0;
  for (std::size_t k = 0; k < stepPhases; k++) {
    const auto phase = static_cast<StepPhase>(k);
    double ns = t[phase] * perNs;
    if (!limits.empty()) {
      if (phase == StepPhase::Drift || phase == StepPhase::Kick) continue;
      if (phase == StepPhase::Forces)
        ns += (t[StepPhase::Drift] + t[StepPhase::Kick]) * perNs - limits[3] * yardNs;
      if (phase == StepPhase::Sort) ns -= limits[0] * yardNs;
      if (phase == StepPhase::Search) ns -= limits[1] * yardNs;
      if (phase == StepPhase::Density) ns -= limits[2] * yardNs;
    }
    if (ns > worst) worst = ns, most = phaseName(phase);
  }
  return most;
}

void measure(const Communicator& comm, const Case& c, const Options& o, const std::string& ball, FILE* out) {
  malloc_trim(0);  // frees the memory of the case before
  const double before = residentBytes();
  const auto setUp = Watch::now();
  const Scene scene = sceneOf(c, ball);
  Rig rig(
      comm, scene, [&](Continuum& p) { jitter(p, scene); }, meshLoader());
  const double setUpSeconds = mostOf(comm, secondsSince(setUp));
  const double ranks = comm.size(), N = sumOver(comm, static_cast<double>(rig.w.particles.owned));
  const auto steps = [&](int n) {
    MPI_Barrier(comm.handle());
    const auto t = Watch::now();
    for (int k = 0; k < n; k++) thaw::step(rig.w, rig.halos(), rig.tools, {});
    return mostOf(comm, secondsSince(t)) / n;
  };
  rig.settle();
  const double warm = steps(3);
  const int some = std::max(1, static_cast<int>(std::lround(o.seconds / warm)));
  rig.tools.times = {};
  const double resident = sumOver(comm, residentBytes() - before);
  Yardstick yardstick;
  test::Block block(46, 0.1, c.support, Precision::Single);  // 97,336 on every rank
  std::vector<double> total, yard, ratio;
  int done = 0;
  for (int r = 0; r < o.repeat; r++, done += some) {
    total.push_back(steps(some));
    MPI_Barrier(comm.handle());
    yardstickStep(block, yardstick);  // fills the caches, as the measured steps do
    yard.push_back(mostOf(comm, yardstickStep(block, yardstick)) /
                   static_cast<double>(block.particles.owned));
    ratio.push_back(yard.back() / (total.back() * ranks / N));
  }
  PhaseTimes times;
  for (std::size_t k = 0; k < stepPhases; k++)
    times.seconds[k] = sumOver(comm, rig.tools.times.seconds[k]) / ranks;
  const double messages = sumOver(comm, static_cast<double>(rig.tables.cells->bufferBytes()));
  std::vector<MemoryUse> use = memoryOf(rig.w, rig.tools);
  for (MemoryUse& u : use) u.bytes = sumOver(comm, u.bytes);
  const double accounted = messages + totalBytes(use), moved = sumOver(comm, bytesMoved(rig));
  const double copied = copySpeed(comm);  // bytes/s of the first rank
  double neighbours = 0;
  for (std::size_t i = 0; i < rig.w.neighbours.neighbours.size() && !isElastic(c.kind); i++)
    neighbours += rig.w.neighbours.neighbours[i];
  for (std::size_t s = 0; s < rig.w.solids.owned && isElastic(c.kind); s++)
    for (int k = 0; k < rig.w.bonds.capacity; k++) neighbours += rig.w.bonds.hasBond(s, k);
  neighbours = sumOver(comm, neighbours) / N;
  const double ghosts = sumOver(comm, static_cast<double>(rig.w.particles.ghosts)),
               most = mostOf(comm, static_cast<double>(rig.w.particles.owned));
  if (comm.rank() != 0) return;
  if (o.memory) {
    std::fprintf(stderr, "  %.3f ghosts per particle, the fullest rank has %.3f of the mean\n", ghosts / N,
                 most * ranks / N);
    for (const MemoryUse& u : use)
      if (u.bytes > 0) std::fprintf(stderr, "  %-20s %6.0f bytes per particle\n", u.what, u.bytes / N);
    std::fprintf(stderr, "  %-20s %6.0f bytes per particle\n", "messages", messages / N);
  }
  const Targets goal = targetsOf(c, std::strcmp(rig.tools.kernels->name, "avx512") == 0);
  const double perNs = 1e9 * ranks / (N * done), rate = N / (median(total) * ranks) / 1e6;
  const auto ns = [&](std::initializer_list<StepPhase> phases) {
    double sum = 0;
    for (const StepPhase p : phases) sum += times[p] * perNs;
    return sum;
  };
  using P = StepPhase;
  std::fprintf(out, "%s,%s,%d,%.0f,%.1f,%s,%.3f,%.3f,%.2f,", caseNames[static_cast<int>(c.kind)],
               c.precision == Precision::Double ? "double"
               : c.elastic == Precision::Double ? "default"
                                                : "single",
               comm.size(), N, neighbours, rig.tools.kernels->name, rate, 1e-6 / median(yard), median(ratio));
  goal.excellent > 0 ? std::fprintf(out, "%.2f,%.2f,", goal.excellent, goal.limit) : std::fprintf(out, ",,");
  std::fprintf(out, "%.1f,%.1f,%.1f,%.1f,%.1f,%.1f,%.1f,%.1f,%.1f,", ns({P::Sort}), ns({P::Search}),
               ns({P::Density}), ns({P::Forces}), ns({P::Elastic, P::Bonds}), ns({P::Walls, P::Contact}),
               ns({P::Heat}), ns({P::Drift, P::Domain, P::Kick, P::Phase}),
               ns({P::Migrate, P::Exchange, P::Reduce}));
  const double goalBytes = isElastic(c.kind) ? 800
                           : c.kind == Kind::Fluid && c.support < support33 + 0.1 &&
                                   c.precision == Precision::Single
                               ? 350
                               : 0;
  std::fprintf(out, "%.0f,%.0f,", accounted / N, resident / N);
  goalBytes > 0 ? std::fprintf(out, "%.0f,", goalBytes) : std::fprintf(out, ",");
  std::fprintf(
      out, "%.0f,%.2f,%.2f,%.2f,%s,%d\n", moved / N, 1e-9 * moved / (N / (rate * 1e6 * ranks)) / ranks / 1.0,
      1e-9 * copied, setUpSeconds / median(total),
      limitingPhase(c, times, perNs, 1e9 * median(yard), goal.limit > 0 && median(ratio) >= goal.limit)
          .c_str(),
      o.repeat);
  std::fflush(out);
}

template<class T, class Read> std::vector<T> listOf(const std::string& text, Read read) {
  std::vector<T> all;
  for (std::size_t at = 0; at <= text.size();) {
    const std::size_t end = std::min(text.find(',', at), text.size());
    all.push_back(read(text.substr(at, end - at)));
    at = end + 1;
  }
  return all;
}

constexpr const char* usage =
    "step [--cases fluid,heat,elastic,mixed,mesh,carried] [--precisions single,double,default] [--supports "
    "2.13,2.6] [--sizes 100000,1000000] [--repeat 7] [--seconds 0.6] [--csv FILE] [--append 1] [--memory "
    "1]\n";

Options optionsOf(int argc, char** argv) {
  Options o;
  for (int a = 1; a < argc; a += 2) {
    const std::string key = argv[a];
    o.help = o.help || key == "--help" || key == "-h";
    if (o.help) return o;
    if (a + 1 == argc) throw std::invalid_argument(key + ": expected a value");
    const std::string value = argv[a + 1];
    if (key == "--cases")
      o.kinds = listOf<Kind>(value, [&](const std::string& name) {
        return static_cast<Kind>(oneOf(key, name, {"fluid", "heat", "elastic", "mixed", "mesh", "carried"}));
      });
    else if (key == "--precisions")
      o.precisions = listOf<std::pair<Precision, Precision>>(value, [&](const std::string& name) {
        const std::size_t k = oneOf(key, name, {"single", "double", "default"});
        return std::pair{k == 1 ? Precision::Double : Precision::Single,
                         k == 0 ? Precision::Single : Precision::Double};
      });
    else if (key == "--supports")
      o.supports = listOf<double>(value, [&](const std::string& x) { return numberOf(key, x, 1.5, 4); });
    else if (key == "--sizes")
      o.sizes = listOf<std::size_t>(value,
                                    [&](const std::string& x) { return countOf(key, x, 1000, 1000000000); });
    else if (key == "--repeat") o.repeat = static_cast<int>(countOf(key, value, 1, 10000));
    else if (key == "--seconds") o.seconds = numberOf(key, value, 0, 3600);
    else if (key == "--csv") o.csv = argv[a + 1];
    else if (key == "--append") o.append = oneOf(key, value, {"0", "1"}) == 1;
    else if (key == "--memory") o.memory = oneOf(key, value, {"0", "1"}) == 1;
    else throw std::invalid_argument("unknown option " + key);
  }
  return o;
}

}  // namespace

int main(int argc, char** argv) {
  MpiSession session(&argc, &argv);
  Communicator comm;
  Options o;
  try {
    o = optionsOf(argc, argv);
  } catch (const std::invalid_argument& e) {
    if (comm.rank() == 0) std::fprintf(stderr, "step: %s\n%s", e.what(), usage);
    return 2;
  }
  if (o.help) return comm.rank() == 0 ? std::printf("%s", usage), 0 : 0;
  FILE* out = comm.rank() != 0 ? nullptr : o.csv ? std::fopen(o.csv, o.append ? "a" : "w") : stdout;
  if (comm.rank() == 0 && !out) return std::fprintf(stderr, "%s: cannot be written\n", o.csv), 3;
  if (out && !o.append)
    std::fprintf(out,
                 "case,precision,ranks,particles,neighbours,isa,msteps_per_s,yardstick_msteps_per_s,ratio,"
                 "target_ratio,limit_ratio,ns_sort,ns_search,ns_density,ns_force,ns_elastic,"
                 "ns_walls,ns_heat,ns_move,ns_ranks,bytes_per_particle,resident_per_particle,target_bytes_"
                 "per_particle,bytes_moved,moved_gb_per_s,copy_gb_per_s,setup_steps,held_back_by,repeats\n");
  const BallFile ball(comm);
  for (const std::size_t size : o.sizes)
    for (const double support : o.supports)
      for (const auto& [sums, bonds] : o.precisions)
        for (const Kind kind : o.kinds)
          measure(comm, {kind, sums, bonds, support, size}, o, ball.path(), out);
  if (out && o.csv) std::fclose(out);
  return 0;
}
