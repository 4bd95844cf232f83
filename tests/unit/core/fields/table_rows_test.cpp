// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <stdexcept>

#include "core/fields/column.hpp"
#include "core/halo/cell_copies.hpp"

namespace thaw {
namespace {

struct Small : Table {
  Small() : Table("small") {}
  Column<double> everywhere{*this, "everywhere", "1", Keep::State, "of ghosts, too"};
  Column<double> owned_{*this, "owned", "1", Keep::State, "of owned rows", Rows::Owned};
};

TEST(Table, GhostsHaveNoRowsOfOwnedFields) {
  Small t;
  t.resize(5, 0);
  t.activate(t.everywhere);
  t.activate(t.owned_);
  for (std::size_t i = 0; i < 5; i++) t.everywhere[i] = t.owned_[i] = static_cast<double>(i);
  t.resize(5, 3);
  EXPECT_EQ(t.everywhere.bytes.size(), 8 * sizeof(double));
  EXPECT_EQ(t.owned_.bytes.size(), 5 * sizeof(double));
  t.resize(5, 0);
  const std::vector<std::uint32_t> order{4, 0, 2};
  t.reorder(order);
  for (std::size_t i = 0; i < order.size(); i++) EXPECT_EQ(t.owned_[i], static_cast<double>(order[i]));
}

TEST(Table, ExchangesRefuseOwnedFields) {
  Small t;
  std::vector<AnyColumn*> chosen;
  t.activate(t.everywhere);
  chooseColumns(ColumnList{&t.everywhere}, chosen);
  EXPECT_EQ(chosen.size(), 1u);
  EXPECT_THROW(chooseColumns(ColumnList{&t.owned_}, chosen), std::logic_error);
}

TEST(Table, HeadRoomIsALayerOfLargeTables) {
  EXPECT_EQ(withHeadRoom(1600), 1700u);
  EXPECT_NEAR(static_cast<double>(withHeadRoom(1000000)), 1010000, 2);
}

}  // namespace
}  // namespace thaw
