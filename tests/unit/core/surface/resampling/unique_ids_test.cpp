// SPDX-License-Identifier: Apache-2.0
#include "core/surface/resampling/unique_ids.hpp"

#include <gtest/gtest.h>

#include <map>
#include <set>

#include "tests/unit/core/surface/surfel_rig.hpp"

namespace thaw {
namespace {

using namespace test;

TEST(UniqueIds, DuplicatesGetAnIdByTheirPosition) {
  const auto make = [](bool twisted) {
    SurfelRig rig(surfelScene(0.1));
    for (int k = 0; k < 10; k++) rig.add({0.1 * k, 0, 0}, {0, 0, 1});
    std::vector<Vec3d> places{{1, 1, 1}, {2, 1, 1}, {1.5, 1, 1}, {0, 1, 1}};
    // the id of an old surfel, an id shared by two new ones, a free id
    std::vector<std::uint64_t> ids{rig.surfels().id[3], surfelBit | birthBit | 77, surfelBit | birthBit | 77,
                                   surfelBit | birthBit | 78};
    if (twisted) std::reverse(places.begin(), places.end()), std::reverse(ids.begin(), ids.end());
    for (std::size_t k = 0; k < places.size(); k++) {
      rig.add(places[k], {0, 0, 1});
      rig.surfels().id[rig.surfels().owned - 1] = ids[k];
    }
    EXPECT_EQ(makeIdsUnique(rig.surfels(), 10, 1, rig.ranks->halos().all), 3);
    std::map<double, std::uint64_t> byPlace;
    std::set<std::uint64_t> all;
    for (std::size_t i = 0; i < rig.surfels().owned; i++) {
      all.insert(rig.surfels().id[i]);
      if (i >= 10) byPlace[rig.surfels().position[i].x] = rig.surfels().id[i];
    }
    EXPECT_EQ(all.size(), 14u);
    EXPECT_EQ(rig.surfels().id[3], surfelBit | 4);
    EXPECT_EQ(makeIdsUnique(rig.surfels(), 10, 1, rig.ranks->halos().all), 0);
    return byPlace;
  };
  const auto one = make(false), other = make(true);
  EXPECT_EQ(one, other);  // independent of their order
  EXPECT_EQ(one.at(0), surfelBit | birthBit | 78);
}

}  // namespace
}  // namespace thaw
