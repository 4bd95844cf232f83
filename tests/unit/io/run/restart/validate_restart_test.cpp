// SPDX-License-Identifier: Apache-2.0
#include "io/run/restart/validate_restart.hpp"

#include <gtest/gtest.h>

#include "core/halo/serial.hpp"
#include "core/oriented/forces/constraints.hpp"
#include "core/oriented/prepare_oriented.hpp"
#include "core/sheet/prepare_sheets.hpp"
#include "core/terms/find_modules.hpp"

namespace thaw {
namespace {

/// A sheet of nine vertices and an oriented particle with a constraint, as in a checkpoint.
struct Restored {
  World w;
  SerialReducer all;
  Restored() {
    w.scene.spacing = 0.1;
    SheetBody& cloth = w.scene.sheets.emplace_back();
    cloth.name = "cloth";
    cloth.width = cloth.depth = 0.2;
    OrientedBody& net = w.scene.oriented.emplace_back();
    net.name = "net";
    net.constraints.resize(1);
    net.events.resize(1);
    net.events[0].time = 1;
    w.modules = modulesOf(w.scene);
    prepareSheets(w.sheets, w.scene, {});
    activateSheets(w.sheets, w.scene, w.modules);
    activateOriented(w.oriented.rows, w.scene, w.modules);
    Sheets& s = w.sheets.rows;
    s.resize(9, 0);
    for (std::size_t i = 0; i < 9; i++) s.id[i] = i;
    w.oriented.rows.resize(1, 0);
    w.oriented.rows.constraint[0] = 0;
    w.oriented.rows.flags[0] = fixedPosition;
  }
  std::size_t strange() { return checkpointMismatches(w, all).size(); }
};

TEST(RestartValidation, AcceptsTheSceneItself) { EXPECT_EQ(Restored().strange(), 0u); }

TEST(RestartValidation, CountsVerticesBeyondTheMesh) {
  Restored r;
  Sheets& s = r.w.sheets.rows;
  const auto with = [&](auto& value, auto other) {
    const auto was = value;
    value = static_cast<std::remove_reference_t<decltype(value)>>(other);
    const std::size_t n = r.strange();
    value = was;
    return n;
  };
  EXPECT_EQ(with(s.id[3], 9), 1u);
  EXPECT_EQ(with(s.id[3], std::uint64_t{1} << 40), 1u);
  EXPECT_EQ(with(s.law[3], 1), 1u);
  EXPECT_EQ(with(s.part[3], 1), 1u);
  EXPECT_EQ(with(s.body[3], 1), 1u);
  EXPECT_EQ(r.strange(), 0u);
}

TEST(RestartValidation, CountsMissingConstraintsAndBodies) {
  Restored r;
  r.w.oriented.rows.constraint[0] = 1;
  EXPECT_EQ(r.strange(), 1u);
  r.w.oriented.rows.flags[0] = 0;  // as for newborn particles: no constraint holds it, whatever the column
                                   // has
  EXPECT_EQ(r.strange(), 0u);
  r.w.oriented.rows.flags[0] = fixedPosition;
  r.w.oriented.rows.constraint[0] = noConstraint;
  EXPECT_EQ(r.strange(), 0u);
  r.w.oriented.rows.body[0] = 1;
  EXPECT_EQ(r.strange(), 1u);
}

TEST(RestartValidation, CountsFutureCutsWithTheNumberOfAnEarlierOne) {
  Restored r;
  r.w.oriented.rows.cutSides[0] = 2;
  EXPECT_EQ(r.strange(), 1u);
  r.w.oriented.rows.cutSides[0] = 2 << 2;
  EXPECT_EQ(r.strange(), 0u);
  r.w.oriented.rows.cutSides[0] = 2;
  r.w.clock.time = 1;  // the cut was made
  EXPECT_EQ(r.strange(), 0u);
}

}  // namespace
}  // namespace thaw
