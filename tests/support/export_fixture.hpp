// SPDX-License-Identifier: Apache-2.0
// Frames of a surface and of particles in a temporary folder, and `thaw export` of them.
#pragma once
#include <gtest/gtest.h>

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
    const fs::path path = folder / "frames" / ("wax_surface_00000" + std::to_string(number) + ".hdf");
    writeSurfaceFrame(path.string(), surfels, 0.1 * number);
    return path;
  }
  fs::path particleFrame(int number) {
    const fs::path path = folder / "frames" / ("wax_00000" + std::to_string(number) + ".hdf");
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

}  // namespace thaw::test
