// Particle-steps a second and core of the fluid step and of the elastic step, on jittered lattices with a free surface, with the
// phase split, and beside it a plain scalar neighbour-list code as yardstick: a ratio means the same on any machine.
//   scripts/bench step [--sizes 100000,1000000] [--repeat 5] [--support 2] [--precision single|double] [--csv FILE]
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>
#include <vector>

#include "benchmarks/support/elastic.hpp"
#include "benchmarks/support/yardstick.hpp"
#include "core/time/integrate.hpp"
#include "tests/support/lattice.hpp"

namespace {

using namespace thaw;
using Clock_ = std::chrono::steady_clock;

struct Phases { double sort = 0, search = 0, density = 0, force = 0, move = 0; double total() const { return sort + search + density + force + move; } };

double since(Clock_::time_point& t) {
  const auto now = Clock_::now();
  const double s = std::chrono::duration<double>(now - t).count();
  t = now;
  return s;
}

/// One fluid step as core/step does it on one rank: sort, search, filling, pressure, forces with heat, leap-frog.
Phases fluidStep(test::Block& b, const PairKernels& k) {
  Phases ph;
  auto t = Clock_::now();
  Continuum& p = b.particles;
  const RecordContext x{b.scene, b.modules, b.grid, b.liquids};
  computeCellKeys(b.grid, p);
  sortByCell(p, {}, b.sort, b.cells);
  const std::uint32_t n = static_cast<std::uint32_t>(p.owned);
  resizeRecords(x, n, b.records);
  packRecords(x, p, 0, n, b.records);
  ph.sort = since(t);
  b.findNeighbours(k, false);
  ph.search = since(t);
  std::int64_t coincident = 0;
  const PairSums s = b.sums(&coincident);
  k.density(s, b.groups());
  packPressure(x, p, 0, n, b.records);
  ph.density = since(t);
  std::fill_n(p.force.data(), n, Vec3d{});
  std::fill_n(p.heatFlow.data(), n, 0.0);
  std::fill_n(p.dissipation.data(), n, 0.0);
  k.forces(s, b.groups());
  ph.force = since(t);
  const double dt = 1e-6, half = 0.5 * dt;
  for (std::size_t i = 0; i < n; i++) {
    p.acceleration[i] = p.force[i] / p.mass[i];
    p.velocity[i] += p.acceleration[i] * dt;
    p.temperature[i] += half * p.heatFlow[i];
    p.position[i] += p.velocity[i] * dt;
  }
  ph.move = since(t);
  return ph;
}

double median(std::vector<double> v) {
  std::sort(v.begin(), v.end());
  return v[v.size() / 2];
}

std::vector<std::size_t> sizesFrom(const char* list) {
  std::vector<std::size_t> all;
  for (const char* at = list; *at; at = *at == ',' ? at + 1 : at) {
    char* end = nullptr;
    all.push_back(std::strtoull(at, &end, 10));
    if (end == at) break;
    at = end;
  }
  return all;
}

}  // namespace

int main(int argc, char** argv) {
  std::vector<std::size_t> sizes{100000, 1000000};
  int repeat = 5;
  double support = 2;
  Precision precision = Precision::Single;
  const char* csv = nullptr;
  for (int a = 1; a < argc; a += 2) {
    const std::string key = argv[a];
    const bool help = key == "-h" || key == "--help";
    if (help || a + 1 == argc) {
      std::fprintf(help ? stdout : stderr, "%sscripts/bench step [--sizes 100000,1000000] [--repeat 5] [--support 2] [--precision single|double] [--csv FILE]\n", help ? "" : "an option without a value; ");
      return help ? 0 : 2;
    }
    if (key == "--sizes") sizes = sizesFrom(argv[a + 1]);
    else if (key == "--repeat") repeat = std::atoi(argv[a + 1]);
    else if (key == "--support") support = std::atof(argv[a + 1]);
    else if (key == "--precision") precision = std::strcmp(argv[a + 1], "double") == 0 ? Precision::Double : Precision::Single;
    else if (key == "--csv") csv = argv[a + 1];
    else return std::fprintf(stderr, "unknown option %s\n", argv[a]), 2;
  }
  if (repeat < 1 || support < 1) return std::fprintf(stderr, "--repeat must be at least 1, --support at least 1\n"), 2;
  const PairKernels& k = *pairKernels();
  FILE* out = csv ? std::fopen(csv, "w") : stdout;
  if (!out) return std::fprintf(stderr, "%s: cannot be written\n", csv), 3;
  std::fprintf(out, "case,particles,neighbours,precision,isa,msteps_per_s,yardstick_msteps_per_s,ratio,target_ratio,ns_sort,ns_search,ns_density,ns_force,ns_move,bytes_per_particle,repeats\n");
  for (std::size_t size : sizes) {
    const int n = static_cast<int>(std::lround(std::cbrt(static_cast<double>(size))));
    test::Block b(n, 0.1, support, precision);
    const double N = static_cast<double>(b.particles.owned);
    std::vector<double> total, yard;
    Phases best, ph;
    b.findNeighbours(k);
    fluidStep(b, k);
    for (int r = 0; r < repeat; r++) {
      ph = fluidStep(b, k);
      total.push_back(ph.total());
      if (best.total() == 0 || ph.total() < best.total()) best = ph;
      yard.push_back(bench::yardstickStep(b));  // in turn, so that a noisy machine slows both
    }
    double neighbours = 0;
    for (std::size_t i = 0; i < b.particles.owned; i++) neighbours += b.lists.neighbours[i];
    std::size_t bytes = b.lists.list.capacity() * 4 + b.records.fixed.capacity() + b.records.place.capacity() + b.records.motion.capacity() + b.records.state.capacity();
    for (AnyColumn* c : {static_cast<AnyColumn*>(&b.particles.id), static_cast<AnyColumn*>(&b.particles.position), static_cast<AnyColumn*>(&b.particles.velocity),
                         static_cast<AnyColumn*>(&b.particles.acceleration), static_cast<AnyColumn*>(&b.particles.mass), static_cast<AnyColumn*>(&b.particles.force),
                         static_cast<AnyColumn*>(&b.particles.filling), static_cast<AnyColumn*>(&b.particles.pressure), static_cast<AnyColumn*>(&b.particles.temperature),
                         static_cast<AnyColumn*>(&b.particles.enthalpy), static_cast<AnyColumn*>(&b.particles.heatFlow), static_cast<AnyColumn*>(&b.particles.dissipated),
                         static_cast<AnyColumn*>(&b.particles.dissipation), static_cast<AnyColumn*>(&b.particles.cell), static_cast<AnyColumn*>(&b.particles.nextCell)})
      bytes += c->elementBytes * b.particles.owned;
    const double rate = N / median(total) / 1e6, yardRate = N / median(yard) / 1e6;
    std::fprintf(out, "fluid,%.0f,%.1f,%s,%s,%.3f,%.3f,%.2f,2.75,%.1f,%.1f,%.1f,%.1f,%.1f,%.0f,%d\n", N, neighbours / N, precision == Precision::Single ? "single" : "double", k.name, rate,
                 yardRate, rate / yardRate, 1e9 * best.sort / N, 1e9 * best.search / N, 1e9 * best.density / N, 1e9 * best.force / N, 1e9 * best.move / N, static_cast<double>(bytes) / N, repeat);
    // the elastic step beside the same yardstick; ns_density is its phase 1 (deformation and stress), ns_sort the copy to slots
    const bench::ElasticFigures e = bench::elasticFigures(n, support, precision, repeat);
    const double elasticRate = e.particles / e.total / 1e6;
    std::fprintf(out, "elastic,%.0f,%.1f,%s,%s,%.3f,%.3f,%.2f,4.2,%.1f,0,%.1f,%.1f,%.1f,%.0f,%d\n", e.particles, e.neighbours, precision == Precision::Single ? "single" : "double", k.name,
                 elasticRate, yardRate, elasticRate / yardRate, 1e9 * e.copy / e.particles, 1e9 * e.deformation / e.particles, 1e9 * e.forces / e.particles, 1e9 * e.move / e.particles,
                 e.bytesPerParticle, repeat);
    std::fflush(out);
  }
  if (csv) std::fclose(out);
  return 0;
}
