// SPDX-License-Identifier: Apache-2.0
#include "core/surface/kernels/surface_kernels.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "core/math/hash_random.hpp"
#include "core/surface/search/bins.hpp"
#include "core/surface/seeding/disc_cover.hpp"

namespace thaw {
namespace {

double random(std::uint64_t k, std::uint64_t what, double low, double high) {
  return low + (high - low) * randomUniform(3, Purpose::Test, k, what);
}

/// All kernel sets that this machine supports.
std::vector<const SurfaceKernels*> sets() {
  std::vector<const SurfaceKernels*> all;
  for (const char* name : {"base", "avx2", "avx512"})
    if (const SurfaceKernels* k = surfaceKernels(name)) all.push_back(k);
  return all;
}

std::vector<Vec3d> places(std::size_t n) {
  std::vector<Vec3d> x;
  for (std::uint64_t k = 0; k < n; k++)
    x.push_back({random(k, 0, 5, 15), random(k, 1, -3, 4), random(k, 2, 0, 6)});
  return x;
}

TEST(SurfaceKernels, FindSurfelsNearABox) {
  const NearBox box{{0.3f, -0.2f, 0.1f}, {0.5f, 0.2f, 0.0f}, 0.49f};
  for (const std::uint32_t n : {0u, 1u, 7u, 8u, 9u, 500u}) {
    std::vector<float> x[3];
    for (std::uint64_t a = 0; a < 3; a++)
      for (std::uint64_t k = 0; k < n + nearBoxMore; k++)
        x[a].push_back(static_cast<float>(random(k, a, -1.5, 1.5)));
    std::vector<std::uint32_t> wanted;
    for (std::uint32_t k = 0; k < n; k++) {
      float r2 = 0;
      for (std::size_t a = 0; a < 3; a++) {
        const float d = std::max(std::abs(x[a][k] - box.middle[a]) - box.half[a], 0.0f);
        r2 += d * d;
      }
      if (r2 < box.reach2) wanted.push_back(k);
    }
    for (const SurfaceKernels* k : sets()) {
      std::vector<std::uint32_t> found(n + nearBoxMore);
      found.resize(k->nearBox(box, x[0].data(), x[1].data(), x[2].data(), n, found.data()));
      EXPECT_EQ(found, wanted) << k->name << " " << n;
    }
  }
}

TEST(SurfaceKernels, FindOpenPartsOfACircle) {
  std::array<float, circlePlaces> cosine, sine;
  for (std::size_t k = 0; k < circlePlaces; k++)
    cosine[k] = std::cos(0.2618f * static_cast<float>(k)),
    sine[k] = std::sin(0.2618f * static_cast<float>(k));
  const CirclePlaces flat{cosine.data(), sine.data(), {0, 0, 1}, {1, 0, 0}, {0, 1, 0}, {0, 0, 0}, -0.3f};
  // discs to the right, the last one on another side: the rest of the circle is open
  const std::vector<float> discs{0.9f, 0.3f, 0, 0, 0, 1, 0.9f, -0.3f, 0.1f, 0, 0, 1, -1, 0, 0, 0, 0, -1};
  std::array<float, circlePlaces> first{}, open{};
  for (const SurfaceKernels* k : sets()) {
    k->openPlaces(flat, discs.data(), discs.size() / 6, open.data());
    for (std::size_t n = 0; n < circlePlaces; n++) {
      bool covered = false;
      for (std::size_t j = 0; j < 2; j++)
        covered |= std::hypot(cosine[n] - discs[6 * j], sine[n] - discs[6 * j + 1], discs[6 * j + 2]) < 1;
      EXPECT_EQ(open[n], covered ? 0.0f : 1.0f) << k->name << " " << n;
    }
    CirclePlaces bent = flat;
    bent.curvature[0] = 0.4f, bent.curvature[1] = 0.1f, bent.curvature[2] = -0.2f;
    k->openPlaces(bent, discs.data(), discs.size() / 6, open.data());
    if (k == sets()[0]) first = open;
    EXPECT_EQ(open, first) << k->name;
  }
}

TEST(SurfaceKernels, SumThePatchWithTheBitsOfSingleTerms) {
  const std::vector<Vec3d> at = places(21), of = places(8);
  std::vector<double> disc;
  for (std::size_t j = 0; j < at.size(); j++)
    for (const double v : {at[j].x, at[j].y, at[j].z, 0.1 * at[j].y, 0.2, 0.9}) disc.push_back(v);
  alignas(32) std::array<double, 24> place;
  for (std::size_t k = 0; k < 8; k++)
    for (std::size_t a = 0; a < 3; a++) place[8 * a + k] = of[k][static_cast<int>(a)];
  const double reach2 = 20;
  for (const SurfaceKernels* k : sets()) {
    alignas(32) std::array<double, 8 * patchSums> sums;
    k->betweenDiscs({disc.data(), at.size(), place.data(), reach2, 1 / reach2}, sums.data());
    for (std::size_t lane = 0; lane < 8; lane++) {
      double weight = 0, along = 0;
      Vec3d normal{}, away{};
      for (std::size_t j = 0; j < at.size(); j++) {
        const Vec3d d = of[lane] - at[j], n{0.1 * at[j].y, 0.2, 0.9};
        if (dot(d, d) >= reach2) continue;
        const double u = 1 - dot(d, d) * (1 / reach2), w = u * u * u;
        weight += w, along += w * dot(n, d), normal += w * n, away += w * d;
      }
      EXPECT_EQ(sums[8 * PatchWeight + lane], weight);
      EXPECT_EQ(sums[8 * PatchAlong + lane], along);
      for (int a = 0; a < 3; a++) {
        const auto c = static_cast<std::size_t>(a);
        EXPECT_EQ(sums[8 * (PatchNormal + c) + lane], normal[a]);
        EXPECT_EQ(sums[8 * (PatchAway + c) + lane], away[a]);
      }
    }
  }
}

TEST(DiscCover, CoverPointsBelowThem) {
  DiscCover discs(1, 1.8);
  const Vec3d up{0, 0, 1};
  EXPECT_FALSE(discs.covers(up));
  for (int k = 0; k < 11; k++) discs.add({5.0 + k, 0, 1}, up, 0.3);
  EXPECT_FALSE(discs.covers(up));
  discs.add({0.1, 0.1, 1.2}, up, 0.3);
  EXPECT_TRUE(discs.covers(up));
  EXPECT_FALSE(discs.covers(-up));  // it faces the other way
  EXPECT_TRUE(discs.covers({14.9, 0.2, 0}, up));
  EXPECT_FALSE(discs.covers({15.9, 0.2, 0}, up));
  discs.clear();
  EXPECT_FALSE(discs.covers(up));
}

TEST(RowBlock, HasAllInReachAndFewOthers) {
  const std::vector<Vec3d> x = places(4000);
  Bins bins;
  fillBins(x.data(), x.size(), 0.6, bins);
  RowBlock block;
  for (std::uint64_t k = 0; k < 40; k++) {
    const Vec3d low = x[100 * k],
                high = low + Vec3d{random(k, 4, 0, 1), random(k, 5, 0, 1), random(k, 6, 0, 1)};
    const PlaceBox box{low, high};
    const double radius = 0.8;
    block.find(bins, box, radius);
    std::vector<std::uint8_t> has(x.size(), 0);
    for (std::size_t n = 0; n < block.count; n++) {
      has[block.row[n]] = 1;
      EXPECT_EQ(block.at[n], x[block.row[n]]);
    }
    for (std::size_t i = 0; i < x.size(); i++) {
      if (box.distance2(x[i]) <= radius * radius) { EXPECT_TRUE(has[i]); }
      if (box.distance2(x[i]) > 1.001 * radius * radius) { EXPECT_FALSE(has[i]); }
    }
    std::vector<std::uint8_t> near(x.size(), 0);
    for (const std::uint32_t n : block.around(low, radius)) near[block.row[n]] = 1;
    for (std::size_t i = 0; i < x.size(); i++) {
      const double r2 = dot(x[i] - low, x[i] - low);
      if (r2 <= radius * radius) { EXPECT_TRUE(near[i]); }
      if (r2 > 1.001 * radius * radius) { EXPECT_FALSE(near[i]); }
    }
  }
}

TEST(SortByKey, KeepsTheOrderOfEqualKeys) {
  SortedRows rows, buffer;
  // 20 bits
  for (std::uint32_t k = 0; k < 5000; k++) rows.emplace_back(randomBits(5, Purpose::Test, k) >> 44, k);
  for (std::uint32_t k = 0; k < 5000; k += 3) rows[k].first = 77;
  SortedRows wanted = rows;
  std::stable_sort(wanted.begin(), wanted.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  sortByKey(rows, buffer, 20);
  EXPECT_EQ(rows, wanted);
}

}  // namespace
}  // namespace thaw
