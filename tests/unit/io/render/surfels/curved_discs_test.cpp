// SPDX-License-Identifier: Apache-2.0
// Discs in parts lie on the surface between the surfels without holes. Flat regions and sharp edges have
// none.
#include "io/render/surfels/curved_discs.hpp"

#include <gtest/gtest.h>

#include <cmath>

using namespace thaw;

namespace {

struct Ball {
  std::vector<Vec3f> positions, normals;
  std::vector<float> radii;
  explicit Ball(int n) {
    for (int k = 0; k < n; k++) {
      const float z = 1 - (2 * static_cast<float>(k) + 1) / static_cast<float>(n),
                  across = std::sqrt(1 - z * z), angle = 2.3999632f * static_cast<float>(k);
      positions.push_back({across * std::cos(angle), across * std::sin(angle), z});
    }
    normals = positions;
    radii.assign(positions.size(), 1.25f * std::sqrt(4 * 3.14159265f / (0.866f * static_cast<float>(n))));
  }
  Discs discs() const { return {positions, radii, normals}; }
};

}  // namespace

TEST(CurvedDiscs, CoverTheSphereOfADropOfTwentyFourSurfels) {
  const Ball drop(24), directions(2000);
  const std::vector<DiscPart> parts = curvedDiscs(drop.discs(), {}, [](std::uint32_t) { return 0.01f; });
  EXPECT_EQ(parts.size(), 24u * 37u);
  for (const DiscPart& p : parts) {
    const float r = std::sqrt(dot(p.position, p.position));
    EXPECT_NEAR(r, 1, 0.01);
    EXPECT_GT(dot(p.position, p.normal) / r, 0.985f);
    float shares = 0;
    for (const DiscPart::Share& s : p.mix) shares += s.share;
    EXPECT_NEAR(shares, 1, 1e-5);
  }
  for (const Vec3f& d : directions.positions) {
    bool covered = false;
    for (const DiscPart& p : parts)
      covered = covered || dot(d - p.position, d - p.position) < p.radius * p.radius;
    EXPECT_TRUE(covered);
  }
}

TEST(CurvedDiscs, StayWholeOnFlatFacesAndSharpEdges) {
  std::vector<Vec3f> positions, normals;  // two faces of a cube
  for (int i = 0; i < 10; i++)
    for (int j = 0; j < 10; j++) {
      positions.push_back({0.1f * (static_cast<float>(i) + 0.5f), 0.1f * (static_cast<float>(j) + 0.5f), 1}),
          normals.push_back({0, 0, 1});
      positions.push_back({1, 0.1f * (static_cast<float>(j) + 0.5f), 0.1f * (static_cast<float>(i) + 0.5f)}),
          normals.push_back({1, 0, 0});
    }
  const std::vector<float> radii(positions.size(), 0.125f);
  EXPECT_EQ(curvedDiscs({positions, radii, normals}, {}, [](std::uint32_t) { return 1e-4f; }).size(),
            positions.size());
}
