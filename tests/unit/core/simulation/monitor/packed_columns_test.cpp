// SPDX-License-Identifier: Apache-2.0
// Packed columns are restored bit by bit, whole and in parts. Only columns that vary take memory.
#include "core/simulation/monitor/packed_columns.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <limits>
#include <random>

#include "core/particles/continuum.hpp"

namespace thaw {
namespace {

/// Rows as in a scene: ascending ids, positions in a box, velocities of both signs, one mass, material 0.
void fill(Continuum& p, std::size_t rows, std::uint32_t seed) {
  for (AnyColumn* c : {static_cast<AnyColumn*>(&p.id), static_cast<AnyColumn*>(&p.position),
                       static_cast<AnyColumn*>(&p.velocity), static_cast<AnyColumn*>(&p.mass),
                       static_cast<AnyColumn*>(&p.material), static_cast<AnyColumn*>(&p.liquid),
                       static_cast<AnyColumn*>(&p.phase), static_cast<AnyColumn*>(&p.dissipated),
                       static_cast<AnyColumn*>(&p.relativeDensity)})
    p.activate(*c);
  p.resize(p.owned, 0);
  p.resize(rows, 0);
  std::mt19937_64 random(seed);
  std::normal_distribution<double> gauss;
  for (std::size_t i = 0; i < rows; i++) {
    p.id[i] = (std::uint64_t(3) << 40) + i;
    p.position[i] = {1.3 + 1e-4 * gauss(random), 2.7 + 1e-4 * gauss(random), 0.6 + 1e-4 * gauss(random)};
    p.velocity[i] = {gauss(random), gauss(random), 0};
    p.mass[i] = 0.1;
    p.liquid[i] = static_cast<float>(i % 3) / 2;
    p.phase[i] = static_cast<std::uint8_t>(random());
    p.relativeDensity[i] = 1;
  }
  if (rows > 2) {
    p.dissipated[1] = -0.0;
    p.dissipated[2] = std::numeric_limits<double>::quiet_NaN();
    p.velocity[0].x = std::bit_cast<double>(~std::uint64_t{0});
  }
}

void expectSameState(const Table& a, const Table& b) {
  ASSERT_EQ(a.owned, b.owned);
  for (std::size_t c = 0; c < a.columns.size(); c++) {
    const AnyColumn &x = *a.columns[c], &y = *b.columns[c];
    if (x.keep != Keep::State) continue;
    ASSERT_EQ(x.active, y.active) << x.name;
    if (!x.active) continue;
    EXPECT_TRUE(std::equal(x.bytes.begin(),
                           x.bytes.begin() + static_cast<std::ptrdiff_t>(a.owned * x.elementBytes),
                           y.bytes.begin()))
        << x.name;
  }
}

TEST(PackedColumns, AreRestoredBitByBit) {
  PackedTable packed;  // reused by all cases, with its memory
  for (const std::size_t rows :
       {std::size_t{5000}, std::size_t{0}, std::size_t{1}, std::size_t{3}, packedBlock - 1, packedBlock,
        packedBlock + 1, 2 * packedBlock, std::size_t{7001}}) {
    Continuum from, to;
    fill(from, rows, static_cast<std::uint32_t>(rows));
    packState(from, packed);
    unpackState(packed, to);
    expectSameState(from, to);
    EXPECT_FALSE(to.relativeDensity.active) << "the relative density is not part of the state";
  }
}

TEST(PackedColumns, LeaveOutGhosts) {
  Continuum from, to;
  fill(from, 40, 1);
  from.resize(40, 9);
  PackedTable packed;
  packState(from, packed);
  unpackState(packed, to);
  EXPECT_EQ(to.owned, 40u);
  EXPECT_EQ(to.ghosts, 0u);
  expectSameState(from, to);
}

TEST(PackedColumns, UnpackAnyRows) {
  Continuum p;
  fill(p, 3 * packedBlock + 77, 5);
  PackedTable packed;
  packState(p, packed);
  for (std::size_t c = 0; c < p.columns.size(); c++) {
    if (!packed.columns[c].there) continue;
    const AnyColumn& column = *p.columns[c];
    for (const auto& [first, count] : {std::pair{std::size_t{0}, std::size_t{1}},
                                       {packedBlock - 1, std::size_t{2}},
                                       {std::size_t{700}, 2 * packedBlock},
                                       {3 * packedBlock + 70, std::size_t{7}},
                                       {std::size_t{9}, std::size_t{0}}}) {
      std::vector<std::byte> rows(count * column.elementBytes + 1, std::byte{0x5a});
      unpackRows(packed, column, c, first, count, rows.data());
      EXPECT_TRUE(std::equal(rows.begin(), rows.end() - 1,
                             column.bytes.begin() + static_cast<std::ptrdiff_t>(first * column.elementBytes)))
          << column.name << " " << first;
      EXPECT_EQ(rows.back(), std::byte{0x5a}) << "no byte beyond its rows";
    }
  }
}

TEST(PackedColumns, StoreConstantBytesOnce) {
  Continuum p;
  fill(p, 20 * packedBlock, 8);
  PackedTable packed;
  packState(p, packed);
  const auto of = [&](const AnyColumn& column) {
    for (std::size_t c = 0; c < p.columns.size(); c++)
      if (p.columns[c] == &column)
        return static_cast<double>(packed.columns[c].bytes.capacity()) / static_cast<double>(p.owned);
    return -1.0;
  };
  EXPECT_LT(of(p.mass), 0.1);
  EXPECT_LT(of(p.material), 0.1);
  EXPECT_LT(of(p.id), 3);
  EXPECT_LT(of(p.position), 22) << "24 unpacked";
  EXPECT_LT(of(p.velocity), 17) << "24 unpacked; z is 0";
  EXPECT_LT(of(p.liquid), 3);
  EXPECT_LT(packed.bytes(), p.owned * p.stateBytes() * 3 / 4);
}

}  // namespace
}  // namespace thaw
