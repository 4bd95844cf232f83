// SPDX-License-Identifier: Apache-2.0
// Reference for the step benchmark: a plain fluid step with the same physics in double precision. It uses
// cell lists and one neighbour list per particle, and no vector code.
#pragma once
#include <chrono>
#include <vector>

#include "core/kernels/kernels.hpp"
#include "tests/support/lattice.hpp"

namespace thaw::bench {

/// Arrays that persist between steps, which avoids page faults in each step.
struct Yardstick {
  std::vector<std::uint32_t> list, first, cellStart;
  std::vector<double> relativeDensity, term, heat;
  std::vector<Vec3d> force, position, velocity;
};

/// Takes one step on the block's particles, writes to its own arrays, and returns the seconds it took.
inline double yardstickStep(const test::Block& b, Yardstick& y) {
  using Kernel = isa_base::WendlandC2;
  const Continuum& p = b.particles;
  const std::size_t n = p.owned;
  const double h = b.grid.support, h2 = h * h, stiffness = b.liquids[0].stiffness,
               V = p.mass[0] / b.scene.materials[0].density;
  auto& [list, first, cellStart, relativeDensity, term, heat, force, position, velocity] = y;
  first.resize(n + 1);
  for (auto* v : {&relativeDensity, &term, &heat}) v->resize(n);
  for (auto* v : {&force, &position, &velocity}) v->resize(n);
  const auto start = std::chrono::steady_clock::now();
  // particles are already sorted by cell; a dense table of cells
  const Vec3i c = b.grid.cells;
  list.clear();
  cellStart.assign(static_cast<std::size_t>(c.x) * c.y * c.z + 1, 0);
  const auto index = [&](int x, int y, int z) { return (static_cast<std::size_t>(z) * c.y + y) * c.x + x; };
  for (std::size_t i = 0; i < n; i++) {
    const Vec3i a = cellOf(b.grid, p.position[i]);
    cellStart[index(a.x, a.y, a.z) + 1]++;
  }
  for (std::size_t k = 1; k < cellStart.size(); k++) cellStart[k] += cellStart[k - 1];
  for (std::size_t i = 0; i < n; i++) {
    const Vec3i a = cellOf(b.grid, p.position[i]);
    first[i] = static_cast<std::uint32_t>(list.size());
    for (int z = std::max(0, a.z - 1); z <= std::min(c.z - 1, a.z + 1); z++)
      for (int y = std::max(0, a.y - 1); y <= std::min(c.y - 1, a.y + 1); y++)
        for (std::uint32_t j = cellStart[index(std::max(0, a.x - 1), y, z)];
             j < cellStart[index(std::min(c.x - 1, a.x + 1), y, z) + 1]; j++) {
          const Vec3d d = p.position[i] - p.position[j];
          if (j != i && dot(d, d) < h2) list.push_back(j);
        }
  }
  first[n] = static_cast<std::uint32_t>(list.size());
  for (std::size_t i = 0; i < n; i++) {
    double sum = Kernel::w(0.0);
    for (std::uint32_t k = first[i]; k < first[i + 1]; k++) {
      const Vec3d d = p.position[i] - p.position[list[k]];
      sum += Kernel::w(dot(d, d) / h2);
    }
    relativeDensity[i] = V * sum / (h * h2);
    term[i] = std::max(0.0, stiffness * (relativeDensity[i] - 1)) / (relativeDensity[i] * relativeDensity[i]);
  }
  for (std::size_t i = 0; i < n; i++) {
    Vec3d f{};
    double q = 0;
    for (std::uint32_t k = first[i]; k < first[i + 1]; k++) {
      const std::uint32_t j = list[k];
      const Vec3d d = p.position[i] - p.position[j], u = p.velocity[i] - p.velocity[j];
      const double r2 = dot(d, d), slope = Kernel::slope(r2 / h2), approach = dot(u, d);
      f += d * (-(term[i] + term[j]) * slope +
                10 * 2 * 1.0 * 1.0 / (1.0 + 1.0) * approach / (r2 + 1e-6 * h2) * slope);
      q += -2 * slope * 2 * 1.0 * 1.0 / (1.0 + 1.0) * (p.temperature[j] - p.temperature[i]);
    }
    force[i] = f * (V * V / (h2 * h2 * h));
    heat[i] = q * (V * V / (h2 * h2 * h));
  }
  for (std::size_t i = 0; i < n; i++) {
    velocity[i] = p.velocity[i] + force[i] * (1e-6 / p.mass[i]);
    position[i] = p.position[i] + velocity[i] * 1e-6;
  }
  volatile double keep = position[n / 2].x + heat[n / 2];
  (void)keep;
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace thaw::bench
