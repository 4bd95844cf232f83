// SPDX-License-Identifier: Apache-2.0
#include "io/render/render_frames.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "io/image/parallel_for.hpp"

using namespace thaw;
namespace fs = std::filesystem;

namespace {

/// A folder that is removed at the end of the test.
struct Folder {
  fs::path path = fs::path(testing::TempDir()) /
                  ("thaw_render_" +
                   std::string(testing::UnitTest::GetInstance()->current_test_info()->name()));
  Folder() { fs::remove_all(path); }
  ~Folder() { fs::remove_all(path); }
};

/// Writes frame `n.hdf`: a cube of 6^3 particles at height n, with temperature proportional to height.
FrameView cube(const fs::path& file, const std::string& field) {
  FrameView frame;
  const int n = std::stoi(file.stem().string());
  frame.time = 0.1 * n;
  frame.unit = "K";
  for (int i = 0; i < 216; i++) {
    frame.positions.push_back({0.1f * static_cast<float>(i % 6), 0.1f * static_cast<float>(i / 6 % 6),
                               0.1f * static_cast<float>(i / 36) + static_cast<float>(n)});
    if (!field.empty()) frame.values.push_back(static_cast<float>(300 + n));
  }
  return frame;
}

FrameJob jobOf(const Folder& folder) {
  FrameJob job;
  for (int n = 0; n < 7; n++) job.frames.push_back("frames/" + std::to_string(n) + ".hdf");
  job.out = folder.path / "pictures";
  job.sheet = folder.path / "pictures" / "all.png";
  job.width = 160;
  job.height = 120;
  job.cells = 4;
  job.columns = 2;
  job.field = "temperature";
  return job;
}

std::string bytes(const fs::path& path) {
  std::string s(fs::file_size(path), 0);
  FILE* f = fopen(path.c_str(), "rb");
  EXPECT_EQ(fread(s.data(), 1, s.size(), f), s.size());
  fclose(f);
  return s;
}

}  // namespace

TEST(RenderFrames, WritesEveryFrameAndTheSheet) {
  const Folder folder;
  const auto written = renderFrames(jobOf(folder), cube);
  ASSERT_EQ(written.size(), 8u);
  EXPECT_EQ(written[3], folder.path / "pictures" / "3.png");
  EXPECT_EQ(written.back().filename(), "all.png");
  for (const fs::path& p : written) EXPECT_GT(fs::file_size(p), 100u) << p;
}

TEST(RenderFrames, ThreadsDoNotChangeThePictures) {
  const Folder folder;
  FrameJob job = jobOf(folder);
  job.threads = 1;
  std::vector<std::string> one;
  for (const fs::path& p : renderFrames(job, cube)) one.push_back(bytes(p));
  job.threads = 5;
  std::size_t i = 0;
  for (const fs::path& p : renderFrames(job, cube)) EXPECT_EQ(bytes(p), one[i++]) << p;
}

TEST(RenderFrames, UnreadableFrameIsReported) {
  const Folder folder;
  const auto broken = [](const fs::path& file, const std::string& field) {
    if (file.stem() == "5") throw std::runtime_error(file.string() + ": truncated");
    return cube(file, field);
  };
  try {
    renderFrames(jobOf(folder), broken);
    FAIL();
  } catch (const std::runtime_error& error) { EXPECT_STREQ(error.what(), "frames/5.hdf: truncated"); }
  FrameJob none = jobOf(folder);
  none.frames.clear();
  EXPECT_THROW(renderFrames(none, cube), std::runtime_error);
}

TEST(RenderFrames, EmptyFramesAndOneParticleAreDrawn) {
  const Folder folder;
  FrameJob job = jobOf(folder);
  const auto nearlyNothing = [](const fs::path& file, const std::string&) {
    FrameView frame;
    if (file.stem() == "3") frame.positions.push_back({1, 2, 3}), frame.values.push_back(5);
    return frame;
  };
  EXPECT_EQ(renderFrames(job, nearlyNothing).size(), 8u);
  job.field.clear();
  EXPECT_EQ(renderFrames(job, cube).size(), 8u);
}

TEST(RenderFrames, FewDistantDropsDoNotMoveTheCamera) {
  std::vector<Vec3f> x = cube("0.hdf", "").positions;
  for (int k = 0; k < 5; k++) x.insert(x.end(), x.begin(), x.begin() + 216);
  x.push_back({1000, 1000, 1000});
  x.push_back({NAN, 0, 0});
  const ViewBox box = robustBox(x);
  EXPECT_FLOAT_EQ(static_cast<float>(box.max.x), 0.5f);
  EXPECT_FLOAT_EQ(static_cast<float>(box.min.z), 0.0f);
  EXPECT_TRUE(robustBox({}).empty());
}

TEST(ParallelFor, RunsEachPieceOnceAndForwardsErrors) {
  std::vector<int> done(1000, 0);
  parallelFor(done.size(), 4, [&](std::size_t i) { done[i]++; });
  for (int d : done) EXPECT_EQ(d, 1);
  EXPECT_THROW(parallelFor(100, 4,
                           [](std::size_t i) {
                             if (i == 17) throw std::runtime_error("17");
                           }),
               std::runtime_error);
  parallelFor(0, 4, [](std::size_t) { FAIL(); });
}
