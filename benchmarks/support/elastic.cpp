#include "benchmarks/support/elastic.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <vector>

#include "core/solid/bond_records.hpp"
#include "core/solid/elastic.hpp"

namespace thaw::bench {

namespace {

using Watch = std::chrono::steady_clock;

struct Block {
  Scene scene;
  Modules modules;
  CellGrid grid;
  Continuum particles;
  Solids solids;
  Bonds bonds;
  ElasticWork work;
  double neighbours = 0;
};

double jitter(std::size_t i, int axis) {
  std::uint64_t z = (i * 3 + static_cast<std::size_t>(axis)) * 0x9e3779b97f4a7c15ull;
  z = (z ^ z >> 30) * 0xbf58476d1ce4e5b9ull;
  return static_cast<double>((z ^ z >> 31) >> 11) / 9007199254740992.0 - 0.5;
}

/// Calls visit(j) for the lattice neighbours j of i, ascending.
template<class Visit> void around(int n, int reach, std::size_t i, Visit&& visit) {
  const auto m = static_cast<std::size_t>(n);
  const int x = static_cast<int>(i % m), y = static_cast<int>(i / m % m), z = static_cast<int>(i / m / m);
  for (int c = std::max(z - reach, 0); c <= std::min(z + reach, n - 1); c++)
    for (int b = std::max(y - reach, 0); b <= std::min(y + reach, n - 1); b++)
      for (int a = std::max(x - reach, 0); a <= std::min(x + reach, n - 1); a++) {
        const std::size_t j = (static_cast<std::size_t>(c) * m + static_cast<std::size_t>(b)) * m + static_cast<std::size_t>(a);
        if (j != i) visit(j);
      }
}

void build(Block& b, int n, double support, Precision precision) {
  const double dx = 0.01, h = support * dx;
  b.scene.spacing = dx;
  b.scene.numerics.bondSupport = support;
  b.scene.numerics.elasticPrecision = precision;
  b.scene.materials.resize(1);
  b.scene.materials[0].young = {1e6, 0};
  b.modules.solid = true;
  activateSolidFields(b.particles, b.solids, b.bonds, b.work, b.scene, b.modules, b.grid);
  Continuum& p = b.particles;
  for (AnyColumn* c : {static_cast<AnyColumn*>(&p.position), static_cast<AnyColumn*>(&p.velocity), static_cast<AnyColumn*>(&p.mass), static_cast<AnyColumn*>(&p.force)}) p.activate(*c);
  const std::size_t N = static_cast<std::size_t>(n) * static_cast<std::size_t>(n) * static_cast<std::size_t>(n);
  p.resize(N, 0);
  b.solids.resize(N, 0);
  for (std::size_t i = 0; i < N; i++) {
    const auto m = static_cast<std::size_t>(n);
    const double cell[3] = {static_cast<double>(i % m), static_cast<double>(i / m % m), static_cast<double>(i / m / m)};
    for (int a = 0; a < 3; a++) p.position[i][a] = dx * (cell[a] + 0.2 * jitter(i, a));
    p.mass[i] = 1000 * dx * dx * dx;
    b.solids.id[i] = i;
    b.solids.particle[i] = static_cast<std::uint32_t>(i);
    b.solids.volume[i] = dx * dx * dx;
  }
  const int reach = static_cast<int>(std::ceil(support + 0.2));
  const auto bonded = [&](std::size_t i, std::size_t j) { return bondWeight(p.position[j] - p.position[i], h) > 0; };
  int most = 0;
  for (std::size_t i = 0; i < N; i++) {
    int count = 0;
    around(n, reach, i, [&](std::size_t j) { count += bonded(i, j); });
    most = std::max(most, count);
    b.neighbours += count;
  }
  b.neighbours /= static_cast<double>(N);
  resizeBonds(b.bonds, N, most);
  for (std::size_t i = 0; i < N; i++) {
    int k = 0;
    for (; k < most; k++) b.bonds.neighbour[b.bonds.at(i, k)] = static_cast<std::uint32_t>(i);
    k = 0;
    around(n, reach, i, [&](std::size_t j) {
      if (!bonded(i, j)) return;
      const std::size_t at = b.bonds.at(i, k++);
      const Vec3d x = p.position[j] - p.position[i];
      b.bonds.neighbour[at] = static_cast<std::uint32_t>(j);
      b.bonds.x[at] = x.x, b.bonds.y[at] = x.y, b.bonds.z[at] = x.z;
      b.bonds.weight[at] = bondWeight(x, h);
    });
  }
  refreshReference(b.work, b.solids, b.bonds, true);
  for (std::size_t i = 0; i < N; i++) p.position[i].x *= 1.01;
}

double median(std::vector<double> v) {
  std::sort(v.begin(), v.end());
  return v[v.size() / 2];
}

}  // namespace

ElasticFigures elasticFigures(int n, double support, Precision precision, int repeat) {
  Block b;
  build(b, n, support, precision);
  Continuum& p = b.particles;
  ElasticStep step;
  step.energy = false;
  step.dt = 1e-7;
  std::vector<double> phase[5];
  for (int r = -1; r < repeat; r++) {
    Watch::time_point t[5];
    t[0] = Watch::now();
    copyToSolids(p, b.solids);
    t[1] = Watch::now();
    for (const SolidPart part : {SolidPart::Inner, SolidPart::Boundary}) computeDeformationAndStress(b.work, b.solids, b.bonds, step, part);
    t[2] = Watch::now();
    for (const SolidPart part : {SolidPart::Inner, SolidPart::Boundary}) computeElasticForces(b.work, b.solids, b.bonds, step, part);
    t[3] = Watch::now();
    std::fill_n(p.force.data(), p.owned, Vec3d{});
    addSolidForces(b.solids, p, step.dt);
    for (std::size_t i = 0; i < p.owned; i++) {
      p.velocity[i] += (step.dt / p.mass[i]) * p.force[i];
      p.position[i] += step.dt * p.velocity[i];
    }
    t[4] = Watch::now();
    if (r < 0) continue;
    for (int k = 0; k < 4; k++) phase[k].push_back(std::chrono::duration<double>(t[k + 1] - t[k]).count());
    phase[4].push_back(std::chrono::duration<double>(t[4] - t[0]).count());
  }
  ElasticFigures f;
  f.particles = static_cast<double>(p.owned);
  f.neighbours = b.neighbours;
  f.copy = median(phase[0]), f.deformation = median(phase[1]), f.forces = median(phase[2]), f.move = median(phase[3]), f.total = median(phase[4]);
  std::size_t bytes = b.bonds.neighbour.size() * 4 + 4 * b.bonds.x.size() * 8 + 4 * b.work.x.size() * 4;
  bytes += (b.work.place4.size() + b.work.flux12.size()) * 4 + (b.work.place4d.size() + b.work.flux12d.size()) * 8;
  for (const Table* table : {static_cast<const Table*>(&p), static_cast<const Table*>(&b.solids)})
    for (const AnyColumn* c : table->columns) bytes += c->bytes.size();
  f.bytesPerParticle = static_cast<double>(bytes) / f.particles;
  return f;
}

}  // namespace thaw::bench
