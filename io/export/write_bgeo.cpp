// SPDX-License-Identifier: Apache-2.0
#include "io/export/write_bgeo.hpp"

#include <algorithm>
#include <bit>
#include <limits>

#include "io/export/mesh_fields.hpp"
#include "io/export/out_file.hpp"
#include "io/export/polylines.hpp"
#include "io/export/texture_seams.hpp"
#include "io/hdf5/io_error.hpp"

namespace thaw {

namespace {

enum AttributeType : std::int32_t { floatType = 0, integerType = 1, vectorType = 5 };
constexpr std::uint16_t longestRun = 30000;  // most polygons in a run

/// Writes big-endian numbers.
class BigEndian {
 public:
  explicit BigEndian(const std::filesystem::path& file) : out_(file) {}
  void put(std::uint32_t v) {
    const unsigned char b[4] = {byte(v >> 24), byte(v >> 16), byte(v >> 8), byte(v)};
    out_.bytes(b, 4);
  }
  void put(std::int32_t v) { put(static_cast<std::uint32_t>(v)); }
  void put(std::uint16_t v) {
    const unsigned char b[2] = {byte(v >> 8u), byte(v)};
    out_.bytes(b, 2);
  }
  void put(float v) { put(std::bit_cast<std::uint32_t>(v)); }
  void put(const Vec3f& v) { put(v.x), put(v.y), put(v.z); }
  void put(char c) { out_.bytes(&c, 1); }
  void text(std::string_view s) { out_.text(s); }
  void attribute(std::string_view name, std::uint16_t size, AttributeType type) {
    put(static_cast<std::uint16_t>(name.size()));
    text(name);
    put(size);
    put(static_cast<std::int32_t>(type));
    for (int k = 0; k < size; k++) put(std::int32_t{0});  // defaults
  }
  void finish() { out_.finish(); }

 private:
  static unsigned char byte(std::uint32_t v) { return static_cast<unsigned char>(v & 255); }
  OutFile out_;
};

/// Attributes of a point, in the order of the file.
struct BgeoPoint {
  Vec3f position, normal, velocity, colour;
  float radius = 0;
  std::int32_t id = -1;
  float temperature = 0, liquid = 0;
  std::int32_t component = -1;

  static void declare(BigEndian& out) {
    out.attribute("N", 3, vectorType);
    out.attribute("v", 3, vectorType);
    out.attribute("Cd", 3, floatType);
    out.attribute("pscale", 1, floatType);
    out.attribute("id", 1, integerType);
    out.attribute("temperature", 1, floatType);
    out.attribute("liquid", 1, floatType);
    out.attribute("component", 1, integerType);
  }
  static constexpr std::int32_t attributes = 8;
  void write(BigEndian& out) const {
    out.put(position);
    out.put(1.0f);
    out.put(normal), out.put(velocity), out.put(colour * (1 / 255.0f));
    out.put(radius), out.put(id), out.put(temperature), out.put(liquid), out.put(component);
  }
};

std::int32_t shortId(const std::vector<std::uint64_t>& ids, std::size_t i) {
  return i < ids.size() ? static_cast<std::int32_t>(ids[i] & 0x7fffffff) : -1;
}

constexpr Vec3f plain{200, 200, 200};

bool isTextured(const ComponentMesh& mesh) {
  return !mesh.uvs.empty() && mesh.uvs.size() == mesh.mesh.vertices.size();
}

void writeVertices(const ComponentMesh& mesh, std::int32_t number, BigEndian& out) {
  for (std::size_t v = 0; v < mesh.mesh.vertices.size(); v++) {
    BgeoPoint p;
    p.position = single(mesh.mesh.vertices[v]);
    p.normal = valueAt(mesh.normals, v, {});
    p.velocity = valueAt(mesh.velocities, v, {});
    p.colour = valueAt(mesh.colours, v, plain);
    p.id = shortId(mesh.ids, v);
    p.temperature = valueAt(mesh.temperatures, v, 0.0f);
    p.liquid = valueAt(mesh.liquid, v, 0.0f);
    p.component = number;
    p.write(out);
  }
}

void writeParticles(const ExportPoints& points, BigEndian& out) {
  for (std::size_t i = 0; i < points.positions.size(); i++) {
    BgeoPoint p;
    p.position = points.positions[i];
    p.velocity = valueAt(points.velocities, i, {});
    p.colour = valueAt(points.colours, i, plain);
    p.radius = 0.5f * (points.widths ? (*points.widths)[i] : points.width);
    p.id = shortId(points.ids, i);
    p.temperature = valueAt(points.temperatures, i, 0.0f);
    p.liquid = valueAt(points.liquid, i, 0.0f);
    p.write(out);
  }
}

/// Layout of polygons. wide: point numbers have 32 bits, else 16. textured: corners have the attribute uv.
struct PolygonLayout {
  bool wide = false, textured = false;
};

/// Writes polygons in runs.
class PolygonRuns {
 public:
  PolygonRuns(std::size_t polygons, const PolygonLayout& layout, BigEndian& out)
      : left_(polygons), layout_(layout), out_(out) {}
  /// Begins a polygon or, if it is open, a curve.
  void begin(std::size_t corners, bool closed) {
    if (inRun_ == 0) {
      inRun_ = std::min<std::size_t>(longestRun, left_);
      out_.put(std::int32_t{-1});  // a run
      out_.put(static_cast<std::uint16_t>(inRun_));
      out_.put(std::int32_t{1});  // polygons
    }
    inRun_--, left_--;
    out_.put(static_cast<std::int32_t>(corners));
    out_.put(closed ? '<' : ':');
  }
  void corner(std::uint32_t point, const Uv& uv) {
    if (layout_.wide) out_.put(point);
    else out_.put(static_cast<std::uint16_t>(point));
    if (layout_.textured) out_.put(Vec3f{uv[0], uv[1], 0});
  }

 private:
  std::size_t left_, inRun_ = 0;
  PolygonLayout layout_;
  BigEndian& out_;
};

/// first: number of the mesh's first point.
void writeTriangles(const ComponentMesh& mesh, std::uint32_t first, bool textured, PolygonRuns& runs) {
  std::vector<std::array<Uv, 3>> corners;
  if (textured && isTextured(mesh)) corners = cornerUvs(mesh.mesh, mesh.uvs);
  for (std::size_t k = 0; k < mesh.mesh.triangles.size(); k++) {
    const auto& t = mesh.mesh.triangles[k];
    runs.begin(3, true);
    // Houdini's front is clockwise
    for (const std::size_t c : {0u, 2u, 1u})
      runs.corner(first + t[c], corners.empty() ? Uv{0, 0} : corners[k][c]);
  }
}

/// Curves of each mesh, and the number of all triangles and curves.
struct PolygonPlan {
  std::vector<std::vector<std::vector<std::uint32_t>>> curves;
  std::size_t count = 0;
  explicit PolygonPlan(const std::vector<ComponentMesh>& meshes) {
    for (const ComponentMesh& m : meshes) {
      curves.push_back(polylinesOf(m.lines));
      count += m.mesh.triangles.size() + curves.back().size();
    }
  }
};

void writePolygons(const std::vector<ComponentMesh>& meshes, const PolygonPlan& plan,
                   const PolygonLayout& layout, BigEndian& out) {
  PolygonRuns runs(plan.count, layout, out);
  std::uint32_t first = 0;
  for (std::size_t m = 0; m < meshes.size(); m++) {
    writeTriangles(meshes[m], first, layout.textured, runs);
    for (const std::vector<std::uint32_t>& curve : plan.curves[m]) {
      runs.begin(curve.size(), false);
      for (const std::uint32_t v : curve) runs.corner(first + v, {0, 0});
    }
    first += static_cast<std::uint32_t>(meshes[m].mesh.vertices.size());
  }
}

}  // namespace

void writeBgeo(const std::filesystem::path& file, const ExportScene& scene) {
  const std::vector<ComponentMesh> meshes = placedParts(scene);
  const PolygonPlan plan(meshes);
  std::size_t points = scene.points ? scene.points->positions.size() : 0;
  for (const ComponentMesh& m : meshes) points += m.mesh.vertices.size();
  if (points > std::numeric_limits<std::int32_t>::max() ||
      plan.count > std::numeric_limits<std::int32_t>::max())
    throw IoError(file.string(), "cannot be written: bgeo allows at most 2^31 points and polygons");
  const bool textured = std::any_of(meshes.begin(), meshes.end(), isTextured);
  BigEndian out(file);
  out.text("BgeoV");
  out.put(std::int32_t{5});
  for (const std::size_t n : {points, plan.count}) out.put(static_cast<std::int32_t>(n));
  // groups of points and primitives; attributes of points, vertices, primitives and of all
  for (const std::int32_t n : {0, 0, BgeoPoint::attributes, textured ? 1 : 0, 0, 0}) out.put(n);
  BgeoPoint::declare(out);
  std::int32_t number = 0;
  for (const ComponentMesh& m : meshes) writeVertices(m, number++, out);
  if (scene.points) writeParticles(*scene.points, out);
  if (textured) out.attribute("uv", 3, floatType);  // Houdini calls corners of polygons vertices
  writePolygons(meshes, plan, {points > 0xffff, textured}, out);
  out.put('\x00');  // no extra data
  out.put('\xff');
  out.finish();
}

}  // namespace thaw
