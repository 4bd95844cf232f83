// SPDX-License-Identifier: Apache-2.0
#include "io/run/reports/progress.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "core/simulation/world/body_types.hpp"

namespace thaw {
namespace {

bool has(const std::string& line, const std::string& text) { return line.find(text) != std::string::npos; }

TEST(ProgressLine, ShowsOnlyPresentParts) {
  LedgerReport l;
  l.rows[sheetType] = 81;
  const std::string sheets = progressLine({}, l);
  EXPECT_TRUE(has(sheets, "  sheet 81  ")) << sheets;
  EXPECT_FALSE(has(sheets, "particles")) << sheets;
  EXPECT_FALSE(has(sheets, "liquid")) << sheets;
  l.particles = 7;
  EXPECT_TRUE(has(progressLine({}, l), "  particles 7  sheet 81  liquid 0.0 %  "));
  EXPECT_TRUE(has(progressLine({}, {}), "  particles 0  "));
}

TEST(ProgressLine, HasNoPercentagesOfZero) {
  LedgerReport l;
  l.energyScale = l.energyLargest = l.energyResidual = 6.9e-18;
  l.energyRounding = 1e-14;
  EXPECT_TRUE(has(progressLine({}, l), "residual +6.9e-18 J (rounding)"));
  EXPECT_TRUE(warningsOf({}, l).empty());
  l.energyScale = l.energyLargest = l.energyResidual = 6.9e-3;
  EXPECT_TRUE(has(progressLine({}, l), "residual +6.9e-03 J (+1.0e+00)"));
  EXPECT_EQ(warningsOf({}, l).size(), 1u);
  l.energyLargest = 100 * l.energyScale;  // the energy was larger before
  EXPECT_TRUE(warningsOf({}, l).empty());
}

TEST(Warnings, NegativeDissipation) {
  LedgerReport l;
  l.initial.potential = 10;
  l.energyScale = l.energyLargest = 0.2;
  l.dissipated = -0.2;
  ASSERT_EQ(warningsOf({}, l).size(), 1u);
  EXPECT_TRUE(has(warningsOf({}, l)[0], "dissipation is negative (-0.2 J)"));
  l.dissipated = -0.05;  // half of a per cent of the potential energy
  EXPECT_TRUE(warningsOf({}, l).empty());
}

TEST(ProgressLine, FitsOnATerminal) {
  Progress p;
  p.clock.time = 12.345678;
  p.clock.step = 1234567;
  p.clock.dt = 1.2345e-5;
  p.clock.limitedBy = "surface tension";
  p.stepsPerSecond = 123.4;
  p.secondsLeft = 5000;
  LedgerReport l;
  l.particles = 2700000;
  l.liquidFraction = 0.5;
  l.energyScale = 100, l.energyResidual = -1.5;
  EXPECT_LE(progressLine(p, l).size(), 160u) << progressLine(p, l);
}

TEST(StatusLine, FillsItsBarWithTheTime) {
  Progress p;
  p.clock.end = 2;
  p.clock.time = 0.5;
  p.clock.dt = 8e-5;
  p.clock.limitedBy = "sound";
  p.secondsLeft = 61;
  EXPECT_EQ(statusLine(p, {}), "[=>    ]  25 %  left 61 s  t 0.5 s  dt 8.0e-05 s (sound)  residual +0.0e+00");
  LedgerReport l;
  l.particles = 10;
  l.liquidFraction = 0.092;
  p.clock.time = 2;
  EXPECT_EQ(statusLine(p, l).find('>'), std::string::npos) << statusLine(p, l);
  EXPECT_TRUE(has(statusLine(p, l), "  liquid 9.2 %  "));
  // the bar keeps its width
  for (const char* limit : {"sound", "surface tension", "the scene's fixed step"}) {
    p.clock.limitedBy = limit;
    EXPECT_EQ(statusLine(p, l).find(']'), 7u) << statusLine(p, l);
  }
}

TEST(StatusLine, HasAllItemsOnATerminalOf80Columns) {
  Progress p;
  p.clock.end = 2;
  p.clock.time = 0.5;
  p.clock.dt = 1.234e-5;
  LedgerReport l;
  l.particles = 10;
  l.energyScale = 100, l.energyLargest = 100;
  std::vector<const char*> limits(limitNames.begin(), limitNames.end());
  limits.push_back("the scene's fixed step"), limits.push_back("frames");
  for (const char* limit : limits)
    for (const double left : {9.9, 119.0, 7000.0, 360000.0, 1e9, 1e12})
      for (const double liquid : {0.0, 0.5, 1.0})
        for (const double residual : {0.0, -1e-3}) {
          p.clock.limitedBy = limit;
          p.secondsLeft = left;
          l.liquidFraction = liquid;
          l.energyResidual = residual;
          const std::string line = statusLine(p, l);
          EXPECT_LE(line.size(), 79u) << line;
          for (const char* part : {"[=", ">", " left ", " dt 1", " (", " liquid ", " residual "})
            EXPECT_TRUE(has(line, part)) << line;
        }
}

TEST(Warnings, NameTheSidesWhereParticlesLeft) {
  Counters c;
  c.left = 15;
  c.leftThrough[2][1] = 12, c.leftThrough[0][0] = 3;
  ASSERT_EQ(warningsOf(c, {}).size(), 1u);
  EXPECT_TRUE(has(warningsOf(c, {})[0],
                  "15 particles left the domain, 3 through its low x side, 12 through its high z side "
                  "(mass"));
}

struct ProgressLog : testing::Test {
  const std::string out =
      (std::filesystem::temp_directory_path() / ("thaw_progress_" + std::to_string(::getpid()))).string();
  RunSummary summary;
  void SetUp() override { std::filesystem::create_directories(out); }
  void TearDown() override { std::filesystem::remove_all(out); }
  void add(std::int64_t step) {
    Progress p;
    p.clock.step = step;
    p.clock.limitedBy = "sound";
    addToProgressLog(out, p, summary);
  }
  std::vector<std::string> lines() const {
    std::ifstream file(progressLogPath(out));
    std::vector<std::string> all;
    for (std::string line; std::getline(file, line);) all.push_back(line);
    return all;
  }
};

TEST_F(ProgressLog, HasAValueForEachColumn) {
  beginProgressLog(out);
  summary.ledger.now.kinetic = 0.1;
  summary.solvers.push_back({"viscosity", 7, 6.5});
  add(3);
  const auto fields = [](const std::string& line) { return std::count(line.begin(), line.end(), ','); };
  ASSERT_EQ(lines().size(), 2u);
  EXPECT_EQ(fields(lines()[0]), fields(lines()[1]));
  EXPECT_TRUE(has(lines()[0], "step,time_s,dt_s,dt_limited_by")) << lines()[0];
  EXPECT_TRUE(has(lines()[0], "viscosity_iterations,viscosity_iterations_mean,contact_iterations"));
  EXPECT_TRUE(has(lines()[1], ",7,6.5,")) << lines()[1];
}

TEST_F(ProgressLog, ContinuesAfterARollback) {
  beginProgressLog(out);
  for (const std::int64_t step : {0, 50, 120}) add(step);
  std::ofstream(progressLogPath(out), std::ios::app) << "130,0.5";  // a kill in the middle of a line
  truncateProgressLog(out, 100);
  add(110);
  ASSERT_EQ(lines().size(), 4u);
  EXPECT_EQ(lines()[2].substr(0, 3), "50,");
  EXPECT_EQ(lines()[3].substr(0, 4), "110,");
  std::ofstream(progressLogPath(out)) << "step,other\n5,6\n";  // a log of another version
  truncateProgressLog(out, 100);
  EXPECT_EQ(lines().size(), 1u);
  EXPECT_TRUE(has(lines()[0], "step,time_s"));
}

}  // namespace
}  // namespace thaw
