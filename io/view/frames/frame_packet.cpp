// SPDX-License-Identifier: Apache-2.0
#include "io/view/frames/frame_packet.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "io/frames/read_oriented_frame.hpp"
#include "io/frames/read_surface_frame.hpp"
#include "io/frames/rows_by_id.hpp"
#include "io/view/frames/thin_rows.hpp"

namespace thaw {
namespace {

/// Fields that a type's look needs.
bool isNeeded(PointType type, const std::string& name) {
  const auto is = [&](std::initializer_list<const char*> names) {
    return std::any_of(names.begin(), names.end(), [&](const char* n) { return name == n; });
  };
  switch (type) {
    case PointType::Particles: return false;
    case PointType::Surface: return is({"normal", "radius", "color"});
    case PointType::Sheet: return is({"color"});
    case PointType::Oriented:
      return is({"orientation", "radius", "group", "oriented_body", "cut_sides", "flags", "color"});
  }
  return false;
}

/// Adds the colours of a frame, sRGB, with a fourth byte for the alignment. Adds none if it has no such
/// field.
void addColours(Packet& packet, const FrameData& frame) {
  const FrameColumn* column = frame.find("color");
  if (!column || column->components != 3) return;
  std::vector<std::uint8_t> v;
  v.reserve(4 * frame.positions.size());
  for (std::size_t i = 0; i < frame.positions.size(); i++) {
    for (int c = 0; c < 3; c++)
      v.push_back(static_cast<std::uint8_t>(std::clamp(column->value(i, c), 0.0, 255.0)));
    v.push_back(255);
  }
  packet.add("colour", std::span<const std::uint8_t>(v), 4);
}

/// Adds the field of the colours with the range of its finite values.
void addField(Packet& packet, const FrameData& frame, const FieldChoice& field) {
  const FrameColumn* column = frame.find(field.name);
  if (field.name.empty() || !column) return;
  packet.header["field"] = {{"name", field.name}, {"part", field.part}, {"unit", column->unit}};
  if (isLabel(column->name, column->element)) {
    packet.add("label", std::span<const std::uint32_t>(labelsOf(*column, frame.positions.size())), 1);
    return;
  }
  const std::vector<float> values = valuesOf(*column, frame.positions.size(), field);
  float low = std::numeric_limits<float>::max(), high = std::numeric_limits<float>::lowest();
  for (const float v : values)
    if (std::isfinite(v)) low = std::min(low, v), high = std::max(high, v);
  if (low <= high) packet.header["field"]["min"] = low, packet.header["field"]["max"] = high;
  packet.add("value", std::span<const float>(values), 1);
}

/// Vertices of sheets: the area-weighted mean normals of the triangles around them, and the mean length of
/// these triangles' edges (m). (0, 0, 1) and 0 without triangles.
struct VertexShape {
  std::vector<Vec3f> normals;
  std::vector<float> radii;
};
VertexShape vertexShape(const FrameData& frame, const std::vector<std::uint32_t>& rows) {
  const std::size_t n = frame.positions.size();
  std::vector<Vec3d> areas(n);
  std::vector<double> lengths(n), edges(n);
  for (const auto& t : frame.triangles) {
    const Vec3d &a = frame.positions[t[0]], &b = frame.positions[t[1]], &c = frame.positions[t[2]];
    const Vec3d area = cross(b - a, c - a);
    const double around = (length(b - a) + length(c - b) + length(a - c)) / 3;
    for (const std::uint32_t v : t) areas[v] += area, lengths[v] += around, edges[v] += 1;
  }
  VertexShape shape;
  for (const std::uint32_t i : rows) {
    const double size = length(areas[i]);
    const Vec3d normal = size > 0 ? areas[i] / size : Vec3d{0, 0, 1};
    shape.normals.push_back(
        {static_cast<float>(normal.x), static_cast<float>(normal.y), static_cast<float>(normal.z)});
    shape.radii.push_back(edges[i] > 0 ? static_cast<float>(lengths[i] / edges[i]) : 0);
  }
  return shape;
}

void addSurfels(Packet& packet, const FrameData& frame) {
  const FrameColumn *normal = frame.find("normal"), *radius = frame.find("radius");
  std::vector<Vec3f> normals;
  std::vector<float> radii;
  for (std::size_t i = 0; i < frame.positions.size(); i++) {
    const auto part = [&](int c) { return static_cast<float>(normal->value(i, c)); };
    normals.push_back({part(0), part(1), part(2)});
    radii.push_back(static_cast<float>(radius->value(i)));
  }
  packet.addNormals(normals);
  packet.add("radius", std::span<const float>(radii), 1);
  addColours(packet, frame);
}

/// Returns whether particles can be triangulated. Damaged rows could take forever.
bool isSound(const OrientedFrame& frame) {
  double least = std::numeric_limits<double>::max(), most = 0, far = 0;
  for (std::size_t i = 0; i < frame.positions.size(); i++) {
    if (!std::isfinite(frame.spacings[i]) || !std::isfinite(dot(frame.normals[i], frame.tangents[i])))
      return false;
    least = std::min(least, frame.spacings[i]);
    most = std::max(most, frame.spacings[i]);
    far = std::max(far, length(frame.positions[i] - frame.positions[0]));
  }
  return least > 0 && most < 1e3 * least && far < 1e6 * least;
}

/// Adds discs, and at level 0 the triangles and lines between them.
void addOriented(Packet& packet, const FrameData& data, const std::string& path, double level) {
  const OrientedFrame frame = orientedFrameOf(data, path);
  std::vector<Vec3f> normals;
  for (const Vec3d& n : frame.normals) normals.push_back(single(n));
  packet.addNormals(normals);
  packet.add("radius",
             std::span<const float>(std::vector<float>(frame.spacings.begin(), frame.spacings.end())), 1);
  std::vector<std::uint8_t> colours;
  for (const auto& c : frame.colours) colours.insert(colours.end(), {c[0], c[1], c[2], 255});
  packet.add("colour", std::span<const std::uint8_t>(colours), 4);
  if (level > 0 || !isSound(frame)) return;
  const auto triangles = triangulate(frame.points());
  packet.addTriangles(triangles);
  std::vector<std::uint8_t> alone(frame.positions.size(), 1);
  std::vector<std::uint32_t> meshed;
  for (const auto& t : triangles) meshed.push_back(frame.groups[t[0]]);
  std::sort(meshed.begin(), meshed.end());
  for (std::size_t i = 0; i < alone.size(); i++)
    alone[i] = !std::binary_search(meshed.begin(), meshed.end(), frame.groups[i]);
  std::vector<std::uint32_t> lines;
  for (const auto& l : joinLines(frame.points(), alone)) lines.insert(lines.end(), l.begin(), l.end());
  packet.add("lines", std::span<const std::uint32_t>(lines), 2);
}

void requireFields(const FrameData& frame, PointType type, const std::string& path) {
  const auto has = [&](const char* name, int components) {
    const FrameColumn* column = frame.find(name);
    return column && column->components == components;
  };
  if (type == PointType::Surface && !(has("normal", 3) && has("radius", 1)))
    throw IoError(path, "is not a frame of a surface: it has no fields normal and radius");
  if (type == PointType::Oriented &&
      !(has("orientation", 4) && has("cut_sides", 1) && frame.find("cut_sides")->element == Element::U64))
    throw IoError(path, "is not a frame of oriented particles: it has no fields orientation and cut_sides");
}

}  // namespace

ThinnedFrame readThinned(const FrameRequest& q, const std::function<bool(const std::string&)>& wanted) {
  H5File::openToRead(q.path, Trailer::MustBe).close();
  ThinnedFrame read;
  read.frame = readFrame(q.path, [&](const std::string& name) { return name == "id" || wanted(name); });
  keepRows(read.frame, rowsAt(0, read.frame.positions, {}));
  // Triangles cannot be thinned, and sheets are rarely large.
  read.level = thinningLevel(read.frame.positions.size(), q.type == PointType::Sheet ? 4 * q.most : q.most);
  read.rows = rowsAt(read.level, read.frame.positions, idsOf(read.frame));
  return read;
}

Packet framePacket(const FrameRequest& q) {
  ThinnedFrame read = readThinned(
      q, [&](const std::string& name) { return isNeeded(q.type, name) || name == q.field.name; });
  FrameData& frame = read.frame;
  requireFields(frame, q.type, q.path);
  const FrameInfo info = readFrameInfo(q.path);
  Packet packet;
  packet.header = {{"type", pointTypeNames[static_cast<std::size_t>(q.type)]},
                   {"time", frame.time},
                   {"step", frame.step},
                   {"count", info.count},
                   {"finite", frame.positions.size()},
                   {"level", read.level},
                   {"fields", describeFields(info)}};
  const VertexShape shape = q.type == PointType::Sheet ? vertexShape(frame, read.rows) : VertexShape{};
  keepRows(frame, read.rows);
  packet.addPositions(frame.positions);
  if (q.type == PointType::Surface) addSurfels(packet, frame);
  if (q.type == PointType::Oriented) addOriented(packet, frame, q.path, read.level);
  if (q.type == PointType::Sheet) {
    packet.addNormals(shape.normals);
    packet.add("radius", std::span<const float>(shape.radii), 1);
    addColours(packet, frame);
    if (read.level == 0) packet.addTriangles(frame.triangles);
  }
  addField(packet, frame, q.field);
  return packet;
}

}  // namespace thaw
