// SPDX-License-Identifier: Apache-2.0
#include "io/view/frames/mesh_packet.hpp"

#include <future>

#include "io/view/page/thinning.hpp"
#include "tests/support/view_run.hpp"

namespace thaw::test {
namespace {

class ViewMesh : public ViewRun {
 protected:
  SurfelSamples surfels;
  ViewMesh() {
    sampleBall(surfels, {0, 0, 0.5}, 0.5, 0.05, 3);
    writeSurfaceFrame((run / "frames" / "wax_surface_000000.hdf").string(), surfels, 0);
    writeSeries(seriesPath(run.string(), "wax_surface"), {{"wax_surface_000000.hdf", 0}});
  }
  ReadPacket mesh(const std::string& most) {
    return ReadPacket(get("api/mesh", {{"number", "0"}, {"type", "surface"}, {"most", most}}).body);
  }
};

TEST_F(ViewMesh, TheMeshIsClosedAndLiesOnTheSurface) {
  const ReadPacket packet = mesh("100000");
  const std::vector<float> x = packet.array<float>("position");
  const std::vector<std::int16_t> n = packet.array<std::int16_t>("normal");
  ASSERT_GT(x.size(), 3 * 500u);
  ASSERT_EQ(n.size() / 4, x.size() / 3);
  for (std::size_t v = 0; v < x.size() / 3; v++) {
    const Vec3d from = Vec3d{x[3 * v], x[3 * v + 1], x[3 * v + 2]} - Vec3d{0, 0, 0.5};
    EXPECT_NEAR(length(from), 0.5, 0.005);
    EXPECT_GT(dot(from, Vec3d{1.0 * n[4 * v], 1.0 * n[4 * v + 1], 1.0 * n[4 * v + 2]}), 0.98 * 0.5 * 32767);
  }
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
  const std::vector<std::uint32_t> t = packet.array<std::uint32_t>("triangles");
  for (std::size_t k = 0; k < t.size(); k++) {
    const std::uint32_t a = t[k], b = t[k % 3 == 2 ? k - 2 : k + 1];
    edges[{std::min(a, b), std::max(a, b)}] += a < b ? 1 : -1;
  }
  for (const auto& [edge, sum] : edges) EXPECT_EQ(sum, 0) << edge.first << ' ' << edge.second;
}

TEST_F(ViewMesh, VerticesNameTheNearestDrawnSurfel) {
  for (const std::string most : {"100000", "300"}) {
    const std::vector<float> drawn =
        ReadPacket(get("api/frame", {{"number", "0"}, {"type", "surface"}, {"most", most}}).body)
            .array<float>("position");
    const ReadPacket packet = mesh(most);
    const std::vector<float> x = packet.array<float>("position");
    const std::vector<std::uint32_t> surfel = packet.array<std::uint32_t>("surfel");
    ASSERT_EQ(surfel.size(), x.size() / 3);
    const auto away = [&](std::size_t v, std::size_t i) {
      return length(Vec3d{x[3 * v], x[3 * v + 1], x[3 * v + 2]} -
                    Vec3d{drawn[3 * i], drawn[3 * i + 1], drawn[3 * i + 2]});
    };
    for (std::size_t v = 0; v < surfel.size(); v += 7) {
      ASSERT_LT(surfel[v], drawn.size() / 3);
      for (std::size_t i = 0; i < drawn.size() / 3; i++)
        ASSERT_LE(away(v, surfel[v]), away(v, i) + 1e-6) << most;
    }
  }
}

TEST_F(ViewMesh, FewerPointsGiveACoarserMesh) {
  EXPECT_LT(mesh("300").array<float>("position").size(), mesh("100000").array<float>("position").size() / 4);
  EXPECT_EQ(detailForPage(1000, 100000).cell, 1);
  EXPECT_GT(detailForPage(100000, 100000).cell, 2);
}

TEST_F(ViewMesh, OtherRequestsGoOnWhileAMeshIsMade) {
  std::unique_lock busy(state.meshes.making());
  auto made = std::async(std::launch::async, [&] { return mesh("5000").data.size(); });
  for (int k = 0; k < 20; k++) EXPECT_EQ(get("api/run").status, 200);
  EXPECT_EQ(made.wait_for(std::chrono::milliseconds(50)), std::future_status::timeout);
  busy.unlock();
  EXPECT_GT(made.get(), 1000u);
  busy.lock();
  EXPECT_GT(mesh("5000").data.size(), 1000u) << "it is kept, so nothing is made";
}

TEST_F(ViewMesh, OnlySurfacesHaveMeshes) {
  sample(4);
  write(0);
  EXPECT_EQ(get("api/mesh", {{"number", "0"}, {"type", "particles"}}).status, 400);
  EXPECT_EQ(get("api/mesh", {{"number", "7"}, {"type", "surface"}}).status, 422);
  std::ofstream(run / "frames" / "wax_surface_000000.hdf") << "damaged";
  EXPECT_EQ(get("api/mesh", {{"number", "0"}, {"type", "surface"}}).status, 422);
}

TEST(Thinning, LeavesOutMeshesLast) {
  Thinning t;
  const PageSizes sizes{100, 20000, true, true};
  int steps = 0;
  while (t.meshes) {
    ASSERT_TRUE(thinFurther(sizes, t)) << steps;
    steps++;
  }
  EXPECT_GT(steps, 10);
  EXPECT_FALSE(thinFurther(sizes, t));
}

}  // namespace
}  // namespace thaw::test
