// SPDX-License-Identifier: Apache-2.0
// The folder of a small run in a temporary folder, and requests for it to `thaw view`.
#pragma once
#include <gtest/gtest.h>

#include <cstring>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "io/frames/series.hpp"
#include "io/scene/read_scene.hpp"
#include "io/view/server/routes.hpp"
#include "tests/support/surface/surfel_samples.hpp"

namespace thaw::test {

namespace fs = std::filesystem;

/// A run "wax" with frames of particles.
class ViewRun : public testing::Test {
 protected:
  fs::path folder = fs::path(testing::TempDir()) /
                    ("thaw_view_" +
                     std::string(testing::UnitTest::GetInstance()->current_test_info()->name()));
  fs::path run = folder / "wax";
  std::vector<std::uint64_t> ids;
  std::vector<Vec3f> positions, velocities;
  std::vector<std::uint16_t> bodies;
  std::vector<SeriesEntry> entries;
  ViewRun() {
    fs::remove_all(folder);
    fs::create_directories(run / "frames");
    std::ofstream(folder / "secret.txt") << "secret";
    std::ofstream(run / "ledger.csv") << "step,time_s,kinetic_J\n0,0,1.5\n1,0.5,inf\n2,1,2.5\n3,1.5";
    std::ofstream(run / "summary.json") << R"({"status": "done", "message": "", "title": "Wax", "end_s": 2})";
  }
  ~ViewRun() override { fs::remove_all(folder); }

  /// Makes n particles on a line, with ids from a large number on.
  void sample(std::size_t n) {
    ids.clear(), positions.clear(), velocities.clear(), bodies.clear();
    for (std::size_t i = 0; i < n; i++) {
      const auto x = static_cast<float>(i);
      ids.push_back((std::uint64_t{1} << 60) + i);
      positions.push_back({0.1f * x, 0.2f, 0.3f});
      velocities.push_back({3 * x, 4 * x, 0});
      bodies.push_back(static_cast<std::uint16_t>(i % 3));
    }
  }
  fs::path frame(std::int64_t number) const { return run / "frames" / frameName("wax", number); }
  /// Writes a frame and its line in the index.
  void write(std::int64_t number) {
    Frame f;
    f.time = 0.5 * static_cast<double>(number);
    f.step = number;
    f.count = ids.size();
    f.positions = {"position", "m", Scalar::F32, 3, positions.data()};
    f.fields = {{"id", "1", Scalar::U64, 1, ids.data()},
                {"velocity", "m/s", Scalar::F32, 3, velocities.data()},
                {"body", "1", Scalar::U16, 1, bodies.data()}};
    startMpi();
    writeFrame(frame(number).string(), MPI_COMM_SELF, f,
               {"wax", "# ---- /scenes/wax.toml\n" + std::string(exampleScene())});
    entries.push_back({frameName("wax", number), f.time});
    writeSeries(seriesPath(run.string(), "wax"), entries);
  }

  ViewState state{run, "0123456789abcdef0123456789abcdef"};
  /// Returns the reply to a request as the page sends it. path: behind the token.
  ViewReply get(const std::string& path, const std::map<std::string, std::string>& query = {}) {
    return answer(state, {"GET", "/" + state.token + "/" + path, query, "127.0.0.1:8573", {}, "same-origin"});
  }
  nlohmann::ordered_json json(const std::string& path, const std::map<std::string, std::string>& query = {}) {
    return nlohmann::ordered_json::parse(get(path, query).body);
  }
};

/// A packet as the page reads it.
struct ReadPacket {
  nlohmann::ordered_json header;
  std::string data;
  explicit ReadPacket(const std::string& bytes) {
    std::uint32_t length = 0;
    std::memcpy(&length, bytes.data(), sizeof length);
    header = nlohmann::ordered_json::parse(bytes.substr(4, length));
    data = bytes.substr(4 + length);
  }
  template<class T> std::vector<T> array(const std::string& name) const {
    const auto& a = header.at("arrays").at(name);
    std::vector<T> values(a.at("rows").get<std::size_t>() * a.at("components").get<std::size_t>());
    const auto offset = a.at("offset").get<std::size_t>();
    EXPECT_LE(offset + values.size() * sizeof(T), data.size());
    if (!values.empty()) std::memcpy(values.data(), data.data() + offset, values.size() * sizeof(T));
    return values;
  }
};

}  // namespace thaw::test
