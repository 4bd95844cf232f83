// SPDX-License-Identifier: Apache-2.0
// Surfels sampled from meshes, and frames of them as in a run, for tests of pictures and exports.
#pragma once
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numbers>
#include <string>
#include <unordered_map>
#include <vector>

#include "core/geometry/builtin/bust.hpp"
#include "core/math/hash_random.hpp"
#include "io/frames/frame.hpp"
#include "io/frames/read_surface_frame.hpp"
#include "tests/support/meshes.hpp"

namespace thaw {

struct SurfelSamples {
  std::vector<Vec3f> positions, normals;
  std::vector<float> radii, liquid, temperature, detail;
  std::vector<std::uint8_t> colours;  // 3 per surfel
  std::vector<std::uint64_t> ids, components;
  std::size_t size() const { return positions.size(); }

  void add(const Vec3d& x, const Vec3d& n, double radius, std::uint64_t component) {
    positions.push_back({static_cast<float>(x.x), static_cast<float>(x.y), static_cast<float>(x.z)});
    normals.push_back({static_cast<float>(n.x), static_cast<float>(n.y), static_cast<float>(n.z)});
    radii.push_back(static_cast<float>(radius));
    ids.push_back(1ull << 63 | ids.size());
    components.push_back(component);
    liquid.push_back(0);
    detail.push_back(1);
    temperature.push_back(300);
    for (const std::uint8_t c : {220, 190, 150}) colours.push_back(c);
  }
  std::vector<Rgb> rgb() const {
    std::vector<Rgb> out;
    for (std::size_t i = 0; i < size(); i++)
      out.push_back({colours[3 * i], colours[3 * i + 1], colours[3 * i + 2]});
    return out;
  }
};

inline double randomShare(std::uint64_t a, std::uint64_t b) { return randomUniform(a, Purpose::Test, b); }

/// Vertex normals: means over the adjacent triangles.
inline std::vector<Vec3d> vertexNormals(const TriangleMesh& mesh) {
  std::vector<Vec3d> normals(mesh.vertices.size());
  for (const auto& t : mesh.triangles)
    for (const std::uint32_t v : t)
      normals[v] += cross(mesh.vertices[t[1]] - mesh.vertices[t[0]],
                          mesh.vertices[t[2]] - mesh.vertices[t[0]]);
  for (Vec3d& n : normals) n = normalized(n);
  return normals;
}

/// Adds surfels on a mesh by dart throwing. No two of a face are closer than 0.75 spacings, and no point is
/// farther than about the spacing from one. smooth: normals are interpolated between vertices, else those of
/// the triangles.
inline void sampleMesh(SurfelSamples& out, const TriangleMesh& mesh, double spacing, bool smooth,
                       std::uint64_t component, std::uint64_t seed = 1) {
  const std::vector<Vec3d> corners = vertexNormals(mesh);
  std::vector<double> upTo;
  double area = 0;
  for (const auto& t : mesh.triangles)
    upTo.push_back(area += 0.5 * length(cross(mesh.vertices[t[1]] - mesh.vertices[t[0]],
                                              mesh.vertices[t[2]] - mesh.vertices[t[0]])));
  const double apart = 0.75 * spacing;
  std::unordered_map<std::uint64_t, std::vector<std::size_t>> cells;
  const auto key = [&](double x, double y, double z) {
    const auto c = [&](double v) {
      return static_cast<std::uint64_t>(static_cast<std::int64_t>(std::floor(v / apart)) + (1 << 20));
    };
    return c(x) << 42 | c(y) << 21 | c(z);
  };
  const std::size_t darts = static_cast<std::size_t>(30 * area / (apart * apart)) + 30;
  for (std::size_t k = 0; k < darts; k++) {
    const double at = randomShare(seed, 3 * k) * area;
    const std::size_t t = static_cast<std::size_t>(std::upper_bound(upTo.begin(), upTo.end() - 1, at) -
                                                   upTo.begin());
    double u = randomShare(seed, 3 * k + 1), v = randomShare(seed, 3 * k + 2);
    if (u + v > 1) u = 1 - u, v = 1 - v;
    const auto& tri = mesh.triangles[t];
    const Vec3d &a = mesh.vertices[tri[0]], &b = mesh.vertices[tri[1]], &c = mesh.vertices[tri[2]];
    const Vec3d x = a + u * (b - a) + v * (c - a);
    const Vec3d n = normalized(smooth
                                   ? (1 - u - v) * corners[tri[0]] + u * corners[tri[1]] + v * corners[tri[2]]
                                   : cross(b - a, c - a));
    bool clear = true;
    for (int i = 0; i < 27 && clear; i++) {
      const auto cell = cells.find(
          key(x.x + (i % 3 - 1) * apart, x.y + (i / 3 % 3 - 1) * apart, x.z + (i / 9 - 1) * apart));
      if (cell == cells.end()) continue;
      for (const std::size_t j : cell->second) {
        const Vec3d other{out.positions[j].x, out.positions[j].y, out.positions[j].z},
            m{out.normals[j].x, out.normals[j].y, out.normals[j].z};
        if (length(other - x) < apart && dot(m, n) > 0.5) clear = false;
      }
    }
    if (!clear) continue;
    cells[key(x.x, x.y, x.z)].push_back(out.size());
    out.add(x, n, spacing, component);
  }
}

/// Adds surfels on a ball, evenly (Fibonacci spiral), about `spacing` apart.
inline void sampleBall(SurfelSamples& out, const Vec3d& centre, double radius, double spacing,
                       std::uint64_t component) {
  const int n = std::max(
      12, static_cast<int>(4 * std::numbers::pi * radius * radius / (0.87 * spacing * spacing)));
  for (int k = 0; k < n; k++) {
    const double z = 1 - 2 * (k + 0.5) / n, s = std::sqrt(1 - z * z), angle = k * 2.399963229728653;
    const Vec3d d{s * std::cos(angle), s * std::sin(angle), z};
    out.add(centre + radius * d, d, spacing, component);
  }
}

/// Starts MPI, which writes frames, if no other test has done so.
inline void startMpi() {
  int started = 0;
  MPI_Initialized(&started);
  if (!started) MPI_Init(nullptr, nullptr);
}

/// Writes a frame of a surface. `heat`: with temperatures; `scene`: text of the scene "x" that the run
/// stores.
inline void writeSurfaceFrame(const std::string& path, const SurfelSamples& s, double time, bool heat = true,
                              const std::string& scene = {}) {
  Frame frame;
  frame.time = time;
  frame.step = static_cast<std::int64_t>(1000 * time);
  frame.count = s.size();
  frame.positions = {"position", "m", Scalar::F32, 3, s.positions.data()};
  frame.fields = {{"normal", "1", Scalar::F32, 3, s.normals.data()},
                  {"radius", "m", Scalar::F32, 1, s.radii.data()},
                  {"color", "1", Scalar::U8, 3, s.colours.data()},
                  {"id", "1", Scalar::U64, 1, s.ids.data()},
                  {"component", "1", Scalar::U64, 1, s.components.data()},
                  {"liquid", "1", Scalar::F32, 1, s.liquid.data()},
                  {"detail", "1", Scalar::F32, 1, s.detail.data()}};
  if (heat) frame.fields.push_back({"temperature", "K", Scalar::F32, 1, s.temperature.data()});
  startMpi();
  writeFrame(path, MPI_COMM_SELF, frame, {"x", scene, false});
}

}  // namespace thaw
