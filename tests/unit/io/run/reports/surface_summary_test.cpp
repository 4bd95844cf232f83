// SPDX-License-Identifier: Apache-2.0
#include "io/run/reports/surface_summary.hpp"

#include <gtest/gtest.h>

namespace thaw {
namespace {

SurfaceSummary summaryOf(const SurfaceCounters& counters) {
  SurfaceSummary s;
  s.there = true;
  s.surfels = 1000;
  s.counters = counters;
  return s;
}

/// Returns the number of lines with a text.
int linesWith(const std::vector<std::string>& lines, const char* text) {
  int count = 0;
  for (const std::string& line : lines) count += line.find(text) != std::string::npos;
  return count;
}

SurfaceCounters countersOf(std::int64_t lost, std::int64_t flipped, std::int64_t unfinished) {
  SurfaceCounters c;
  c.updates = 100;
  c.lost = lost, c.flipped = flipped, c.unfinished = unfinished;
  return c;
}

TEST(SurfaceSummary, RareCorrectionsAreLinesAndFrequentOnesWarnings) {
  // Shares of 1000 surfels in 100 updates, just below and at the limits.
  const SurfaceSummary rare = summaryOf(countersOf(199, 1999, 4)),
                       frequent = summaryOf(countersOf(200, 2000, 5));
  EXPECT_TRUE(surfaceWarnings(rare).empty());
  EXPECT_EQ(linesWith(surfaceLines(rare), "usually not visible"), 3);
  EXPECT_EQ(linesWith(surfaceLines(frequent), "usually not visible"), 0);
  const std::vector<std::string> warnings = surfaceWarnings(frequent);
  ASSERT_EQ(warnings.size(), 3u);
  EXPECT_EQ(linesWith(warnings, "200 surfels (0.2 % per update) had no particles nearby"), 1);
  EXPECT_EQ(linesWith(warnings, "2000 surfel normals (2 % per update) pointed inward"), 1);
  EXPECT_EQ(linesWith(warnings, "5 of 100 updates"), 1);
  EXPECT_EQ(linesWith(warnings, "pictures"), 3);
}

TEST(SurfaceSummary, AnEmptySurfaceHasNoCorrections) {
  const SurfaceSummary s = summaryOf(countersOf(0, 0, 0));
  EXPECT_TRUE(surfaceWarnings(s).empty());
  EXPECT_EQ(linesWith(surfaceLines(s), "visible"), 0);
}

}  // namespace
}  // namespace thaw
