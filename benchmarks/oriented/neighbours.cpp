// SPDX-License-Identifier: Apache-2.0
// Neighbour lists by cells and by a kd-tree.
#include <algorithm>

#include "benchmarks/oriented/tests.hpp"
#include "core/geometry/trees/point_tree.hpp"
#include "core/simulation/body_types/redistribute_body_types.hpp"

namespace thaw::bench {

using test::Simulation;

void neighbours(Figures& figures) {
  for (const double spacing : {0.04, 0.015, 0.0085}) {
    Scene s = defaultBody(spacing);
    s.oriented[0].shape.kind = ShapeKind::Sphere;
    s.oriented[0].shape.radius = 0.5;
    Simulation x(s);
    const Oriented& o = x.w.oriented.rows;
    const double n = static_cast<double>(o.owned), reach = 1.1 * s.oriented[0].support * spacing;
    double byCells = 1e300, byTree = 1e300, bySort = 1e300;
    std::size_t found = 0;
    for (int repeat = 0; repeat < 5; repeat++) {
      auto start = std::chrono::steady_clock::now();
      redistributeBodyTypes(x.w, x.halos(), x.tools.redistribution);
      bySort = std::min(bySort, seconds(start));
      start = std::chrono::steady_clock::now();
      updateNeighbours(x.w.oriented, x.w.scene, x.halos(), x.tools.oriented.lists);
      byCells = std::min(byCells, seconds(start));
      std::vector<Vec3d> places(o.position.data(), o.position.data() + o.owned);
      start = std::chrono::steady_clock::now();
      const PointTree tree(places);
      found = 0;
      for (std::size_t i = 0; i < o.owned; i++) found += tree.within(places[i], reach).size() - 1;
      byTree = std::min(byTree, seconds(start));
    }
    if (found != x.tools.oriented.lists.list.size())
      std::printf("the two searches find different neighbours\n"), figures.missed++;
    figures.row("neighbours", "by the cells, with sorting (ms)", n, 1e3 * (byCells + bySort), 0);
    figures.row("neighbours", "by nanoflann (ms)", n, 1e3 * byTree, 0);
    figures.row("neighbours", "cells over nanoflann", n, (byCells + bySort) / byTree, 1);
  }
}

}  // namespace thaw::bench
