// SPDX-License-Identifier: Apache-2.0
// Frames of surfaces, particles and oriented bodies in a temporary folder, and `thaw export` of them.
#pragma once
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "io/commands/export.hpp"
#include "tests/support/surface/surfel_samples.hpp"

namespace thaw::test {

namespace fs = std::filesystem;

class Export : public testing::Test {
 protected:
  fs::path folder = fs::path(testing::TempDir()) /
                    ("thaw_export_" +
                     std::string(testing::UnitTest::GetInstance()->current_test_info()->name()));
  SurfelSamples surfels;
  Export() {
    fs::remove_all(folder);
    fs::create_directories(folder / "frames");
    sampleBall(surfels, {0, 0, 0.5}, 0.5, 0.05, 3);
    sampleBall(surfels, {2, 0, 0.5}, 0.2, 0.05, 9);
    for (std::size_t i = 0; i < surfels.size(); i++)
      surfels.temperature[i] = 300 + 100 * surfels.positions[i].z;
  }
  ~Export() override { fs::remove_all(folder); }

  fs::path surfaceFrame(int number) {
    fs::path path = folder / "frames" / ("wax_surface_00000" + std::to_string(number) + ".hdf");
    writeSurfaceFrame(path.string(), surfels, 0.1 * number);
    return path;
  }
  fs::path particleFrame(int number) {
    fs::path path = folder / "frames" / ("wax_00000" + std::to_string(number) + ".hdf");
    Frame frame;
    frame.count = surfels.size();
    frame.positions = {"position", "m", Scalar::F32, 3, surfels.positions.data()};
    frame.fields = {{"temperature", "K", Scalar::F32, 1, surfels.temperature.data()}};
    startMpi();
    writeFrame(path.string(), MPI_COMM_SELF, frame, {});
    return path;
  }
  int run(const fs::path& input, const std::string& as, const fs::path& out = {},
          const std::string& field = "surface") {
    ExportOptions o;
    o.input = input, o.as = as, o.out = out, o.field = field;
    return exportCommand(o);
  }
};

inline std::string contentOf(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  std::stringstream text;
  text << in.rdbuf();
  return text.str();
}

template<class F> std::string errorOf(F what) {
  try {
    what();
  } catch (const std::exception& error) { return error.what(); }
  return "no error";
}

/// Two flat rows and a curve of oriented particles. `turn` rotates the order of the rows.
inline std::filesystem::path writeOriented(const std::filesystem::path& path, std::size_t turn) {
  std::vector<Vec3d> places;
  std::vector<std::uint32_t> groups;
  std::vector<std::uint64_t> ids;
  for (int k = 0; k < 12; k++)
    places.push_back({(k / 2) + 0.5 * (k % 2), 0.866 * (k % 2), 0}), groups.push_back(0),
        ids.push_back(static_cast<std::uint64_t>(k));
  for (int k = 0; k < 5; k++)
    places.push_back({static_cast<double>(k), 9, 0}), groups.push_back(1),
        ids.push_back(std::uint64_t(1) << 63 | static_cast<std::uint64_t>(k));
  const auto turned = [&](auto& v) {
    std::rotate(v.begin(), v.begin() + static_cast<std::ptrdiff_t>(turn), v.end());
  };
  turned(places), turned(groups), turned(ids);
  const std::size_t n = places.size();
  std::vector<float> turns, radii(n, 1);
  for (std::size_t k = 0; k < n; k++) turns.insert(turns.end(), {1, 0, 0, 0});
  const std::vector<std::uint16_t> bodies(n, 0);
  const std::vector<std::uint64_t> cuts(n, 0);
  const std::vector<std::uint8_t> flags(n, 0);
  Frame frame;
  frame.count = n;
  frame.positions = {"position", "m", Scalar::F64, 3, places.data()};
  frame.fields = {{"id", "1", Scalar::U64, 1, ids.data()},
                  {"oriented_body", "1", Scalar::U16, 1, bodies.data()},
                  {"orientation", "1", Scalar::F32, 4, turns.data()},
                  {"radius", "m", Scalar::F32, 1, radii.data()},
                  {"group", "1", Scalar::U32, 1, groups.data()},
                  {"cut_sides", "1", Scalar::U64, 1, cuts.data()},
                  {"flags", "1", Scalar::U8, 1, flags.data()}};
  startMpi();
  writeFrame(path.string(), MPI_COMM_SELF, frame, {});
  return path;
}

}  // namespace thaw::test
