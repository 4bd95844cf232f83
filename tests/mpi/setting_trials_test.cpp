// SPDX-License-Identifier: Apache-2.0
// `thaw check` tries settings on a scene before it recommends them. All ranks get the same result.
#include <gtest/gtest.h>

#include <fstream>

#include "io/commands/check/setting_trials.hpp"
#include "tests/support/output_sample.hpp"

using namespace thaw;
using namespace thaw::test;

namespace {

/// A scene file of falling water. All ranks have its name, and the first one reads it.
std::string fallingWater(const std::string& folder) {
  std::string path = folder + "/falling.toml";
  if (rankOf() == 0)
    std::ofstream(path)
        << "spacing = 0.05\nend = 0.5\n[domain]\nmin = [-0.5, -0.5, 0]\nmax = [0.5, 0.5, "
           "1]\n[material.water]\n"
           "[[body]]\nbox = { size = [0.4, 0.4, 0.4] }\nplace = { move = [0, 0, 0.5] }\nmaterial = 'water'\n";
  MPI_Barrier(MPI_COMM_WORLD);
  return path;
}

}  // namespace

TEST(SettingTrials, RejectSettingsThatFailOnTheScene) {
  const Folder folder;
  const Communicator comm;
  SettingTrials trials(comm, {fallingWater(folder.path), {}, 512});
  EXPECT_GE(trials.steps(), 100);
  const auto good = trials.failureOf({"numerics.cfl_sound=0.3"});
  ASSERT_TRUE(good);
  EXPECT_EQ(*good, "");
  EXPECT_EQ(trials.failureOfScene(), "");
  const auto bad = trials.failureOf({"numerics.fixed_step=0.1"});
  ASSERT_TRUE(bad);
  EXPECT_NE(*bad, "");
  const auto refused = trials.failureOf({"numerics.support=-1"});
  ASSERT_TRUE(refused);
  EXPECT_NE(refused->find("numerics.support: must be between"), std::string::npos) << *refused;
}

TEST(SettingTrials, ReportAFailureOfTheSceneItself) {
  const Folder folder;
  const Communicator comm;
  SettingTrials trials(comm, {fallingWater(folder.path), {"numerics.watch_speed=1e-3"}, 512});
  const auto failure = trials.failureOf({"numerics.cfl_sound=0.3"});
  ASSERT_TRUE(failure);
  EXPECT_NE(*failure, "");
  EXPECT_NE(trials.failureOfScene().find("numerics.watch_speed"), std::string::npos)
      << trials.failureOfScene();
}

TEST(SettingTrials, SkipLargeScenes) {
  const Folder folder;
  const Communicator comm;
  SettingTrials trials(comm, {fallingWater(folder.path), {}, 1e6});
  EXPECT_EQ(trials.steps(), 0);
  EXPECT_FALSE(trials.failureOf({"numerics.fixed_step=0.1"}));
}
