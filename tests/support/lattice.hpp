// SPDX-License-Identifier: Apache-2.0
// Blocks of particles for tests without MPI: a cubic lattice with hashed jitter, sorted, with neighbour
// lists.
#pragma once
#include <cstdint>
#include <vector>

#include "core/fluid/pair_sums/pair_kernels.hpp"
#include "core/fluid/pair_sums/records.hpp"
#include "core/neighbours/search.hpp"
#include "core/neighbours/sort.hpp"
#include "core/simulation/setup/make_grid.hpp"
#include "tests/support/hashed.hpp"

namespace thaw::test {

/// n^3 liquid particles of one material, spacing s, displaced by up to jitter * s along each axis.
struct Block {
  Scene scene;
  Modules modules;
  CellGrid grid;
  Continuum particles;
  CellTable cells;
  NeighbourLists lists;
  PairRecords records;
  std::vector<LiquidMaterial> liquids;
  SearchBuffers search;
  SortBuffers sort;

  explicit Block(int n, double jitter, double support = 2, Precision precision = Precision::Single,
                 KernelKind kernel = KernelKind::WendlandC2, double s = 0.01) {
    scene.spacing = s;
    scene.numerics.support = support;
    scene.numerics.precision = precision;
    scene.numerics.kernel = kernel;
    scene.domain.min = {0, 0, 0};
    scene.domain.max = {n * s, n * s, n * s};
    Material m;
    m.name = "liquid";
    m.viscosity = {1, 1};
    m.conductivity = {1, 1};
    m.soundSpeed = 10;
    scene.materials.push_back(m);
    modules.fluid = modules.neighbours = modules.heat = true;
    liquids = liquidMaterials(scene);
    grid = makeGrid(scene);
    Continuum& p = particles;
    for (AnyColumn* c : p.columns)
      if (c != &p.restDensity) p.activate(*c);
    const std::size_t N = static_cast<std::size_t>(n) * n * n;
    p.resize(N, 0);
    for (std::size_t q = 0; q < N; q++) {
      const std::size_t at = (q * 7919) % N;  // the order of ids is unrelated to positions
      const double c[3] = {static_cast<double>(at % n), static_cast<double>(at / n % n),
                           static_cast<double>(at / n / n)};
      for (int a = 0; a < 3; a++) {
        p.position[q][a] = s * (c[a] + 0.5 + jitter * (2 * hashed(3 * q + a) - 1));
        p.velocity[q][a] = hashed(1000003 * q + a) - 0.5;
      }
      p.id[q] = q;
      p.mass[q] = m.density * s * s * s;
      p.phase[q] = Liquid;
      p.liquid[q] = 1;
      p.temperature[q] = 300 + 10 * hashed(77 * q);
    }
    Migration all;
    all.arrivals = N;
    computeCellKeys(grid, p);
    sortByCell(p, all, sort, cells);
  }

  void findNeighbours(const PairKernels& k, bool pack = true) {
    const RecordContext x{scene, modules, grid, liquids};
    const std::uint32_t n = static_cast<std::uint32_t>(particles.owned);
    if (pack) {
      resizeRecords(x, n, records);
      packRecords(x, particles, 0, n, records);
    }
    clearLists(lists, n, n);
    const std::vector<std::uint8_t> inner(cells.key.size(), 1);
    SearchInput in;
    in.x = records.coarse[0].data(), in.y = records.coarse[1].data(), in.z = records.coarse[2].data();
    in.cells = &cells;
    in.inner = inner.data();
    in.owned = n;
    k.search(in, Part::Inner, search, lists);
  }

  PairSums sums(std::int64_t* coincident) {
    PairSums s;
    const double h = grid.support;
    s.lists = &lists;
    s.kernel = scene.numerics.kernel;
    s.precision = scene.numerics.precision;
    s.support = h;
    s.relativeDensityScale = 1 / (h * h * h);
    s.heat = true;
    s.positionVolume = scene.numerics.precision == Precision::Single ? records.fixed.data()
                                                                     : records.positionVolume.data();
    s.velocityViscosity = records.velocityViscosity.data();
    s.pressurePhaseHeat = records.pressurePhaseHeat.data();
    s.surface = records.surface.data();
    s.relativeDensity = particles.relativeDensity.data();
    s.force = particles.force.data();
    s.heatFlow = particles.heatFlow.data();
    s.dissipation = particles.dissipation.data();
    s.interaction = particles.interaction.data();
    s.freeSurfaceIndicator = particles.freeSurfaceIndicator.data();
    s.smoothed = particles.shiftingVelocity.data();
    s.coincident = coincident;
    return s;
  }
  GroupRange groups() const { return {0, lists.groups}; }

  /// Neighbours of a row in the order of its list, without the padding.
  std::vector<std::uint32_t> neighboursOf(std::uint32_t row) const {
    std::vector<std::uint32_t> all;
    for (std::size_t g = 0; g < lists.groups; g++)
      for (std::size_t l = 0; l < 8; l++)
        if (lists.self[8 * g + l] == row)
          for (std::uint32_t k = 0; k < lists.count[g]; k++) {
            const std::uint32_t j = lists.row(g, k, l);
            if (j != lists.dummy) all.push_back(j);
          }
    return all;
  }
};

}  // namespace thaw::test
