// SPDX-License-Identifier: Apache-2.0
// step: particle-steps per second and core of whole steps, with MPI and halos, on the ranks of the launch.
// benchmarks/step/run starts it on 1, 2 and 4. `default` is the precision of scenes: sums over neighbours in
// single, bonds in double.
//   step [--cases fluid,heat,elastic,mixed,mesh,carried] [--precisions single,double,default]
//   [--supports 2.13,2.6] [--sizes 100000,1000000] [--repeat 7] [--seconds 0.6] [--csv FILE] [--append 1]
//   [--memory 1]
// A plain scalar neighbour-list code (yardstick) runs in turn with each case on as many ranks. The ratio thus
// depends neither on the machine nor on its load. Rows also have the bytes that a step moves, and those of
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

/// Moves particles by up to a tenth of a spacing along each axis. Turns the block by one radian about (1, 2,
/// 2), so that no row of particles changes cells at once.
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
/// twice, bonds are read twice, particles and solids are read and written.
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

/// Measured times of the blocks of steps, each followed by a step of the scalar code.
struct StepTimes {
  int steps = 0;               ///< in all
  std::vector<double> step;    ///< s, of a whole step
  std::vector<double> scalar;  ///< s, per particle and step of the scalar code on the slowest rank
  std::vector<double> ratio;   ///< scalar code's time per particle and core over that of a step
};

/// Returns seconds per step of n steps on the slowest rank. Collective.
double timeSteps(Rig& rig, const Communicator& comm, int n) {
  MPI_Barrier(comm.handle());
  const auto t = Watch::now();
  for (int k = 0; k < n; k++) thaw::step(rig.w, rig.halos(), rig.tools, {});
  return mostOf(comm, secondsSince(t)) / n;
}

/// steps: number in a block. Collective.
StepTimes timeBlocks(Rig& rig, const Communicator& comm, const Options& o, double support, int steps) {
  const double ranks = comm.size(), N = sumOver(comm, static_cast<double>(rig.w.particles.owned));
  Yardstick yardstick;
  test::Block block(46, 0.1, support, Precision::Single);  // 97,336 on every rank
  StepTimes t;
  for (int r = 0; r < o.repeat; r++, t.steps += steps) {
    t.step.push_back(timeSteps(rig, comm, steps));
    MPI_Barrier(comm.handle());
    yardstickStep(block, yardstick);  // fills the caches, as the measured steps do
    t.scalar.push_back(mostOf(comm, yardstickStep(block, yardstick)) /
                       static_cast<double>(block.particles.owned));
    t.ratio.push_back(t.scalar.back() / (t.step.back() * ranks / N));
  }
  return t;
}

/// Bytes on all ranks.
struct CaseMemory {
  std::vector<MemoryUse> uses;
  double messages = 0, resident = 0;
  double moved = 0;            ///< by a step, at least (bytesMoved)
  double copiedPerSecond = 0;  ///< copy of an array, on the first rank
};

CaseMemory memoryOfCase(const Rig& rig, const Communicator& comm, double resident) {
  CaseMemory m;
  m.resident = resident;
  m.messages = sumOver(comm, static_cast<double>(rig.tables.cells->bufferBytes()));
  m.uses = memoryOf(rig.w, rig.tools);
  for (MemoryUse& u : m.uses) u.bytes = sumOver(comm, u.bytes);
  m.moved = sumOver(comm, bytesMoved(rig));
  m.copiedPerSecond = copySpeed(comm);
  return m;
}

/// Mean number of neighbours of a particle, or of bonds in elastic cases. Collective.
double meanNeighbours(const Rig& rig, const Communicator& comm, Kind kind, double N) {
  double neighbours = 0;
  for (std::size_t i = 0; i < rig.w.neighbours.neighbours.size() && !isElastic(kind); i++)
    neighbours += rig.w.neighbours.neighbours[i];
  for (std::size_t s = 0; s < rig.w.solids.owned && isElastic(kind); s++)
    for (int k = 0; k < rig.w.bonds.capacity; k++) neighbours += rig.w.bonds.hasBond(s, k);
  return sumOver(comm, neighbours) / N;
}

/// Results of a case, over all ranks.
struct Measurement {
  int ranks = 1;
  double particles = 0, neighbours = 0;
  double ghosts = 0, mostOwned = 0;  ///< ghosts on all ranks; particles of the fullest rank
  const char* instructions = "";
  double setUp = 0;  ///< s
  StepTimes times;
  PhaseTimes phases;  ///< s, mean over ranks
  CaseMemory memory;
  double perNs() const { return 1e9 * ranks / (particles * times.steps); }  ///< ns per particle-step and s
};

/// Sets up a case and measures it. Collective.
Measurement measured(const Communicator& comm, const Case& c, const Options& o, const std::string& ball) {
  malloc_trim(0);  // frees the memory of the case before
  const double before = residentBytes();
  const auto setUp = Watch::now();
  const Scene scene = sceneOf(c, ball);
  Rig rig(
      comm, scene, [&](Continuum& p) { jitter(p, scene); }, meshLoader());
  Measurement m;
  m.setUp = mostOf(comm, secondsSince(setUp));
  m.ranks = comm.size();
  m.particles = sumOver(comm, static_cast<double>(rig.w.particles.owned));
  m.instructions = rig.tools.sums.kernels->name;
  rig.settle();
  const double warm = timeSteps(rig, comm, 3);
  const int steps = std::max(1, static_cast<int>(std::lround(o.seconds / warm)));
  rig.tools.times = {};
  const double resident = sumOver(comm, residentBytes() - before);
  m.times = timeBlocks(rig, comm, o, c.support, steps);
  for (std::size_t k = 0; k < stepPhases; k++)
    m.phases.seconds[k] = sumOver(comm, rig.tools.times.seconds[k]) / comm.size();
  m.memory = memoryOfCase(rig, comm, resident);
  m.neighbours = meanNeighbours(rig, comm, c.kind, m.particles);
  m.ghosts = sumOver(comm, static_cast<double>(rig.w.particles.ghosts));
  m.mostOwned = mostOf(comm, static_cast<double>(rig.w.particles.owned));
  return m;
}

void printMemory(const Measurement& m) {
  const double N = m.particles;
  std::fprintf(stderr, "  %.3f ghosts per particle, the fullest rank has %.3f of the mean\n", m.ghosts / N,
               m.mostOwned * m.ranks / N);
  for (const MemoryUse& u : m.memory.uses)
    if (u.bytes > 0) std::fprintf(stderr, "  %-20s %6.0f bytes per particle\n", u.what, u.bytes / N);
  std::fprintf(stderr, "  %-20s %6.0f bytes per particle\n", "messages", m.memory.messages / N);
}

void printPhases(const Measurement& m, FILE* out) {
  const auto ns = [&](std::initializer_list<StepPhase> phases) {
    double sum = 0;
    for (const StepPhase p : phases) sum += m.phases[p] * m.perNs();
    return sum;
  };
  using P = StepPhase;
  std::fprintf(out, "%.1f,%.1f,%.1f,%.1f,%.1f,%.1f,%.1f,%.1f,%.1f,", ns({P::Sort}), ns({P::Search}),
               ns({P::Density}), ns({P::Forces}), ns({P::Elastic, P::Bonds}), ns({P::Walls, P::Contact}),
               ns({P::Heat}), ns({P::Drift, P::Domain, P::Kick, P::Phase}),
               ns({P::Migrate, P::Exchange, P::Reduce}));
}

/// Target of the bytes per particle; 0: none.
double targetBytes(const Case& c) {
  if (isElastic(c.kind)) return 800;
  return c.kind == Kind::Fluid && c.support < support33 + 0.1 && c.precision == Precision::Single ? 350 : 0;
}

void printRow(const Measurement& m, const Case& c, const Options& o, FILE* out) {
  const double N = m.particles, rate = N / (median(m.times.step) * m.ranks) / 1e6,
               ratio = median(m.times.ratio), scalar = median(m.times.scalar);
  const Targets goal = targetsOf(c, std::strcmp(m.instructions, "avx512") == 0);
  std::fprintf(out, "%s,%s,%d,%.0f,%.1f,%s,%.3f,%.3f,%.2f,", caseNames[static_cast<int>(c.kind)],
               c.precision == Precision::Double ? "double"
               : c.elastic == Precision::Double ? "default"
                                                : "single",
               m.ranks, N, m.neighbours, m.instructions, rate, 1e-6 / scalar, ratio);
  goal.target > 0 ? std::fprintf(out, "%.2f,%.2f,", goal.target, goal.limit) : std::fprintf(out, ",,");
  printPhases(m, out);
  const double accounted = m.memory.messages + totalBytes(m.memory.uses), goalBytes = targetBytes(c);
  std::fprintf(out, "%.0f,%.0f,", accounted / N, m.memory.resident / N);
  goalBytes > 0 ? std::fprintf(out, "%.0f,", goalBytes) : std::fprintf(out, ",");
  const std::string slowest = limitingPhase(c, m.phases, m.perNs(), 1e9 * scalar,
                                            goal.limit > 0 && ratio >= goal.limit);
  std::fprintf(out, "%.0f,%.2f,%.2f,%.2f,%s,%d\n", m.memory.moved / N,
               1e-9 * m.memory.moved / (N / (rate * 1e6 * m.ranks)) / m.ranks,
               1e-9 * m.memory.copiedPerSecond, m.setUp / median(m.times.step), slowest.c_str(), o.repeat);
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
  const auto measure = [&](const Case& c) {
    const Measurement m = measured(comm, c, o, ball.path());
    if (out && o.memory) printMemory(m);
    if (out) printRow(m, c, o, out);
  };
  for (const std::size_t size : o.sizes)
    for (const double support : o.supports)
      for (const auto& [sums, bonds] : o.precisions)
        for (const Kind kind : o.kinds) measure({kind, sums, bonds, support, size});
  if (out && o.csv) std::fclose(out);
  return 0;
}
