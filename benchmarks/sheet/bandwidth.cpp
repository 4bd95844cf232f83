// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <vector>

#include "benchmarks/sheet/tests.hpp"
#include "core/fields/column.hpp"
#include "core/sheet/move_vertices.hpp"

namespace thaw::bench {

bool bandwidth(std::size_t n, const Out& out) {
  using Clock = std::chrono::steady_clock;
  AlignedVector<Vec3d> position(n), velocity(n), rest(n), load(n);
  for (std::size_t i = 0; i < n; i++) {
    const auto x = static_cast<double>(i % 1000);
    position[i] = rest[i] = {x, 2 * x, 3 * x};
    velocity[i] = {1, 0, 0.5};
    load[i] = {0.1, 0.2, 0.3};
  }
  const VertexMap map = vertexMap({1, 0.1, 40}, 1e-3);
  // The update reads 4 and writes 2 vectors per vertex. The copy reads and writes 3. Both move 144 bytes.
  const double bytes = 144.0 * static_cast<double>(n);
  AlignedVector<double> from(9 * n, 1.0), to(9 * n, 0.0);
  double update = 1e9, copy = 1e9;
  for (int k = 0; k < 15; k++) {
    const auto start = Clock::now();
    moveVertices({&map, 1}, {position.data(), velocity.data(), rest.data(), load.data(), nullptr}, 0, n);
    const auto middle = Clock::now();
    const double* a = from.data();
    double* b = to.data();
    // an addition, so that no library copies past the caches
    for (std::size_t i = 0; i < 9 * n; i++) b[i] = a[i] + static_cast<double>(k);
    const auto end = Clock::now();
    update = std::min(update, std::chrono::duration<double>(middle - start).count());
    copy = std::min(copy, std::chrono::duration<double>(end - middle).count());
  }
  const double share = copy / update;
  std::printf(
      "vertex update   %6.2f GB/s   %.2f ns a vertex\ncopy            %6.2f GB/s   (%.4g)\nshare           "
      "%6.1f %%      target: 120 %%, %zu vertices\n",
      bytes / update / 1e9, 1e9 * update / static_cast<double>(n), bytes / copy / 1e9, to[n], 100 * share, n);
  out.line("bandwidth", "vertices", "update", 1, static_cast<double>(n), update, bytes / update / 1e9,
           "GB/s");
  out.line("bandwidth", "vertices", "copy", 1, static_cast<double>(n), copy, bytes / copy / 1e9, "GB/s");
  out.line("bandwidth", "vertices", "share", 1, static_cast<double>(n), 0, 100 * share, "%");
  return share >= 1.2;
}

}  // namespace thaw::bench
