#include "io/run/summary.hpp"

#include <gtest/gtest.h>

#include "core/kinds/kinds.hpp"

namespace thaw {
namespace {

bool has(const std::string& line, const std::string& text) { return line.find(text) != std::string::npos; }

TEST(ProgressLine, ShowsWhatTheSceneHas) {
  LedgerReport l;
  l.rows[sheetKind] = 81;
  const std::string sheets = progressLine({}, l, 1, 1);
  EXPECT_TRUE(has(sheets, "  sheet 81  ")) << sheets;
  EXPECT_FALSE(has(sheets, "particles")) << sheets;
  EXPECT_FALSE(has(sheets, "liquid")) << sheets;
  l.particles = 7;
  EXPECT_TRUE(has(progressLine({}, l, 1, 1), "  particles 7  sheet 81  liquid 0.0 %  "));
  EXPECT_TRUE(has(progressLine({}, {}, 1, 1), "  particles 0  "));
}

TEST(ProgressLine, SharesOfNothingAreNoPercentages) {
  LedgerReport l;
  l.energyScale = l.energyResidual = 6.9e-18;
  l.energyRounding = 1e-14;
  EXPECT_TRUE(has(progressLine({}, l, 1, 1), "residual +6.90e-18 J (all of it rounding)"));
  EXPECT_TRUE(warningsOf({}, l).empty());
  l.energyScale = l.energyResidual = 6.9e-3;
  EXPECT_TRUE(has(progressLine({}, l, 1, 1), "residual +6.90e-03 J (+1.0e+00)"));
  EXPECT_EQ(warningsOf({}, l).size(), 1u);
}

}  // namespace
}  // namespace thaw
