// SPDX-License-Identifier: Apache-2.0
#include "io/meshes/read_mesh.hpp"

#include <gtest/gtest.h>

#include <clocale>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <limits>

#include <unistd.h>

#include "core/geometry/meshes/mesh_repair.hpp"
#include "tests/support/meshes.hpp"

namespace thaw {
namespace {

const char* const tetObj =
    "# a tetrahedron\nv 0 0 0\nv 1.0 0 0\r\nv 0 1e0 0\nv +0 0 1 0.5 0.5 0.5\nvt 0 0\nvn 0 0 1\n";
const std::string goodObj = std::string(tetObj) +
                            "f 1 3 2\nf 1/1 2/1 4/1\nf 2//1 3//1 4//1\nf -1/1/1 -2/1/1 -4/1/1\n";

std::string bytes(const void* data, std::size_t n, bool swap = false) {
  std::string s(static_cast<const char*>(data), n);
  if (swap) s = std::string(s.rbegin(), s.rend());
  return s;
}
template<class T> std::string raw(T x, bool swap = false) { return bytes(&x, sizeof x, swap); }

std::string binaryStl(const TriangleMesh& m, const char* header = "made by a test") {
  std::string s(80, '\0');
  std::memcpy(s.data(), header, std::strlen(header));
  s += raw(static_cast<std::uint32_t>(m.triangles.size()));
  for (const auto& t : m.triangles) {
    s += std::string(12, '\0');
    for (const std::uint32_t v : t)
      for (int a = 0; a < 3; a++) s += raw(static_cast<float>(m.vertices[v][a]));
    s += std::string(2, '\0');
  }
  return s;
}

std::string asciiStl(const TriangleMesh& m) {
  std::string s = "solid a box with a name\n";
  for (const auto& t : m.triangles) {
    s += "  facet normal 0 0 nan\n    outer loop\n";
    for (const std::uint32_t v : t)
      s += "      vertex " + std::to_string(m.vertices[v].x) + " " + std::to_string(m.vertices[v].y) + " " +
           std::to_string(m.vertices[v].z) + "\n";
    s += "    endloop\n  endfacet\n";
  }
  return s + "endsolid a box with a name\n";
}

/// A box of quads with extra properties and elements.
std::string ply(bool ascii, bool big, bool normals = false) {
  const std::string format = ascii ? "ascii" : big ? "binary_big_endian" : "binary_little_endian";
  std::string s = "ply\nformat " + format +
                  " 1.0\ncomment a box\nobj_info x\nelement vertex 8\nproperty double x\nproperty uchar "
                  "red\nproperty float y\nproperty float z\n" +
                  std::string(normals ? "property float nx\nproperty double ny\nproperty float nz\n" : "") +
                  "element extra 2\nproperty list uchar short numbers\nproperty int n\nelement face "
                  "6\nproperty float quality\nproperty list uchar int vertex_indices\nend_header\n";
  const int quads[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                           {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  for (int c = 0; c < 8; c++) {
    const double n[3] = {c & 1 ? 2.0 : -2.0, c & 2 ? 2.0 : -2.0, c & 4 ? 2.0 : -2.0};  // not normalised
    if (ascii)
      s += std::to_string(c & 1) + " 255 " + std::to_string(c >> 1 & 1) + ".0 " + std::to_string(c >> 2) +
           "e0" +
           (normals ? " " + std::to_string(n[0]) + " " + std::to_string(n[1]) + " " + std::to_string(n[2])
                    : "") +
           "\n";
    else
      s += raw<double>(c & 1, big) + '\xff' + raw<float>(static_cast<float>(c >> 1 & 1), big) +
           raw<float>(static_cast<float>(c >> 2), big) +
           (normals ? raw<float>(static_cast<float>(n[0]), big) + raw<double>(n[1], big) +
                          raw<float>(static_cast<float>(n[2]), big)
                    : "");
  }
  for (int e = 0; e < 2; e++)
    s += ascii ? std::string("2 7 8 9\n")
               : std::string(1, '\2') + raw<short>(7, big) + raw<short>(8, big) + raw<int>(9, big);
  for (const auto& q : quads) {
    s += ascii ? std::string("0.5 4") : raw<float>(0.5f, big) + '\4';
    for (const int v : q) {
      if (ascii) s += ' ';
      s += ascii ? std::to_string(v) : raw<int>(v, big);
    }
    if (ascii) s += "\n";
  }
  return s;
}

double volume(const TriangleMesh& m) {
  MeshReport r;
  repairMesh(m, r);
  EXPECT_EQ(r.holes + r.turnedTriangles + r.turnedShells, 0);
  return r.volume;
}

std::string message(const std::string& content, const std::string& file = "m.obj") {
  try {
    parseMesh(content, file);
  } catch (const MeshError& e) { return e.what(); }
  return "none";
}

#define EXPECT_SAYS(text, part) EXPECT_NE((text).find(part), std::string::npos) << (text)

TEST(ReadMesh, ReadsObj) {
  const TriangleMesh m = parseMesh(goodObj, "m.obj");
  EXPECT_EQ(m.vertices.size(), 4u);
  EXPECT_EQ(m.triangles.size(), 4u);
  EXPECT_NEAR(volume(m), 1.0 / 6, 1e-15);
  // byte order mark
  EXPECT_NEAR(volume(parseMesh(std::string("\xef\xbb\xbf") + goodObj, "m")), 1.0 / 6, 1e-15);
  const TriangleMesh fan = parseMesh("f 1 2 3 4 \\\n 5 # five\nv 0 0 0\nv 1 0 0\nv 2 1 0\nv 1 2 0\nv 0 1 0",
                                     "m.obj");
  ASSERT_EQ(fan.triangles.size(), 3u);
  EXPECT_EQ(fan.triangles[2], (std::array<std::uint32_t, 3>{0, 3, 4}));
}

TEST(ReadMesh, ReadsAllPlyFormats) {
  for (const auto& [ascii, big] : {std::pair{true, false}, {false, false}, {false, true}}) {
    const TriangleMesh m = parseMesh(ply(ascii, big), "m.ply");
    EXPECT_EQ(m.vertices.size(), 8u);
    EXPECT_EQ(m.triangles.size(), 12u);
    EXPECT_EQ(volume(m), 1);
  }
}

TEST(ReadMesh, ReadsNormalsOfAllPlyFormats) {
  for (const auto& [ascii, big] : {std::pair{true, false}, {false, false}, {false, true}}) {
    const TriangleMesh m = parseMesh(ply(ascii, big, true), "m.ply");
    ASSERT_EQ(m.normals.size(), 12u);
    for (std::size_t t = 0; t < 12; t++)
      for (std::size_t k = 0; k < 3; k++) {
        const Vec3d x = m.vertices[m.triangles[t][k]], n = m.normals[t][k];
        EXPECT_NEAR(length(n - normalized(x - Vec3d{0.5, 0.5, 0.5})), 0, 1e-15);
      }
    EXPECT_EQ(volume(m), 1);
    EXPECT_TRUE(parseMesh(ply(ascii, big), "m.ply").normals.empty());
  }
}

TEST(ReadMesh, ReadsNormalsOfObjPerCorner) {
  const std::string points = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n";
  const TriangleMesh m = parseMesh(
      points +
          "vn 0 0 -3\nvn 1e200 1e200 1e200\nf 1//1 3//1 2//1\nf 1 2 4\nf 2/7/-1 3//-1 4\nf 1//1 4//2 3//-2\n",
      "m.obj");
  ASSERT_EQ(m.normals.size(), 4u);
  EXPECT_EQ(m.normals[0][2], (Vec3d{0, 0, -1}));
  EXPECT_EQ(m.normals[1][0], Vec3d{});  // a zero normal is undefined
  EXPECT_NEAR(length(m.normals[2][0] - normalized(Vec3d{1, 1, 1})), 0, 1e-15);
  EXPECT_EQ(m.normals[2][2], Vec3d{});
  EXPECT_EQ(m.normals[3][2], (Vec3d{0, 0, -1}));
  EXPECT_TRUE(parseMesh(points + "vn 0 0 1\nf 1 2 3\n", "m.obj").normals.empty());
  EXPECT_SAYS(message(points + "vn 0 0\n"), "m.obj:5: expected a part of a normal (vn x y z), got the end");
  EXPECT_SAYS(message(points + "vn 0 0 nan\n"),
              "m.obj:5: expected a part of a normal (vn x y z), got 'nan', which is not a finite number");
  EXPECT_SAYS(message(points + "vn 0 0 1\nf 1//2 2//1 3//1\n"),
              "m.obj:6: normal index 2, but the file has 1 normals");
  EXPECT_SAYS(message(points + "f 1//-1 2//1 3//1\n"),
              "m.obj:5: normal index -1, but only 0 normals came before");
  EXPECT_SAYS(message(points + "f 1//x 2 3\n"), "m.obj:5: expected a normal index");
}

TEST(ReadMesh, RefusesNonFiniteNormalsOfPly) {
  const std::string head =
      " 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\nproperty float "
      "nx\nproperty float ny\nproperty float nz\n"
      "element face 1\nproperty list uchar int vertex_index\nend_header\n";
  EXPECT_SAYS(message("ply\nformat ascii" + head + "0 0 0 0 0 1\n1 0 0 0 inf 1\n0 1 0 0 0 1\n3 0 1 2\n"),
              "m.obj:14: expected a part of a normal, got 'inf', which is not a finite number");
  std::string binary = "ply\nformat binary_little_endian" + head;
  const std::size_t begin = binary.size();
  for (int k = 0; k < 18; k++)
    binary += raw<float>(k == 10 ? std::numeric_limits<float>::quiet_NaN()
                                 : static_cast<float>(k == 6 || k == 13));
  binary += '\3' + raw<int>(0) + raw<int>(1) + raw<int>(2);
  EXPECT_SAYS(message(binary), "m.obj: byte " + std::to_string(begin + 40) +
                                   ": expected a part of a normal, got a number that is not finite");
}

TEST(ReadMesh, ReadsBothStlFormats) {
  const TriangleMesh box = boxMesh({0, 0, 0}, {1, 2, 3});
  for (const std::string& s : {binaryStl(box), binaryStl(box, "solid is what many binary ones say"),
                               asciiStl(box), asciiStl(box) + asciiStl(box)}) {
    const TriangleMesh m = parseMesh(s, "m.stl");
    EXPECT_EQ(m.vertices.size(), 8u);
    EXPECT_EQ(m.triangles.size(), 12u);
    EXPECT_EQ(volume(m), 6);
    EXPECT_EQ(parseMesh(s, "without an ending").triangles.size(), 12u);
  }
}

TEST(ReadMesh, IgnoresTheLocale) {
  for (const char* name : {"de_DE.UTF-8", "de_DE.utf8", "fr_FR.UTF-8"})
    if (std::setlocale(LC_ALL, name)) break;
  EXPECT_EQ(parseMesh("v 0 0 0\nv 1.5 0 0\nv 0 1 0\nf 1 2 3", "m.obj").vertices[1].x, 1.5);
  std::setlocale(LC_ALL, "C");
}

TEST(ReadMesh, RefusesBrokenObj) {
  EXPECT_SAYS(message(""), "m.obj: the file is empty");
  EXPECT_SAYS(message("hello world\n"), "no vertices");
  EXPECT_SAYS(message("v 0 0 0\nv 1 0 0\n"), "no faces");
  EXPECT_SAYS(message("v 0 0 0\nv 1 0\n"), "m.obj:2: expected a coordinate");
  EXPECT_SAYS(message("v 0 0 0\nv 1 0 x7\n"), "m.obj:2: expected a coordinate (v x y z), got 'x7'");
  EXPECT_SAYS(message("v 0 0 nan\n"), "m.obj:1: ");
  EXPECT_SAYS(message("v 0 0 inf\n"), "not a finite number");
  EXPECT_SAYS(message("v 0 0 1e999\n"), "too large");
  EXPECT_EQ(parseMesh("v 0 0 1e-999\nf 1 1 1", "m").vertices[0].z, 0);
  EXPECT_SAYS(message("v 1,5 0 0\n"), "m.obj:1: ");
  EXPECT_SAYS(message(std::string(tetObj) + "f 1 2 5\n"), "m.obj:8: vertex index 5, but the file has 4");
  EXPECT_SAYS(message(std::string(tetObj) + "f 1 2 0\n"), "m.obj:8: vertex index 0");
  EXPECT_SAYS(message(std::string(tetObj) + "f 1 2 -5\n"), "m.obj:8: vertex index -5");
  EXPECT_SAYS(message(std::string(tetObj) + "f 1 2\n"), "m.obj:8: a face with 2 corners");
  EXPECT_SAYS(message(std::string(tetObj) + "f 1 2 99999999999999999999\n"), "m.obj:8: ");
  EXPECT_SAYS(message(std::string(tetObj) + "f 1 2 4294967297\n"), "m.obj:8: ");
  EXPECT_SAYS(message(std::string("v 0 0 0\n\0\1\2", 11)), "neither");
}

TEST(ReadMesh, RefusesBrokenPly) {
  EXPECT_SAYS(message("ply\n"), "end_header");
  EXPECT_SAYS(message("ply\nformat ascii 1.0\nelement vertex"), "m.obj:3: ");
  EXPECT_SAYS(message("ply\nformat weird 1.0\nend_header\n"), "m.obj:2: expected the format");
  EXPECT_SAYS(message("ply\nelement vertex 1\nproperty float x\nend_header\n0"), "no line 'format'");
  EXPECT_SAYS(message("ply\nformat ascii 1.0\nproperty float x\n"), "m.obj:3: expected an element before");
  EXPECT_SAYS(message("ply\nformat ascii 1.0\nelement vertex -3\n"), "m.obj:3: ");
  EXPECT_SAYS(message("ply\nformat ascii 1.0\nelement vertex 99999999999999999999\n"), "m.obj:3: ");
  EXPECT_SAYS(message("ply\nformat ascii 1.0\nelement vertex 3\nproperty list float int x\n"), "integer");
  EXPECT_SAYS(message("ply\nformat ascii 1.0\nend_header\n"), "no vertex elements");
  const std::string head = "element vertex 3\nproperty float x\nproperty float y\nproperty float z\n",
                    face = "element face 1\nproperty list uchar int vertex_index\nend_header\n";
  const std::string good = "ply\nformat ascii 1.0\n" + head + face + "0 0 0\n1 0 0\n0 1 0\n";
  EXPECT_EQ(parseMesh(good + "3 0 1 2\n", "m").triangles.size(), 1u);
  EXPECT_SAYS(message(good + "3 0 1 3\n"), "m.obj:13: expected a vertex index below 3");
  EXPECT_SAYS(message(good + "3 0 1 -1\n"), "below 3");
  EXPECT_SAYS(message(good + "3 0 1 0.5\n"), "below 3");
  EXPECT_SAYS(message(good + "3 0 1\n"), "got the end");
  EXPECT_SAYS(message(good + "2 0 1\n"), "2 corners");
  EXPECT_SAYS(message(good + "200000 0 1\n"), "does not fit into the rest of the file");
  EXPECT_SAYS(message(good), "");
  EXPECT_SAYS(message("ply\nformat ascii 1.0\n" + head + face + "0 0 nan\n1 0 0\n0 1 0\n3 0 1 2\n"),
              "m.obj:10: ");
  EXPECT_SAYS(message("ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n" + face +
                      "0 0\n"),
              "x, y and z");
  EXPECT_SAYS(message("ply\nformat ascii 1.0\n" + head +
                      "element face 1\nproperty int a\nend_header\n0 0 0 1 0 0 0 1 0 5"),
              "vertex_indices");
  // huge counts in a tiny file, also of elements without a property
  for (const char* format : {"ascii", "binary_little_endian", "binary_big_endian"}) {
    const std::string begin = std::string("ply\nformat ") + format + " 1.0\n";
    EXPECT_SAYS(
        message(begin + "element vertex 4000000000\nproperty float x\nproperty float y\nproperty float z\n" +
                face + "0 0 0\n"),
        "do not fit into the file");
    EXPECT_NE(
        message(begin +
                "element vertex 9000000000000000000\nproperty float x\nproperty float y\nproperty float z\n" +
                face + "0 0 0\n"),
        "none");
    EXPECT_NE(message(begin + "element nothing 9000000000000000000\n" + head + face + "0 0 0\n"), "none");
    EXPECT_NE(message(begin + "element some 9000000000000000000\nproperty int n\n" + head + face + "0 0 0\n"),
              "none");
    EXPECT_NE(message(begin + head +
                      "element face 9000000000000000000\nproperty list uint int vertex_index\nend_header\n" +
                      std::string(36, '\0') + "\xff\xff\xff\xff 0 1 2"),
              "none");
  }
  EXPECT_SAYS(message("nothing", "m.ply"), "m.ply:1: expected the line 'ply'");
}

TEST(ReadMesh, RefusesBrokenStl) {
  const TriangleMesh box = boxMesh({0, 0, 0}, {1, 2, 3});
  std::string s = binaryStl(box);
  EXPECT_SAYS(message(s.substr(0, s.size() - 1), "m.stl"), "the file has 683");
  EXPECT_SAYS(message(s + "x", "m.stl"), "say");
  EXPECT_SAYS(message(s.substr(0, 50), "m.stl"), "84 bytes");
  std::string huge = s;
  huge.replace(80, 4, "\xff\xff\xff\xff");
  EXPECT_SAYS(message(huge, "m.stl"), "4294967295 triangles");
  std::string none = s.substr(0, 84);
  none.replace(80, 4, std::string(4, '\0'));
  EXPECT_SAYS(message(none, "m.stl"), "no triangles");
  s.replace(84 + 12, 4, raw(std::numeric_limits<float>::quiet_NaN()));
  EXPECT_SAYS(message(s, "m.stl"), "byte 96: expected a coordinate");
  const std::string text = asciiStl(box);
  EXPECT_SAYS(message("solid x\nendsolid\n", "m.stl"), "no facets");
  EXPECT_SAYS(message("solid x\nfacet normal 0 0 1\nouter loop\nvertex 0 0 oops\n", "m.stl"),
              "m.stl:4: expected a coordinate");
  EXPECT_SAYS(message("solid x\nfacet normal 0 0 1\nouter loop\nvertex 0 0 nan\n", "m.stl"), "m.stl:4: ");
  EXPECT_SAYS(message("solid x\nfacet normal 0 0 1\ninner loop\n", "m.stl"),
              "m.stl:3: expected 'outer', got 'inner'");
  EXPECT_SAYS(message("solid x\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 0 0 0\nvertex 0 0 "
                      "0\nendloop\nendfacet\nendsolid",
                      "m.stl"),
              "equal corners");
}

/// Truncated files and files with one changed byte give a mesh or a message, never a crash.
TEST(ReadMesh, DamagedFilesNeverCrash) {
  const TriangleMesh box = boxMesh({0, 0, 0}, {1, 2, 3});
  for (const std::string& s :
       {goodObj, ply(true, false), ply(false, false), ply(false, true), ply(true, false, true),
        ply(false, true, true), binaryStl(box), asciiStl(box)}) {
    for (std::size_t n = 0; n < s.size(); n++)
      for (const char* file : {"m.obj", "m.stl", "m.ply"}) {
        const std::string said = message(s.substr(0, n), file);
        // faces of an OBJ file may be missing, and so may the name at the end of an STL file
        if (n + 25 < s.size() && said == "none") { EXPECT_TRUE(s == goodObj) << n; }
      }
    for (std::uint64_t k = 0; k < 4000; k++) {
      std::string damaged = s;
      for (std::uint64_t c = 0; c <= k % 3; c++)
        damaged[randomBits(1, Purpose::Test, k, 2 * c) % s.size()] = static_cast<char>(
            randomBits(1, Purpose::Test, k, 2 * c + 1));
      message(damaged, "m.stl");
    }
  }
  for (std::uint64_t k = 0; k < 500; k++) {
    std::string garbage = k % 2 ? "ply\n" : "";
    for (std::uint64_t c = 0; c < 300; c++) garbage += static_cast<char>(randomBits(2, Purpose::Test, k, c));
    EXPECT_NE(message(garbage, k % 3 ? "m.stl" : "m"), "none");
  }
}

TEST(ReadMesh, ReadsFilesAndNamesErrors) {
  EXPECT_THROW(readMesh("/there/is/no/such/file.obj"), MeshError);
  EXPECT_THROW(readMesh("/tmp"), MeshError);
  EXPECT_THROW(readMesh("/dev/zero"), MeshError);
  const auto path = std::filesystem::temp_directory_path() /
                    ("thaw_mesh_test_" + std::to_string(::getpid()) + ".obj");
  std::ofstream(path) << goodObj;
  EXPECT_EQ(readMesh(path.string()).triangles.size(), 4u);
  std::filesystem::remove(path);
}

}  // namespace
}  // namespace thaw
