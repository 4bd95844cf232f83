// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>
#include <zlib.h>

#include <cmath>
#include <limits>

#include "core/math/hash_random.hpp"
#include "io/commands/export/export_page.hpp"
#include "io/render/scene_marks.hpp"
#include "io/view/page/byte_planes.hpp"
#include "io/view/page/thinning.hpp"

namespace thaw {
namespace {

/// The inverse of bytePlanes.
std::vector<std::uint64_t> read(const std::vector<std::uint8_t>& planes, std::size_t components,
                                std::size_t width) {
  const std::size_t count = planes.size() / components / width;
  const std::uint64_t mask = width == 8 ? ~std::uint64_t{0} : (std::uint64_t{1} << (8 * width)) - 1;
  std::vector<std::uint64_t> values(count * components);
  for (std::size_t c = 0; c < components; c++)
    for (std::size_t i = 0; i < count; i++) {
      std::uint64_t step = 0;
      for (std::size_t b = 0; b < width; b++)
        step |= static_cast<std::uint64_t>(planes[(c * width + b) * count + i]) << (8 * b);
      values[i * components + c] = ((i > 0 ? values[(i - 1) * components + c] : 0) + step) & mask;
    }
  return values;
}

TEST(BytePlanes, HoldAllBitsOfWholeNumbers) {
  for (const int width : {1, 2, 4, 8}) {
    WholeRows rows{{}, 3, width};
    for (std::uint64_t k = 0; k < 300; k++) rows.values.push_back(mixBits(k) >> (64 - 8 * width));
    EXPECT_EQ(read(bytePlanes(rows), 3, static_cast<std::size_t>(width)), rows.values) << width;
  }
}

TEST(BytePlanes, QuantisedNumbersAreWithinHalfAStep) {
  std::vector<float> values;
  for (std::uint64_t k = 0; k < 1000; k++)
    values.push_back(static_cast<float>(mixBits(k) % 10007) * 1e-3f - 4);
  const QuantisedRows rows = quantised(values, 2, 2, {65534, 0});
  for (std::size_t k = 0; k < values.size(); k++) {
    const double value = rows.low[k % 2] + rows.step[k % 2] * static_cast<double>(rows.codes.values[k]);
    EXPECT_NEAR(value, values[k], 0.51 * rows.step[k % 2]);
  }
  EXPECT_LT(rows.step[0], 2e-4);
}

TEST(BytePlanes, NumbersThatAreNotFiniteHaveTheLargestCode) {
  const float inf = std::numeric_limits<float>::infinity();
  const QuantisedRows rows = quantised(std::vector<float>{1, NAN, 3, inf}, 1, 1, {254, 0});
  EXPECT_EQ(rows.codes.values, (std::vector<std::uint64_t>{0, 255, 254, 255}));
  const QuantisedRows none = quantised(std::vector<float>{NAN}, 1, 1, {254, 0});
  EXPECT_EQ(none.codes.values, (std::vector<std::uint64_t>{255}));
}

TEST(BytePlanes, ASmallestStepLeavesFewerCodes) {
  const QuantisedRows rows = quantised(std::vector<float>{0, 1}, 1, 2, {65534, 0.25});
  EXPECT_EQ(rows.codes.values, (std::vector<std::uint64_t>{0, 4}));
}

TEST(BytePlanes, OctahedralCodesKeepDirections) {
  for (std::uint64_t k = 0; k < 200; k++) {
    Vec3d n = normalized({static_cast<double>(mixBits(3 * k) % 2001) - 1000,
                          static_cast<double>(mixBits(3 * k + 1) % 2001) - 1000,
                          static_cast<double>(mixBits(3 * k + 2) % 2001) - 1000});
    const std::vector<std::int16_t> packed{static_cast<std::int16_t>(32767 * n.x),
                                           static_cast<std::int16_t>(32767 * n.y),
                                           static_cast<std::int16_t>(32767 * n.z), 0};
    const WholeRows rows = octahedral(packed);
    double u = static_cast<double>(rows.values[0]) / 511 - 1,
           v = static_cast<double>(rows.values[1]) / 511 - 1;
    const double z = 1 - std::abs(u) - std::abs(v);
    if (z < 0) {
      const double folded = (1 - std::abs(v)) * (u < 0 ? -1 : 1);
      v = (1 - std::abs(u)) * (v < 0 ? -1 : 1), u = folded;
    }
    EXPECT_GT(dot(normalized({u, v, z}), n), std::cos(0.004)) << n.x << ' ' << n.y << ' ' << n.z;
  }
}

TEST(BytePlanes, AStreamIsReadByZlib) {
  const std::string text(5000, 'x'), stream = deflated(text);
  EXPECT_LT(stream.size(), 100u);
  std::string back(5000, ' ');
  uLongf size = back.size();
  ASSERT_EQ(uncompress(reinterpret_cast<Bytef*>(back.data()), &size,
                       reinterpret_cast<const Bytef*>(stream.data()), static_cast<uLong>(stream.size())),
            Z_OK);
  EXPECT_EQ(back, text);
}

TEST(BytePlanes, Base64IsThatOfTheStandard) {
  EXPECT_EQ(base64(""), "");
  EXPECT_EQ(base64("f"), "Zg==");
  EXPECT_EQ(base64("fo"), "Zm8=");
  EXPECT_EQ(base64("foo"), "Zm9v");
  EXPECT_EQ(base64("\xff\xfe"), "//4=");
}

TEST(PageThinning, LeavesOutTensorsThenFramesThenPoints) {
  const PageSizes sizes{240, 40000, true};
  Thinning t;
  EXPECT_TRUE(thinFurther(sizes, t));
  EXPECT_FALSE(t.tensors);
  EXPECT_EQ(t.every, 1u);
  for (std::size_t before = 1; t.most == 500000u; before = t.every) {
    ASSERT_TRUE(thinFurther(sizes, t));
    EXPECT_LE(t.every, 2 * before);
  }
  const std::size_t left = (240 + t.every - 1) / t.every;
  EXPECT_TRUE(left >= 8 && left <= 11) << left;
  EXPECT_EQ(t.most, 30000u);
  EXPECT_TRUE(thinFurther(sizes, t));
  EXPECT_EQ(t.most, 22500u);
}

// Particles beside a surface go before most frames and before any of its points.
TEST(PageThinning, LeavesOutParticlesBesideASurface) {
  for (const bool spare : {true, false}) {
    const PageSizes sizes{240, 40000, false, true, spare};
    Thinning t;
    while (t.most == 500000u && t.particles) ASSERT_TRUE(thinFurther(sizes, t));
    EXPECT_EQ(t.particles, !spare);
    if (spare) { EXPECT_TRUE(t.every <= 4 && t.most == 500000u && t.meshes); }
  }
}

TEST(PageThinning, EndsAndKeepsTheFirstAndTheLastFrame) {
  const PageSizes sizes{101, 3000, false};
  Thinning t;
  int steps = 0;
  while (thinFurther(sizes, t)) ASSERT_LT(++steps, 100);
  EXPECT_TRUE(isKept(0, sizes, t));
  EXPECT_TRUE(isKept(100, sizes, t));
  EXPECT_FALSE(isKept(1, sizes, t));
}

TEST(ExportPage, ReadsSizes) {
  EXPECT_EQ(bytesOfText("20MB"), 20'000'000u);
  EXPECT_EQ(bytesOfText("1.5 MB"), 1'500'000u);
  EXPECT_EQ(bytesOfText("800kB"), 800'000u);
  EXPECT_EQ(bytesOfText("123456"), 123456u);
  for (const char* wrong : {"", "MB", "20 apples", "-1MB", "0", "nan", "1e99GB"})
    EXPECT_THROW(bytesOfText(wrong), std::invalid_argument) << wrong;
}

TEST(SceneMarks, HaveEmittersClampsDomainAndCamera) {
  Scene scene;
  scene.spacing = 0.1;
  Body body;
  body.name = "beam";
  body.shape.size = {2, 0.5, 0.5};
  body.clamp.emplace_back();  // a cube of 1 m
  body.clamp.back().move = {-1, 0, 0};
  scene.bodies.push_back(body);
  scene.emitters.emplace_back();
  scene.emitters.back().name = "tap";
  scene.output.camera.fitted = false;
  const std::vector<Mark> marks = sceneMarks(scene);
  ASSERT_EQ(marks.size(), 4u);
  EXPECT_EQ(marks[0].kind, MarkKind::Emitter);
  EXPECT_EQ(marks[0].name, "tap");
  EXPECT_EQ(marks[1].kind, MarkKind::Clamp);
  EXPECT_EQ(marks[1].lines.size(), 12u);
  for (const auto& line : marks[1].lines)  // the part of the clamp within the beam, and a margin
    for (const Vec3d& end : line) {
      EXPECT_TRUE(std::abs(end.x + 1.02) < 1e-9 || std::abs(end.x + 0.48) < 1e-9) << end.x;
      EXPECT_NEAR(std::abs(end.y), 0.27, 1e-9);
    }
  EXPECT_EQ(marks[2].kind, MarkKind::Domain);
  EXPECT_EQ(marks[3].kind, MarkKind::Camera);
}

}  // namespace
}  // namespace thaw
