// SPDX-License-Identifier: Apache-2.0
// The log of components stays whole when a run rolls back or continues.
#include "io/run/reports/surface_log.hpp"

#include <gtest/gtest.h>

#include <unistd.h>
#include <filesystem>
#include <fstream>

#include <sstream>

#include "core/simulation/world/world.hpp"

namespace thaw::test {
namespace {

struct Log : ::testing::Test {
  std::string out = std::filesystem::temp_directory_path() /
                    ("thaw_surface_log_" + std::to_string(::getpid()));
  Log() { std::filesystem::create_directories(out); }
  ~Log() override { std::filesystem::remove_all(out); }
  std::string text(const std::string& path) const {
    std::ifstream in(path);
    std::stringstream s;
    s << in.rdbuf();
    return s.str();
  }
  void frame(std::int64_t number, std::int64_t step) const {
    World w;
    w.clock.frame = number;
    w.clock.step = step;
    w.clock.time = 0.1 * static_cast<double>(number);
    w.surface.components = {{5, 10, 20, 1.5, 2.5, 0.1 + 0.2, 4.5, {1, 2, 3}},
                            {9, 1, 2, 3, 4, 5, 6, {7, 8, 9}}};
    addToComponentLog(out, w.surface, w.clock);
  }
};

}  // namespace

TEST_F(Log, IsTruncatedAtAStep) {
  beginComponentLog(out);
  frame(0, 0);
  frame(1, 12);
  const std::string whole = text(componentLogPath(out));
  EXPECT_NE(whole.find("1,12,0.1,5,10,20,1.5,2.5,0.30000000000000004,4.5,1,2,3,0,0\n"), std::string::npos)
      << whole;
  frame(2, 25);
  std::ofstream(componentLogPath(out), std::ios::app) << "3,4";  // a kill in the middle of a line
  truncateComponentLog(out, 24);
  EXPECT_EQ(text(componentLogPath(out)), whole);
  frame(2, 25);
  truncateComponentLog(out, 25);
  EXPECT_NE(text(componentLogPath(out)).find("2,25,"), std::string::npos);
  std::filesystem::remove(componentLogPath(out));
  truncateComponentLog(out, 25);
  EXPECT_EQ(text(componentLogPath(out)).find("frame,step,time_s,component"), 0u);
}

TEST_F(Log, ReportsTheWorstVolumeOfTheRemainingFrames) {
  World w;
  VolumeErrors noted;
  beginComponentLog(out);
  const double off[] = {0.004, -0.03, 0.2};
  for (int k = 0; k < 3; k++) {
    w.clock.frame = k, w.clock.step = 10 * k, w.clock.time = 0.1 * k;
    SurfaceComponent c{7, 400, 900, 1, 2, 2 * (1 + off[k]), 4, {1, 2, 3}},
        small{9, 29, 60, 1, 2, 2 - 0.6 * k, 4, {}}, drop{10, 4, 11, 1, 1, 1.005, 4, {}};
    c.targetVolume = 1.96;
    small.targetVolume = 2;
    c.open = 0.004 * (k + 1), small.open = 0.2;
    w.surface.components = {c, small, drop};
    addToComponentLog(out, w.surface, w.clock);
    if (k < 2) recordVolumes(noted, w.surface.components, w.clock.time);
  }
  const VolumeErrors errors = truncateComponentLog(out, 10);
  ASSERT_TRUE(errors.any);
  EXPECT_EQ(errors.againstParticles.off, noted.againstParticles.off);  // the same bits as in an uninterrupted
                                                                       // run
  EXPECT_EQ(errors.againstTarget.off, noted.againstTarget.off);
  EXPECT_NEAR(errors.againstParticles.off, -0.03, 1e-12);
  EXPECT_EQ(errors.againstParticles.time, 0.1);
  EXPECT_NEAR(errors.againstTarget.off, 2.008 / 1.96 - 1, 1e-12);
  EXPECT_EQ(errors.againstTarget.label, 7u);
  EXPECT_EQ(errors.againstTarget.time, 0);
  EXPECT_EQ(errors.small.off, noted.small.off);
  EXPECT_NEAR(errors.small.off, -0.3, 1e-12);
  EXPECT_EQ(errors.small.label, 9u);
  EXPECT_EQ(errors.sum.off(), noted.sum.off());
  EXPECT_NEAR(errors.sum.off(), (1.94 + 1.4 + 1.005) / 4.96 - 1, 1e-12);
  EXPECT_EQ(errors.sum.time, 0.1);
  EXPECT_EQ(errors.missing.missed, 429);
  EXPECT_EQ(errors.missed, 829);  // 400 at the first frame
  EXPECT_EQ(errors.particles, 866);
  EXPECT_EQ(errors.open.off, 0.008);  // a component of 29 particles does not count
  EXPECT_EQ(errors.open.label, 7u);
  EXPECT_EQ(errors.unsure, 0);
  const std::vector<std::string> lines = volumeErrorLines(errors);
  ASSERT_EQ(lines.size(), 3u);
  EXPECT_NE(lines[0].find("the sum at most -12.40 % off the target (t 0.1 s); 95.7 % of the particles are "
                          "in components more than 1 % off (99.1 % in the worst frame, t 0.1 s)"),
            std::string::npos)
      << lines[0];
  EXPECT_NE(lines[1].find("at most -3.00 % (component 7 of 400 particles, t 0.1 s) off the volume of the "
                          "particles, +2.45 % (component 7"),
            std::string::npos)
      << lines[1];
  EXPECT_NE(lines[2].find("of 5 to 29 particles: at most -30.00 % (component 9 of 29 particles, t 0.1 s)"),
            std::string::npos)
      << lines[2];
  EXPECT_NE(volumeErrorWarning(errors).find("One component was +2.4 % off (component 7"), std::string::npos)
      << volumeErrorWarning(errors);
}

TEST(VolumeErrors, WarnsAboutSmallComponentsAndTheSum) {
  const auto warning = [](std::vector<SurfaceComponent> components) {
    for (SurfaceComponent& c : components) c.targetVolume = c.particleVolume;
    VolumeErrors errors;
    recordVolumes(errors, components, 0);
    return volumeErrorWarning(errors);
  };
  const SurfaceComponent body{7, 10000, 900, 1, 100, 100.5, 4, {}};
  EXPECT_EQ(warning({body}), "");
  EXPECT_EQ(warning({body, {9, 5, 60, 1, 0.05, 0.046, 4, {}}}), "");
  EXPECT_NE(warning({body, {9, 5, 60, 1, 0.05, 0.025, 4, {}}})
                .find("One component was -50.0 % off (component 9 of 5 particles"),
            std::string::npos);
  std::vector<SurfaceComponent> spray{{7, 100, 900, 1, 1, 1, 4, {}}};
  for (std::uint64_t k = 0; k < 10; k++) spray.push_back({9 + k, 3, 24, 1, 0.03, 0.029, 4, {}});
  EXPECT_NE(warning(spray).find("23.1 % of the particles are in components more than 1 % off"),
            std::string::npos)
      << warning(spray);
  EXPECT_TRUE(volumeErrorLines({}).empty());
}

TEST(VolumeErrors, WarnsAboutOpenSurfaces) {
  SurfaceComponent body{7, 100, 900, 1, 1, 1, 4, {}}, sure{9, 300, 900, 1, 3, 3, 4, {}};
  body.targetVolume = 1, body.open = 0.03;
  sure.targetVolume = 3, sure.open = 0.002;
  VolumeErrors errors;
  recordVolumes(errors, {body, sure}, 0.5);
  EXPECT_EQ(errors.unsure, 100);
  const std::vector<std::string> lines = volumeErrorLines(errors);
  ASSERT_EQ(lines.size(), 3u);
  EXPECT_NE(lines[2].find("25 % of the particles are in components of 30 and more whose surface is open by "
                          "more than 1 % of its area (at most 3 %: component 7 of 100 particles, t 0.5 s)"),
            std::string::npos)
      << lines[2];
  EXPECT_EQ(volumeErrorWarning(errors), "");
}

TEST_F(Log, KeepsLinesOfEarlierVersions) {
  std::ofstream(componentLogPath(out))
      << "an older head\n0,0,0,5,40,30,1,2,2.1,4,1,2,3\n1,5,0.1,5,40,30,1,2,2,4,1,2,3\n";
  const VolumeErrors errors = truncateComponentLog(out, 0);
  EXPECT_NE(text(componentLogPath(out)).find("target_volume_m3,open\n0,0,0,5,40,30,1,2,2.1,4,1,2,3,,\n"),
            std::string::npos)
      << text(componentLogPath(out));
  EXPECT_NEAR(errors.againstParticles.off, 0.05, 1e-12);
  EXPECT_NEAR(errors.sum.off(), 0.05, 1e-12);
  EXPECT_EQ(errors.againstTarget.label, noComponent);
  const std::string once = text(componentLogPath(out));
  truncateComponentLog(out, 0);
  EXPECT_EQ(text(componentLogPath(out)), once);
}

TEST_F(Log, EventsFollowTheState) {
  writeEventLog(out, {{3, 0.5, SurfaceEventKind::Split, 1, 7},
                      {4, 0.75, SurfaceEventKind::Merge, 1, 7},
                      {5, 1, SurfaceEventKind::Renamed, 2, 1}});
  EXPECT_EQ(text(eventLogPath(out)),
            "step,time_s,kind,component,other\n3,0.5,split,1,7\n4,0.75,merge,1,7\n5,1,renamed,2,1\n");
  writeEventLog(out, {});
  EXPECT_EQ(text(eventLogPath(out)), "step,time_s,kind,component,other\n");
}

}  // namespace thaw::test
