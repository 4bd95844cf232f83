// SPDX-License-Identifier: Apache-2.0
#include "io/render/frame_source.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <functional>

#include "io/commands/render.hpp"
#include "io/hdf5/h5_file.hpp"

using namespace thaw;
namespace fs = std::filesystem;

namespace {

class FrameSource : public testing::Test {
 protected:
  fs::path folder = fs::path(testing::TempDir()) /
                    ("thaw_frames_" +
                     std::string(testing::UnitTest::GetInstance()->current_test_info()->name()));
  FrameSource() {
    fs::remove_all(folder);
    fs::create_directories(folder / "frames");
  }
  ~FrameSource() override { fs::remove_all(folder); }

  /// edges: m, of cubes with the particles' volumes; empty: the frame has no volumes.
  fs::path writeFrame(const std::string& name, double time, std::uint64_t count,
                      const std::vector<double>& edges = {}) {
    fs::path path = folder / "frames" / name;
    H5File file = H5File::create(path.string());
    for (const char* group : {"/VTKHDF", "/VTKHDF/PointData", "/VTKHDF/FieldData"}) file.createGroup(group);
    std::vector<double> points(3 * count), temperature(count), stress(6 * count);
    const std::vector<std::uint16_t> material(count);
    for (std::size_t i = 0; i < count; i++) {
      points[3 * i] = 0.1 * static_cast<double>(i % 5), points[3 * i + 1] = 0.1 * static_cast<double>(i / 5),
                 points[3 * i + 2] = time;
      temperature[i] = 300 + static_cast<double>(i);
      stress[6 * i] = 3, stress[6 * i + 3] = 4;
    }
    const std::int64_t number = static_cast<std::int64_t>(count);
    file.writeAll("/VTKHDF/NumberOfPoints", {Element::I64, 1, 0}, &number);
    file.writeAll("/VTKHDF/Points", {Element::F64, count, 3}, points.data());
    file.writeAll("/VTKHDF/PointData/velocity", {Element::F64, count, 3}, points.data());
    file.writeAll("/VTKHDF/PointData/temperature", {Element::F64, count, 0}, temperature.data());
    file.writeAll("/VTKHDF/PointData/stress", {Element::F64, count, 6}, stress.data());
    file.setText("/VTKHDF/PointData/temperature", "units", "K");
    file.writeAll("/VTKHDF/PointData/material", {Element::U16, count, 0}, material.data());
    std::vector<double> volumes;
    for (const double edge : edges) volumes.push_back(edge * edge * edge);
    if (!edges.empty()) file.writeAll("/VTKHDF/PointData/volume", {Element::F64, count, 0}, volumes.data());
    file.writeAll("/VTKHDF/FieldData/Time", {Element::F64, 1, 0}, &time);
    file.close();
    return path;
  }
  void writeIndex(const std::string& text) { std::ofstream(folder / "frames" / "a.hdf.series") << text; }
};

std::string errorOf(const std::function<void()>& what) {
  try {
    what();
  } catch (const std::runtime_error& error) { return error.what(); }
  return "no error";
}

}  // namespace

TEST_F(FrameSource, ReadsPositionsTimeAndAField) {
  fs::path path = writeFrame("a_0.hdf", 0.25, 10);
  FrameView view = readFrameView(path, "temperature");
  EXPECT_EQ(view.time, 0.25);
  EXPECT_EQ(view.unit, "K");
  ASSERT_EQ(view.positions.size(), 10u);
  EXPECT_FLOAT_EQ(view.positions[7].x, 0.2f);
  EXPECT_FLOAT_EQ(view.values[7], 307);
  view = readFrameView(path, "speed");
  EXPECT_FLOAT_EQ(view.values[7], std::sqrt(0.2f * 0.2f + 0.1f * 0.1f + 0.25f * 0.25f));
  EXPECT_FLOAT_EQ(readFrameView(path, "stress").values[3], std::sqrt(9.0f + 2 * 16.0f));
  EXPECT_TRUE(readFrameView(path, "").values.empty());
  EXPECT_EQ(fieldsOf(path), (std::vector<std::string>{"material", "stress", "temperature", "velocity"}));
}

TEST_F(FrameSource, FieldsOfIntegersAreWhole) {
  const fs::path path = writeFrame("a_0.hdf", 0, 10);
  EXPECT_TRUE(readFrameView(path, "material").whole);
  EXPECT_FALSE(readFrameView(path, "temperature").whole);
}

TEST_F(FrameSource, ParticlesHaveTheSizeOfTheirVolume) {
  fs::path path = writeFrame("a_0.hdf", 0, 3, {0.1, 0.05, 0.02});
  EXPECT_TRUE(readFrameView(path, "").sizes.empty()) << "the spacing is unknown";
  const FrameView view = readFrameView(path, "", {}, {Spray::Surfels, 0.1, 0});
  ASSERT_EQ(view.sizes.size(), 3u);
  EXPECT_FLOAT_EQ(view.sizes[0], 1);
  EXPECT_FLOAT_EQ(view.sizes[1], 0.5f);
  EXPECT_FLOAT_EQ(view.sizes[2], 0.2f);
  EXPECT_TRUE(readFrameView(writeFrame("a_1.hdf", 0, 3), "", {}, {Spray::Surfels, 0.1, 0}).sizes.empty());
}

TEST_F(FrameSource, FindsFramesByIndexOrByName) {
  for (const char* name : {"a_2.hdf", "a_0.hdf", "a_1.hdf"}) writeFrame(name, 0, 1);
  std::ofstream(folder / "frames" / "a_3.hdf.part") << "x";
  EXPECT_EQ(findFrames(folder).size(), 3u);
  EXPECT_EQ(findFrames(folder / "frames")[2].filename(), "a_2.hdf");
  writeIndex(
      R"({"file-series-version":"1.0","files":[{"name":"a_1.hdf","time":2},{"name":"a_0.hdf","time":1}]})");
  EXPECT_EQ(findFrames(folder),
            (std::vector<fs::path>{folder / "frames/a_0.hdf", folder / "frames/a_1.hdf"}));
  EXPECT_EQ(findFrames(folder / "frames" / "a.hdf.series").size(), 2u);
  EXPECT_EQ(findFrames(folder / "frames" / "a_2.hdf").size(), 1u);
}

TEST_F(FrameSource, EveryErrorNamesTheFile) {
  fs::path path = writeFrame("a_0.hdf", 0, 1000), cut = folder / "frames" / "cut.hdf",
           text = folder / "frames" / "text.hdf";
  EXPECT_NE(errorOf([&] {
              readFrameView(path, "colour");
            }).find("no field 'colour'; there are: material, stress, temperature, velocity"),
            std::string::npos);
  std::ofstream(text) << "not HDF5";
  fs::copy_file(path, cut);
  fs::resize_file(cut, fs::file_size(cut) / 2);
  for (const fs::path& bad : {cut, text, folder / "frames" / "none.hdf"})
    EXPECT_NE(errorOf([&] { readFrameView(bad, ""); }).find(bad.string()), std::string::npos) << bad;
  writeIndex("{");
  EXPECT_NE(errorOf([&] { findFrames(folder); }).find("a.hdf.series"), std::string::npos);
  EXPECT_NE(errorOf([&] { findFrames(folder / "nowhere"); }).find("no such file or folder"),
            std::string::npos);
}

TEST_F(FrameSource, CommandWritesPicturesAndReportsErrors) {
  for (int n = 0; n < 3; n++) writeFrame("a_" + std::to_string(n) + ".hdf", n, 25);
  RenderOptions options;
  options.input = folder;
  options.sheet = folder / "pictures" / "sheet.png";
  options.width = 100, options.height = 80;
  EXPECT_EQ(renderCommand(options), 0);
  for (const char* name : {"a_0.png", "a_1.png", "a_2.png", "sheet.png"})
    EXPECT_TRUE(fs::exists(folder / "pictures" / name)) << name;
  RenderOptions bad = options;
  bad.field = "colour";
  EXPECT_EQ(renderCommand(bad), 3);
  bad = options;
  bad.map = "jet";
  EXPECT_EQ(renderCommand(bad), 2);
  bad = options;
  bad.from = {1, 2, 3};
  EXPECT_EQ(renderCommand(bad), 2);
  bad = options;
  bad.input = folder / "nowhere";
  EXPECT_EQ(renderCommand(bad), 3);
}
