// SPDX-License-Identifier: Apache-2.0
// time_to_solution: wall-clock seconds per simulated second, and the error, of two problems with each of
// thaw's solvers.
//   mpirun -n 4 time_to_solution [--only cube|beam] [--end 1] [--csv FILE] [--reference 1]
// cube.toml: the front of the water against that of a run with half the spacing (front.csv). --reference 1
// runs that reference and writes the file (10 minutes and more). beam.toml: half of the lowest tip position
// in the first swing against the deflection of a Timoshenko beam at rest.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <string>
#include <vector>

#include "benchmarks/support/options.hpp"
#include "benchmarks/support/rig.hpp"
#include "core/time/frame_times.hpp"
#include "io/scene/read_scene.hpp"

namespace {

using namespace thaw;
using namespace thaw::bench;

const std::string folder = THAW_BENCHMARK_FOLDER;
constexpr double sample = 0.01;  // s of simulated time between samples

struct Solver {
  const char *problem, *name;
  std::vector<std::string> set;
};

const std::vector<Solver>& solvers() {
  static const std::vector<Solver> all{
      {"cube", "state equation, 1 % compression", {"numerics.density=summation"}},
      {"cube",
       "state equation, 4 % compression",
       {"numerics.density=summation", "numerics.max_density_error=0.04"}},
      {"cube",
       "state equation, 4 % compression, steps 1.5 times as long",
       {"numerics.density=summation", "numerics.max_density_error=0.04", "numerics.cfl_sound=0.6"}},
      {"cube",
       "state equation, double precision",
       {"numerics.density=summation", "numerics.precision=double"}},
      {"cube", "incompressible to .01 %", {"numerics.pressure_solver=incompressible"}},
      {"cube",
       "incompressible to .1 %",
       {"numerics.pressure_solver=incompressible", "numerics.density_tolerance=0.001",
        "numerics.divergence_tolerance=0.01"}},
      {"cube",
       "incompressible to 1 %",
       {"numerics.pressure_solver=incompressible", "numerics.density_tolerance=0.01",
        "numerics.divergence_tolerance=0.05"}},
      {"cube", "density by continuity", {}},
      {"beam", "Green strain, double precision", {}},
      {"beam", "Green strain, single precision", {"numerics.elastic_precision=single"}},
      {"beam",
       "Green strain, single precision, steps 1.5 times as long",
       {"numerics.elastic_precision=single", "numerics.cfl_elastic=0.6"}},
      {"beam",
       "Green strain, single precision, steps twice as long",
       {"numerics.elastic_precision=single", "numerics.cfl_elastic=0.8"}},
      {"beam",
       "corotated, single precision",
       {"numerics.elastic_precision=single", "material.rubber.law=corotated"}},
      {"beam",
       "Neo-Hookean, single precision",
       {"numerics.elastic_precision=single", "material.rubber.law=neo-hookean"}},
  };
  return all;
}

struct Look {
  double time, value;
};

/// Position (m) beyond which a thousandth of the particles lies.
double frontOf(const Rig& r, const Communicator& comm) {
  const double step = 1e-3, low = r.w.scene.domain.min.x;
  std::vector<std::int64_t> count(static_cast<std::size_t>((r.w.scene.domain.max.x - low) / step) + 2, 0),
      all(count.size());
  for (std::size_t i = 0; i < r.w.particles.owned; i++)
    count[static_cast<std::size_t>(std::clamp((r.w.particles.position[i].x - low) / step, 0.0,
                                              static_cast<double>(count.size() - 1)))]++;
  MPI_Allreduce(count.data(), all.data(), static_cast<int>(count.size()), MPI_INT64_T, MPI_SUM,
                comm.handle());
  std::int64_t total = 0, beyond = 0;
  for (const std::int64_t n : all) total += n;
  std::size_t k = all.size();
  while (k > 0 && 1000 * beyond < total) beyond += all[--k];
  return low + static_cast<double>(k) * step;
}

/// Ids of the last layer of the beam on all ranks, ascending.
std::vector<std::uint64_t> tipIds(const Continuum& p, double spacing, const Communicator& comm) {
  std::vector<std::uint64_t> mine;
  for (std::size_t i = 0; i < p.owned; i++)
    if (p.position[i].x > 1.6 - spacing) mine.push_back(p.id[i]);
  int n = static_cast<int>(mine.size());
  std::vector<int> counts(static_cast<std::size_t>(comm.size())), first(counts.size() + 1, 0);
  MPI_Allgather(&n, 1, MPI_INT, counts.data(), 1, MPI_INT, comm.handle());
  for (std::size_t k = 0; k < counts.size(); k++) first[k + 1] = first[k] + counts[k];
  std::vector<std::uint64_t> all(static_cast<std::size_t>(first.back()));
  MPI_Allgatherv(mine.data(), n, MPI_UINT64_T, all.data(), counts.data(), first.data(), MPI_UINT64_T,
                 comm.handle());
  std::sort(all.begin(), all.end());
  return all;
}

/// Mean height (m) of the particles with these ids.
double tipOf(const Rig& r, const std::vector<std::uint64_t>& ids, const Communicator& comm) {
  double mine[2] = {0, 0}, all[2];
  for (std::size_t i = 0; i < r.w.particles.owned; i++)
    if (std::binary_search(ids.begin(), ids.end(), r.w.particles.id[i])) {
      mine[0] += r.w.particles.position[i].z;
      mine[1]++;
    }
  MPI_Allreduce(mine, all, 2, MPI_DOUBLE, MPI_SUM, comm.handle());
  return all[1] > 0 ? all[0] / all[1] : 0;
}

std::vector<Look> readFront() {
  std::ifstream file(folder + "/front.csv");
  std::vector<Look> all;
  std::string line;
  while (std::getline(file, line)) {
    Look l{};
    if (std::sscanf(line.c_str(), "%lf,%lf", &l.time, &l.value) == 2) all.push_back(l);
  }
  return all;
}

/// Largest distance of the fronts until the reference reaches the far wall, over the distance it has
/// travelled by then. Negative without a reference.
double frontError(const std::vector<Look>& looks) {
  double worst = -1;
  for (const Look& r : readFront()) {
    if (r.value > 2.9) break;
    for (const Look& l : looks)
      if (std::abs(l.time - r.time) < 0.25 * sample) worst = std::max(worst, std::abs(l.value - r.value) / 2);
  }
  return worst;
}

/// Error of half the lowest tip position in the first swing, against a beam at rest. The centre of the tip's
/// layer is half a spacing before the end. Shear after Timoshenko (T21) with kappa of Cowper (C66).
double beamError(const std::vector<Look>& looks) {
  const double E = 5e6, nu = 0.33, H = 0.4, L = 1.6, q = 1000 * 9.81 * H * H, x = L - 0.01,
               EI = E * std::pow(H, 4) / 12;
  const double kappa = 10 * (1 + nu) / (12 + 11 * nu), G = E / (2 * (1 + nu));
  const double rest = q * x * x * (x * x - 4 * L * x + 6 * L * L) / (24 * EI) +
                      q * (L * x - 0.5 * x * x) / (kappa * G * H * H);
  double lowest = 0;
  for (const Look& l : looks)
    if (l.time < 0.45) lowest = std::min(lowest, l.value);
  return std::abs(-0.5 * lowest / rest - 1);
}

struct Done {
  double wall = 0, particles = 0;
  std::int64_t steps = 0;
  std::vector<Look> looks;
  bool finite = true;
};

Done simulate(const Communicator& comm, const Solver& s, double end, std::vector<std::string> more) {
  more.insert(more.begin(), s.set.begin(), s.set.end());
  Done d;
  Scene scene = readScene(folder + "/" + s.problem + ".toml", more);
  scene.output.every = sample;  // limits the step so that samples are at the same times in every run
  std::vector<std::uint64_t> tip;
  Rig r(comm, scene, [&](const Continuum& p) { tip = tipIds(p, scene.spacing, comm); });
  const bool beam = std::string(s.problem) == "beam";
  double mine = static_cast<double>(r.w.particles.owned);
  MPI_Allreduce(&mine, &d.particles, 1, MPI_DOUBLE, MPI_SUM, comm.handle());
  MPI_Barrier(comm.handle());
  const auto start = std::chrono::steady_clock::now();
  r.w.clock.frame = 1;
  while (r.w.clock.time < end * (1 - 1e-9) && d.finite) {
    d.finite = r.step().finite;
    if (!frameDue(r.w.clock)) continue;
    d.looks.push_back({r.w.clock.time, beam ? tipOf(r, tip, comm) : frontOf(r, comm)});
    r.w.clock.frame++;
  }
  MPI_Barrier(comm.handle());
  d.wall = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count() / r.w.clock.time;
  d.steps = r.w.clock.step;
  return d;
}

}  // namespace

int main(int argc, char** argv) {
  MpiSession session(&argc, &argv);
  Communicator comm;
  std::string only, csv;
  double end = 1;
  bool reference = false;
  for (int a = 1; a < argc; a += 2) try {
      const std::string key = argv[a];
      const bool help = key == "--help" || key == "-h";
      if (help || a + 1 == argc) {
        if (comm.rank() == 0)
          std::fprintf(help ? stdout : stderr,
                       "time_to_solution [--only cube|beam] [--end 1] [--csv FILE] [--reference 1]\n");
        return help ? 0 : 2;
      }
      if (key == "--only") oneOf(key, only = argv[a + 1], {"cube", "beam"});
      else if (key == "--end") end = numberOf(key, argv[a + 1], 1e-4, 1000);
      else if (key == "--csv") csv = argv[a + 1];
      else if (key == "--reference") reference = oneOf(key, argv[a + 1], {"0", "1"}) == 1;
      else throw std::invalid_argument("unknown option " + key);
    } catch (const std::invalid_argument& e) {
      if (comm.rank() == 0) std::fprintf(stderr, "time_to_solution: %s\n", e.what());
      return 2;
    }
  const bool first = comm.rank() == 0;
  if (reference) {
    const Done d = simulate(comm, solvers()[0], 0.5, {"spacing=0.01"});
    if (!first) return 0;
    FILE* file = std::fopen((folder + "/front.csv").c_str(), "w");
    if (!file) return std::fprintf(stderr, "%s/front.csv: cannot be written\n", folder.c_str()), 3;
    std::fprintf(file,
                 "# s, m: beyond which is a thousandth of the water of cube.toml with spacing 1 cm, %.0f "
                 "particles, %lld steps\n",
                 d.particles, static_cast<long long>(d.steps));
    for (const Look& l : d.looks) std::fprintf(file, "%.4f,%.4f\n", l.time, l.value);
    std::fclose(file);
    return 0;
  }
  FILE* out = !first ? nullptr : csv.empty() ? stdout : std::fopen(csv.c_str(), "w");
  if (first && !out) return std::fprintf(stderr, "%s: cannot be written\n", csv.c_str()), 3;
  if (first)
    std::fprintf(
        out,
        "case,solver,ranks,particles,steps,wall_s_per_s,target_wall_s_per_s,best_peer_wall_s_per_s,error\n");
  for (const Solver& s : solvers()) {
    if (!only.empty() && only != s.problem) continue;
    const Done d = simulate(comm, s, end, {});
    if (!first) continue;
    const bool beam = std::string(s.problem) == "beam";
    const double error = !d.finite ? NAN : beam ? beamError(d.looks) : frontError(d.looks);
    std::fprintf(out, "%s,\"%s\",%d,%.0f,%lld,%.2f,15,%d,%.4f\n", s.problem, s.name, comm.size(), d.particles,
                 static_cast<long long>(d.steps), d.wall, beam ? 69 : 89, error);
    std::fflush(out);
  }
  if (first && !csv.empty()) std::fclose(out);
  return 0;
}
