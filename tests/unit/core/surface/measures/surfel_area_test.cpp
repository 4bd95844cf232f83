// SPDX-License-Identifier: Apache-2.0
#include "core/surface/measures/surfel_area.hpp"

#include <gtest/gtest.h>

#include "tests/support/surface/relax_rig.hpp"

namespace thaw {
namespace {

using test::RelaxRig;

struct Flat {
  double x, y;
};

/// Area of the Voronoi cell of `at` within a square of half-width 2, by successive cuts.
double voronoiArea(const std::vector<Flat>& all, const Flat& at) {
  std::vector<Flat> cell{{-2, -2}, {2, -2}, {2, 2}, {-2, 2}};
  for (const Flat& o : all) {
    const double ax = o.x - at.x, ay = o.y - at.y, b = 0.5 * (ax * ax + ay * ay);
    if (b == 0) continue;
    std::vector<Flat> left;
    for (std::size_t k = 0; k < cell.size(); k++) {
      const Flat p = cell[k], q = cell[(k + 1) % cell.size()];
      const double over = ax * p.x + ay * p.y - b, next = ax * q.x + ay * q.y - b;
      if (over <= 0) left.push_back(p);
      if ((over <= 0) != (next <= 0))
        left.push_back({p.x + over / (over - next) * (q.x - p.x), p.y + over / (over - next) * (q.y - p.y)});
    }
    cell = left;
  }
  double twice = 0;
  for (std::size_t k = 0; k < cell.size(); k++) {
    const Flat p = cell[k], q = cell[(k + 1) % cell.size()];
    twice += p.x * q.y - p.y * q.x;
  }
  return 0.5 * twice;
}

/// A sheet of surfels at z = 0 on a hexagonal lattice, displaced by up to `noise`.
std::vector<Flat> addSheet(RelaxRig& rig, double noise) {
  std::vector<Flat> all;
  const double d = rig.w.surface.spacing;
  for (int y = -12; y <= 12; y++)
    for (int x = -12; x <= 12; x++) {
      const int key = 100 * (y + 20) + x + 20;
      const auto random = [&](std::uint64_t axis) {
        return noise * (2 * randomUniform(3, Purpose::Test, static_cast<std::uint64_t>(key), axis) - 1);
      };
      all.push_back({d * (x + 0.5 * (y & 1)) + random(0), 0.8660254 * d * y + random(1)});
      rig.addSurfel({all.back().x, all.back().y, 0}, {0, 0, 1});
    }
  return all;
}

std::vector<double> areas(RelaxRig& rig, const SurfaceKernels* kernels) {
  rig.place();
  AreaLists lists;
  lists.kernels = kernels;
  findSurfelAreas(rig.w.surface, rig.ranks->halos().all, lists);
  return {rig.w.surface.surfels.area.data(), rig.w.surface.surfels.area.data() + rig.w.surface.surfels.owned};
}

TEST(SurfelArea, EqualsTheVoronoiCell) {
  for (const double noise : {0.0, 0.1, 0.2}) {
    RelaxRig rig;
    const std::vector<Flat> all = addSheet(rig, noise);
    std::vector<double> first;
    for (const char* isa : {"base", "avx2", "avx512"}) {
      if (!surfaceKernels(isa)) continue;
      const std::vector<double> found = areas(rig, surfaceKernels(isa));
      if (first.empty()) first = found;
      EXPECT_TRUE(first == found) << isa;
    }
    const Surfels& s = rig.w.surface.surfels;
    int inner = 0;
    for (std::size_t i = 0; i < s.owned; i++) {
      const Vec3d x = s.position[i];
      if (std::abs(x.x) > 4 || std::abs(x.y) > 3.5) continue;  // cells bounded by surfels only
      inner++;
      EXPECT_NEAR(first[i], voronoiArea(all, {x.x, x.y}), 1e-13) << noise;
    }
    EXPECT_GT(inner, 200);
  }
}

TEST(SurfelArea, CoincidentSurfelsHaveFiniteAreas) {
  RelaxRig rig;
  addSheet(rig, 0.1);
  const double before = [&] {
    double sum = 0;
    for (const double a : areas(rig, surfaceKernels())) sum += a;
    return sum;
  }();
  const Vec3d x = rig.w.surface.surfels.position[rig.w.surface.surfels.owned / 2];
  rig.addSurfel(x, {0, 0, 1});
  double sum = 0;
  for (const double a : areas(rig, surfaceKernels())) sum += a;
  EXPECT_LT(std::abs(sum - before), rig.w.surface.spacing * rig.w.surface.spacing);
}

}  // namespace
}  // namespace thaw
