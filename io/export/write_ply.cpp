// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <bit>
#include <cmath>
#include <limits>
#include <numbers>

#include "io/export/export_surface.hpp"
#include "io/export/mesh_fields.hpp"
#include "io/export/out_file.hpp"
#include "io/export/texture_seams.hpp"
#include "io/hdf5/io_error.hpp"

namespace thaw {

namespace {

constexpr const char* ending = std::endian::native == std::endian::little ? "binary_little_endian"
                                                                          : "binary_big_endian";

void place(OutFile& out, const Vec3d& x) {
  for (int a = 0; a < 3; a++) out.number(static_cast<float>(x[a]));
}

std::uint8_t byteOf(float c) {
  return static_cast<std::uint8_t>(std::lround(std::fmin(255.0f, std::fmax(0.0f, c))));
}

void checkCount(const std::filesystem::path& file, std::uint64_t vertices) {
  if (vertices > static_cast<std::uint64_t>(std::numeric_limits<std::int32_t>::max()))
    throw IoError(file.string(), "cannot be written: PLY allows at most 2^31 vertices, and it has more");
}

constexpr const char* vertexProperties =
    "property float x\nproperty float y\nproperty float z\nproperty float nx\nproperty float ny\nproperty "
    "float nz\n"
    "property uchar red\nproperty uchar green\nproperty uchar blue\n";

/// Fields of the vertices of meshes in one file, as properties.
struct VertexProperties {
  MeshFields has;
  bool ids = false;
  explicit VertexProperties(const std::vector<ComponentMesh>& meshes) : has(meshes) {
    for (const ComponentMesh& m : meshes) ids = ids || !m.ids.empty();
  }
  std::string header() const {
    return std::string(has.velocities ? "property float velocity_x\nproperty float velocity_y\nproperty "
                                        "float velocity_z\n"
                                      : "") +
           (has.temperatures ? "property float temperature\n" : "") +
           (has.liquid ? "property float liquid\n" : "") +
           (has.uvs ? "property float s\nproperty float t\n" : "") + "property int object\n" +
           (ids ? "property uint id_high\nproperty uint id_low\n" : "");
  }
  void write(const ComponentMesh& m, std::size_t v, std::int32_t object, OutFile& out) const {
    constexpr std::uint64_t noId = std::numeric_limits<std::uint64_t>::max();
    if (has.velocities) out.number(valueAt(m.velocities, v, noVector));
    if (has.temperatures) out.number(valueAt(m.temperatures, v, noNumber));
    if (has.liquid) out.number(valueAt(m.liquid, v, noNumber));
    if (has.uvs) out.number(valueAt(m.uvs, v, noUv));
    out.number(object);
    if (!ids) return;
    const std::uint64_t id = valueAt(m.ids, v, noId);
    out.number(static_cast<std::uint32_t>(id >> 32));
    out.number(static_cast<std::uint32_t>(id));
  }
};

}  // namespace

std::string cutNote(const ComponentMesh& mesh) {
  std::string axes;
  for (std::size_t a = 0; a < 3; a++)
    if (mesh.cut[a]) axes += (axes.empty() ? "" : ", ") + std::string(1, static_cast<char>('x' + a));
  return axes.empty()
             ? ""
             : ", which extends through the periodic sides along " + axes + ", is cut there and capped";
}

void writePlyDiscs(const std::filesystem::path& file, const SurfaceFrame& frame,
                   const std::vector<Rgb>& colours, double discs, int corners) {
  const std::uint64_t n = frame.positions.size();
  checkCount(file, n * static_cast<std::uint64_t>(corners));
  OutFile out(file);
  out.text(fmt::format(
      "ply\nformat {} 1.0\ncomment surfels of thaw, t = {} s, m\nelement vertex {}\n{}element face {}\n"
      "property list uchar int vertex_indices\nproperty uchar red\nproperty uchar green\nproperty uchar "
      "blue\nend_header\n",
      ending, frame.time, n * static_cast<std::uint64_t>(corners), vertexProperties, n));
  for (std::size_t i = 0; i < n; i++) {
    const Vec3f& m = frame.normals[i];
    const Vec3d normal{m.x, m.y, m.z};
    const Vec3d u = normalized(cross(normal, std::abs(normal.z) < 0.9 ? Vec3d{0, 0, 1} : Vec3d{1, 0, 0})),
                v = cross(normal, u);
    for (int k = 0; k < corners; k++) {
      const double angle = 2 * std::numbers::pi * k / corners, r = discs * frame.radii[i];
      place(out, frame.positions[i] + r * (std::cos(angle) * u + std::sin(angle) * v));
      out.number(m);
      out.number(colours[i]);
    }
  }
  for (std::size_t i = 0; i < n; i++) {
    out.number(static_cast<std::uint8_t>(corners));
    for (int k = 0; k < corners; k++)
      out.number(static_cast<std::int32_t>(i * static_cast<std::size_t>(corners)) + k);
    out.number(colours[i]);
  }
  out.finish();
}

void writeMeshPly(const std::filesystem::path& file, const std::vector<ComponentMesh>& meshes) {
  std::uint64_t vertices = 0, faces = 0, edges = 0;
  for (const ComponentMesh& m : meshes)
    vertices += m.mesh.vertices.size(), faces += m.mesh.triangles.size(), edges += m.lines.size();
  checkCount(file, vertices);
  OutFile out(file);
  out.text(
      fmt::format("ply\nformat {} 1.0\ncomment surface of thaw, m; components in this order:\n", ending));
  for (const ComponentMesh& m : meshes)
    out.text(m.name.empty() ? fmt::format("comment component {}{}{}\n", m.component,
                                          m.body.empty() ? "" : " (" + m.body + ")", cutNote(m))
                            : fmt::format("comment object {}\n", m.name));
  const VertexProperties properties(meshes);
  out.text(fmt::format(
      "element vertex {}\n{}{}element face {}\nproperty list uchar int vertex_indices\nproperty int "
      "component\n{}end_header\n",
      vertices, vertexProperties, properties.header(), faces,
      edges > 0 ? fmt::format("element edge {}\nproperty int vertex1\nproperty int vertex2\n", edges) : ""));
  std::int32_t first = 0, number = 0;
  for (const ComponentMesh& m : meshes) {
    for (std::size_t v = 0; v < m.mesh.vertices.size(); v++) {
      place(out, m.mesh.vertices[v]);
      out.number(m.normals[v]);
      for (int a = 0; a < 3; a++) out.number(byteOf(m.colours[v][a]));
      properties.write(m, v, number, out);
    }
    number++;
  }
  number = 0;
  for (const ComponentMesh& m : meshes) {
    for (const auto& t : m.mesh.triangles) {
      out.number(std::uint8_t{3});
      for (const std::uint32_t v : t) out.number(first + static_cast<std::int32_t>(v));
      out.number(number);
    }
    first += static_cast<std::int32_t>(m.mesh.vertices.size());
    number++;
  }
  first = 0;
  for (const ComponentMesh& m : meshes) {
    for (const auto& l : m.lines)
      for (const std::uint32_t v : l) out.number(first + static_cast<std::int32_t>(v));
    first += static_cast<std::int32_t>(m.mesh.vertices.size());
  }
  out.finish();
}

namespace {

using Lines = fmt::memory_buffer;

std::string objectName(const ComponentMesh& m) {
  if (!m.name.empty()) return m.name;
  return m.body.empty() ? fmt::format("component_{}", m.component) : m.body;
}

/// Writes triangles with normals, and texture coordinates if there are some. firstUv: number of the first
/// `vt`, set to that of the next mesh.
void addTriangles(const ComponentMesh& m, std::uint64_t first, std::uint64_t& firstUv, Lines& lines) {
  if (m.uvs.empty()) {
    for (const auto& t : m.mesh.triangles)
      fmt::format_to(std::back_inserter(lines), "f {0}//{0} {1}//{1} {2}//{2}\n", first + t[0], first + t[1],
                     first + t[2]);
    return;
  }
  const auto vt = [&](const std::array<float, 2>& uv) {
    fmt::format_to(std::back_inserter(lines), "vt {:.6g} {:.6g}\n", uv[0], uv[1]);
  };
  for (const auto& uv : m.uvs) vt(uv);
  // A corner at a seam has coordinates of its own.
  std::uint64_t next = firstUv + m.uvs.size();
  const auto corners = cornerUvs(m.mesh, m.uvs);
  for (std::size_t k = 0; k < corners.size(); k++) {
    const auto& t = m.mesh.triangles[k];
    std::array<std::uint64_t, 3> number;
    for (std::size_t c = 0; c < 3; c++) {
      number[c] = firstUv + t[c];
      if (corners[k][c] != m.uvs[t[c]]) vt(corners[k][c]), number[c] = next++;
    }
    fmt::format_to(std::back_inserter(lines), "f {0}/{3}/{0} {1}/{4}/{1} {2}/{5}/{2}\n", first + t[0],
                   first + t[1], first + t[2], number[0], number[1], number[2]);
  }
  firstUv = next;
}

}  // namespace

void writeMeshObj(const std::filesystem::path& file, const std::vector<ComponentMesh>& meshes) {
  OutFile out(file);
  out.text("# surface of thaw, m; colours (sRGB, 0 to 1) behind the coordinates of vertices\n");
  std::uint64_t first = 1, firstUv = 1;
  Lines lines;
  for (const ComponentMesh& m : meshes) {
    lines.clear();
    if (const std::string note = cutNote(m); !note.empty())
      fmt::format_to(std::back_inserter(lines), "# component {}{}\n", m.component, note);
    fmt::format_to(std::back_inserter(lines), "o {}\n", objectName(m));
    for (std::size_t v = 0; v < m.mesh.vertices.size(); v++) {
      const Vec3d& x = m.mesh.vertices[v];
      const Vec3f &c = m.colours[v], &n = m.normals[v];
      fmt::format_to(std::back_inserter(lines),
                     "v {:.8g} {:.8g} {:.8g} {:.4g} {:.4g} {:.4g}\nvn {:.4f} {:.4f} {:.4f}\n", x.x, x.y, x.z,
                     c.x / 255, c.y / 255, c.z / 255, n.x, n.y, n.z);
    }
    addTriangles(m, first, firstUv, lines);
    for (const auto& l : m.lines)
      fmt::format_to(std::back_inserter(lines), "l {} {}\n", first + l[0], first + l[1]);
    out.bytes(lines.data(), lines.size());
    first += m.mesh.vertices.size();
  }
  out.finish();
}

}  // namespace thaw
