// SPDX-License-Identifier: Apache-2.0
// Compression of USD crate files, read back by decoders in this file, and layers whose prims appear and
// disappear.
#include <cstring>

#include "core/math/hash_random.hpp"
#include "io/export/usd/lz4_block.hpp"
#include "io/export/usd/usd_scene.hpp"
#include "tests/support/export_fixture.hpp"

using namespace thaw;
using namespace thaw::test;

namespace {

std::uint64_t randomBits(std::uint64_t k) {
  return static_cast<std::uint64_t>(randomUniform(7, Purpose::Test, k) * 4294967296.0);
}

std::vector<char> unpackedBlock(std::span<const char> data) {
  std::vector<char> out;
  std::size_t at = 0;
  const auto byte = [&] { return static_cast<unsigned char>(data[at++]); };
  const auto more = [&](std::size_t n) {
    if (n == 15)
      for (unsigned b = 255; b == 255;) n += b = byte();
    return n;
  };
  while (at < data.size()) {
    const unsigned token = byte();
    for (std::size_t n = more(token >> 4); n > 0; n--) out.push_back(static_cast<char>(byte()));
    if (at == data.size()) break;
    const std::size_t low = byte(), offset = low | static_cast<std::size_t>(byte()) << 8;
    for (std::size_t n = more(token & 15) + 4; n > 0; n--) out.push_back(out.at(out.size() - offset));
  }
  return out;
}

std::vector<std::int32_t> unpackedIntegers(const std::vector<char>& packed, std::size_t count) {
  const std::vector<char> plain = unpackedBlock(std::span(packed).subspan(1));
  std::size_t at = 4 + (count + 3) / 4;
  std::int32_t common, value = 0;
  std::memcpy(&common, plain.data(), 4);
  std::vector<std::int32_t> values;
  for (std::size_t i = 0; i < count; i++) {
    const int code = static_cast<unsigned char>(plain[4 + i / 4]) >> 2 * (i % 4) & 3;
    std::int64_t step = common;
    if (code == 1) {
      const int byte = static_cast<unsigned char>(plain[at]);
      step = byte < 128 ? byte : byte - 256;
    }
    if (code == 2) {
      std::int16_t s;
      std::memcpy(&s, plain.data() + at, 2);
      step = s;
    }
    if (code == 3) {
      std::int32_t s;
      std::memcpy(&s, plain.data() + at, 4);
      step = s;
    }
    at += code == 0 ? 0 : std::size_t{1} << (code - 1);
    value = static_cast<std::int32_t>(value + step);
    values.push_back(value);
  }
  EXPECT_EQ(at, plain.size());
  return values;
}

}  // namespace

TEST(Crate, BlocksAreUnpackedToTheSameBytes) {
  for (const std::size_t size : {0, 1, 12, 13, 14, 40, 300, 5000, 200000})
    for (const int letters : {1, 3, 256}) {
      std::vector<char> data(size), packed;
      for (std::size_t i = 0; i < size; i++)
        data[i] = static_cast<char>(randomBits(i / (i % 7 + 1)) % static_cast<unsigned>(letters));
      addLz4Block(data, packed);
      EXPECT_EQ(unpackedBlock(packed), data) << size << " " << letters;
      EXPECT_LE(packed.size(), size + size / 255 + 16);
      if (letters == 1 && size > 1000) { EXPECT_LT(packed.size(), size / 100); }
    }
}

TEST(Crate, IntegersAreUnpackedToTheSameValues) {
  for (const std::size_t size : {1, 4, 17, 20000})
    for (const std::uint64_t range : {2ull, 200ull, 50000ull, 4294967296ull}) {
      std::vector<std::int32_t> values(size);
      for (std::size_t i = 0; i < size; i++)
        values[i] = static_cast<std::int32_t>(static_cast<std::uint32_t>(randomBits(i) % range));
      EXPECT_EQ(unpackedIntegers(crateIntegers(values), size), values) << size << " " << range;
    }
}

TEST_F(Export, PrimsThatComeAndGoAreHidden) {
  const fs::path file = folder / "a.usda";
  UsdSequence sequence(openUsda(file), "2 balls", 0.1);
  ExportScene scene;
  scene.style.camera.at = {0, 0, 1};
  for (int frame = 0; frame < 4; frame++) {
    scene.time = 0.1 * frame;
    scene.objects.clear();
    for (const char* name : {"surface", "surface", "late"}) {
      if (std::string(name) == "late" && (frame == 0 || frame == 3)) continue;
      ExportObject object{name, ExportKind::Sheet, {ComponentMesh{}}, {}, false};
      object.parts[0].mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, double(frame)}};
      object.parts[0].mesh.triangles = {{0, 1, 2}};
      scene.objects.push_back(object);
    }
    sequence.add(usdFrameOf(scene, sequence.file()));
  }
  sequence.finish("a \"quoted\" comment");
  const std::string text = contentOf(file);
  for (const char* part :
       {"def Xform \"_2_balls\"", "doc = \"a \\\"quoted\\\" comment\"", "timeCodesPerSecond = 10\n",
        "endTimeCode = 3\n", "def Mesh \"surface_2\"", "uniform token subdivisionScheme = \"none\"",
        "            2: [(0, 0, 0), (1, 0, 0), (0, 1, 2)],\n", "token visibility.timeSamples = {\n",
        "            0: \"invisible\",\n", "            1: \"inherited\",\n            3: \"invisible\",\n"})
    EXPECT_NE(text.find(part), std::string::npos) << part << "\n" << text;
  EXPECT_EQ(text.find("visibility"), text.rfind("visibility"));
  EXPECT_FALSE(fs::exists(file.string() + ".part"));
  EXPECT_FALSE(fs::exists(file.string() + ".values.part"));
}
