// SPDX-License-Identifier: Apache-2.0
#include "io/view/frames/frame_packet.hpp"

#include <cmath>
#include <limits>
#include <set>

#include "io/view/frames/thin_rows.hpp"
#include "tests/support/view_run.hpp"

using namespace thaw;
using namespace thaw::test;

namespace {

TEST(ThinRows, TheLevelLeavesAboutTheWantedNumber) {
  EXPECT_EQ(thinningLevel(0, 100), 0);
  EXPECT_EQ(thinningLevel(100, 100), 0);
  EXPECT_EQ(thinningLevel(102, 100), 0.5);
  EXPECT_EQ(thinningLevel(1000, 100), 3.5);
  EXPECT_EQ(thinningLevel(~std::uint64_t{0}, 0), 63);
}

TEST(ThinRows, AShareOfTheIdsStaysAndHigherLevelsAreNested) {
  constexpr std::uint64_t count = 100000;
  for (double level = 0; level < 6; level += levelStep) {
    std::uint64_t kept = 0;
    for (std::uint64_t id = 0; id < count; id++) {
      kept += staysAt(level, id);
      if (staysAt(level + levelStep, id)) { EXPECT_TRUE(staysAt(level, id)) << id; }
    }
    const double expected = static_cast<double>(count) / std::exp2(level);
    EXPECT_NEAR(static_cast<double>(kept), expected, 5 * std::sqrt(expected)) << level;
  }
}

TEST(ThinRows, ARowStaysByItsIdWhateverItsPlace) {
  std::vector<std::uint64_t> ids;
  for (std::uint64_t k = 0; k < 1000; k++) ids.push_back(k * 7 + (std::uint64_t{3} << 40));
  const std::vector<Vec3d> positions(ids.size());
  const auto idsAt = [&] {
    std::set<std::uint64_t> kept;
    for (const std::uint32_t row : rowsAt(2, positions, ids)) kept.insert(ids[row]);
    return kept;
  };
  const std::set<std::uint64_t> before = idsAt();
  std::reverse(ids.begin(), ids.end());
  EXPECT_EQ(before, idsAt());
  EXPECT_GT(before.size(), 150u);
}

TEST(ThinRows, TrianglesStayBetweenRowsThatStay) {
  FrameData frame;
  for (int k = 0; k < 5; k++) frame.positions.push_back({static_cast<double>(k), 0, 0});
  frame.triangles = {{0, 1, 2}, {2, 3, 4}, {0, 2, 4}};
  keepRows(frame, std::vector<std::uint32_t>{0, 2, 3, 4});
  ASSERT_EQ(frame.positions.size(), 4u);
  EXPECT_EQ(frame.positions[1].x, 2);
  EXPECT_EQ(frame.triangles, (std::vector<std::array<std::uint32_t, 3>>{{1, 2, 3}, {0, 1, 3}}));
}

TEST_F(ViewRun, PacketsHoldPositionsAndTheFieldWithItsRange) {
  sample(10);
  write(0);
  const ReadPacket packet(
      get("api/frame", {{"number", "0"}, {"type", "particles"}, {"field", "speed"}}).body);
  EXPECT_EQ(packet.header.at("count"), 10);
  EXPECT_EQ(packet.header.at("level"), 0);
  EXPECT_TRUE(packet.header.at("obstacles").is_array()) << "poses at the time of the frame";
  const std::vector<float> x = packet.array<float>("position"), v = packet.array<float>("value");
  ASSERT_EQ(x.size(), 30u);
  for (std::size_t i = 0; i < 10; i++) {
    EXPECT_EQ(x[3 * i], positions[i].x);
    EXPECT_FLOAT_EQ(v[i], 5 * static_cast<float>(i));
  }
  EXPECT_EQ(packet.header.at("field").at("max"), 45);
  const ReadPacket part(
      get("api/frame", {{"number", "0"}, {"type", "particles"}, {"field", "velocity"}, {"part", "1"}}).body);
  EXPECT_EQ(part.array<float>("value")[9], 36);
  EXPECT_EQ(
      get("api/frame", {{"number", "0"}, {"type", "particles"}, {"field", "velocity"}, {"part", "3"}}).status,
      422);
}

TEST_F(ViewRun, LabelsAreNoValues) {
  sample(10);
  write(0);
  const ReadPacket packet(get("api/frame", {{"number", "0"}, {"type", "particles"}, {"field", "body"}}).body);
  EXPECT_FALSE(packet.header.at("arrays").contains("value"));
  EXPECT_EQ(packet.array<std::uint32_t>("label")[5], 2u);
  for (const auto& field : packet.header.at("fields"))
    EXPECT_EQ(field.at("whole").get<bool>(), field.at("name") == "body") << field;
}

TEST_F(ViewRun, PositionsThatAreNotFiniteAreLeftOutAndCounted) {
  sample(10);
  positions[3].y = std::numeric_limits<float>::quiet_NaN();
  positions[4].z = std::numeric_limits<float>::infinity();
  write(0);
  const ReadPacket packet(get("api/frame", {{"number", "0"}, {"type", "particles"}}).body);
  EXPECT_EQ(packet.header.at("count"), 10);
  EXPECT_EQ(packet.header.at("finite"), 8);
  EXPECT_EQ(packet.array<float>("position").size(), 24u);
}

TEST_F(ViewRun, LargeFramesAreThinnedAndPointsFoundByIndexAndId) {
  sample(5000);
  write(0);
  std::map<std::string, std::string> query{{"number", "0"}, {"type", "particles"}, {"most", "1000"}};
  const ReadPacket packet(get("api/frame", query).body);
  EXPECT_EQ(packet.header.at("level"), 2.5);
  const std::vector<float> x = packet.array<float>("position");
  EXPECT_NEAR(static_cast<double>(x.size() / 3), 5000 / std::exp2(2.5), 110);
  EXPECT_LE(x.size() / 3, 1000u);
  query["index"] = "17";
  const auto byIndex = json("api/point", query);
  EXPECT_FLOAT_EQ(byIndex.at("position").at(0).get<float>(), x[3 * 17]);
  EXPECT_EQ(byIndex.at("fields").size(), 2u);
  query.erase("index");
  query["id"] = byIndex.at("id").get<std::string>();
  EXPECT_EQ(json("api/point", query), byIndex);
  // an id of 61 bits arrives whole
  EXPECT_GT(query["id"].size(), 18u);
  query["id"] = "12";
  EXPECT_EQ(get("api/point", query).status, 422);
}

TEST_F(ViewRun, SurfelsHaveNormalsRadiiAndColours) {
  SurfelSamples surfels;
  sampleBall(surfels, {0, 0, 0.5}, 0.5, 0.05, 3);
  writeSurfaceFrame((run / "frames" / "wax_surface_000000.hdf").string(), surfels, 0);
  writeSeries(seriesPath(run.string(), "wax_surface"), {{"wax_surface_000000.hdf", 0}});
  EXPECT_EQ(json("api/run").at("frames").at("has"), (std::vector<int>{2}));
  const ReadPacket packet(get("api/frame", {{"number", "0"}, {"type", "surface"}}).body);
  const std::vector<std::int16_t> n = packet.array<std::int16_t>("normal");
  ASSERT_EQ(n.size(), 4 * surfels.size());
  for (std::size_t i = 0; i < surfels.size(); i++)
    EXPECT_NEAR(n[4 * i + 2] / 32767.0, surfels.normals[i].z, 1e-4);
  EXPECT_EQ(packet.array<float>("radius").size(), surfels.size());
  EXPECT_EQ(get("api/frame", {{"number", "0"}, {"type", "particles"}}).status, 422);
}

}  // namespace
