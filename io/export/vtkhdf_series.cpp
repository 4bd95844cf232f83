// SPDX-License-Identifier: Apache-2.0
#include "io/export/vtkhdf_series.hpp"

#include <algorithm>
#include <cmath>

#include "io/export/colour_byte.hpp"
#include "io/export/mesh_fields.hpp"

namespace thaw {

namespace {

constexpr std::uint8_t vertexCell = 1, lineCell = 3, triangleCell = 5;  // vtkCellType.h
constexpr std::uint64_t pointsOfChunk = 16384;

/// Appends a field of an object with `points` points, or `lacking` for each if it has none. before: points of
/// the objects before it.
template<class T>
void append(std::optional<std::vector<T>>& all, const std::vector<T>& field, std::size_t points,
            const T& lacking, std::size_t before) {
  const bool has = field.size() == points && points > 0;
  if (has && !all) all.emplace(before, lacking);
  if (!all) return;
  if (has) all->insert(all->end(), field.begin(), field.end());
  else all->resize(before + points, lacking);
}

/// Adds all but the lines, which follow the triangles of all meshes.
void addMesh(VtkHdfFrame& f, const ComponentMesh& m, std::int32_t number) {
  const std::size_t n = m.mesh.vertices.size();
  const auto first = static_cast<std::int64_t>(f.points.size());
  for (const Vec3d& x : m.mesh.vertices) f.points.push_back(single(x));
  for (const auto& t : m.mesh.triangles)
    for (const std::uint32_t v : t) f.connectivity.push_back(first + v);
  f.triangles += static_cast<std::int64_t>(m.mesh.triangles.size());
  for (std::size_t v = 0; v < n; v++)
    for (int c = 0; c < 3; c++) f.colours.push_back(v < m.colours.size() ? colourByte(m.colours[v][c]) : 200);
  const std::size_t before = f.points.size() - n;
  append(f.normals, m.normals, n, noVector, before);
  append(f.velocities, m.velocities, n, noVector, before);
  append(f.temperatures, m.temperatures, n, noNumber, before);
  append(f.liquid, m.liquid, n, noNumber, before);
  append(f.uvs, m.uvs, n, noUv, before);
  f.objects.resize(f.points.size(), number);
  f.labels.resize(f.points.size(), labelOf(m));
  f.ids.resize(f.points.size(), -1);
}

void addPoints(VtkHdfFrame& f, const ExportPoints& p) {
  const std::size_t n = p.positions.size();
  for (std::size_t i = 0; i < n; i++) {
    f.connectivity.push_back(static_cast<std::int64_t>(f.points.size()));
    f.points.push_back(p.positions[i]);
    for (int c = 0; c < 3; c++) f.colours.push_back(i < p.colours.size() ? colourByte(p.colours[i][c]) : 200);
    f.ids.push_back(i < p.ids.size() ? static_cast<std::int64_t>(p.ids[i]) : -1);
  }
  const std::size_t before = f.points.size() - n;
  append(f.normals, std::vector<Vec3f>(), n, noVector, before);
  append(f.velocities, p.velocities, n, noVector, before);
  append(f.temperatures, p.temperatures, n, noNumber, before);
  append(f.liquid, p.liquid, n, noNumber, before);
  append(f.uvs, {}, n, noUv, before);
  f.objects.resize(f.points.size(), -1);
  f.labels.resize(f.points.size(), -1);
}

/// Returns the values of a field, or `lacking` for each point.
template<class T>
std::vector<T> valuesOf(const std::optional<std::vector<T>>& field, std::size_t points, const T& lacking) {
  return field ? *field : std::vector<T>(points, lacking);
}

/// A dataset of a series.
struct Dataset {
  std::string name;    // below /VTKHDF
  DatasetShape shape;  // rows: those of a chunk
  std::uint64_t rows;  // in a frame
};

std::vector<std::pair<std::string, DatasetShape>> pointFields(const VtkHdfFrame& f) {
  constexpr std::uint64_t chunk = pointsOfChunk;
  std::vector<std::pair<std::string, DatasetShape>> fields{{"color", {Element::U8, chunk, 3}},
                                                           {"object", {Element::I32, chunk, 0}},
                                                           {"component", {Element::I64, chunk, 0}},
                                                           {"id", {Element::I64, chunk, 0}}};
  if (f.normals) fields.push_back({"normal", {Element::F32, chunk, 3}});
  if (f.velocities) fields.push_back({"velocity", {Element::F32, chunk, 3}});
  if (f.temperatures) fields.push_back({"temperature", {Element::F32, chunk, 0}});
  if (f.liquid) fields.push_back({"liquid", {Element::F32, chunk, 0}});
  if (f.uvs) fields.push_back({"uv", {Element::F32, chunk, 2}});
  return fields;
}

std::int64_t particlesOf(const VtkHdfFrame& f) {
  return static_cast<std::int64_t>(f.connectivity.size()) - 3 * f.triangles - 2 * f.lines;
}

std::vector<Dataset> datasetsOf(const VtkHdfFrame& f) {
  constexpr std::uint64_t chunk = pointsOfChunk, few = 256;
  const auto cells = static_cast<std::uint64_t>(f.triangles + f.lines + particlesOf(f));
  std::vector<Dataset> all{{"Points", {Element::F32, chunk, 3}, f.points.size()},
                           {"Connectivity", {Element::I64, 4 * chunk, 0}, f.connectivity.size()},
                           {"Offsets", {Element::I64, 2 * chunk, 0}, cells + 1},
                           {"Types", {Element::U8, 2 * chunk, 0}, cells},
                           {"Steps/Values", {Element::F64, few, 0}, 1}};
  for (const char* name :
       {"NumberOfPoints", "NumberOfCells", "NumberOfConnectivityIds", "Steps/PartOffsets",
        "Steps/NumberOfParts", "Steps/PointOffsets", "Steps/CellOffsets", "Steps/ConnectivityIdOffsets"})
    all.push_back({name, {Element::I64, few, 0}, 1});
  for (const auto& [name, shape] : pointFields(f)) {
    all.push_back({"PointData/" + name, shape, f.points.size()});
    all.push_back({"Steps/PointDataOffsets/" + name, {Element::I64, few, 0}, 1});
  }
  return all;
}

}  // namespace

double vtkHdfBytes(const VtkHdfFrame& frame, double frames) {
  double sum = 0;
  for (const Dataset& d : datasetsOf(frame)) {
    const auto chunk = static_cast<double>(d.shape.rows);
    sum += std::ceil(frames * static_cast<double>(d.rows) / chunk) * chunk *
           static_cast<double>(d.shape.rowBytes());
  }
  return sum;
}

VtkHdfFrame vtkHdfFrameOf(const ExportScene& scene) {
  VtkHdfFrame f;
  f.time = scene.time;
  std::int32_t number = 0;
  std::vector<std::int64_t> lines;
  for (const ComponentMesh& part : placedParts(scene)) {
    const auto first = static_cast<std::int64_t>(f.points.size());
    for (const auto& l : part.lines)
      for (const std::uint32_t v : l) lines.push_back(first + v);
    addMesh(f, part, number++);
  }
  f.connectivity.insert(f.connectivity.end(), lines.begin(), lines.end());
  f.lines = static_cast<std::int64_t>(lines.size() / 2);
  if (scene.points) addPoints(f, *scene.points);
  return f;
}

VtkHdfSeries::VtkHdfSeries(const std::filesystem::path& file)
    : file_(file, {"/VTKHDF", "/VTKHDF/PointData", "/VTKHDF/CellData", "/VTKHDF/FieldData", "/VTKHDF/Steps",
                   "/VTKHDF/Steps/PointDataOffsets", "/VTKHDF/Steps/CellDataOffsets"}) {}

void VtkHdfSeries::addSteps(const VtkHdfFrame& f, std::int64_t cells) {
  const auto one = [&](const std::string& name, std::int64_t value) {
    file_.append("/VTKHDF/" + name, 1, &value);
  };
  one("NumberOfPoints", static_cast<std::int64_t>(f.points.size()));
  one("NumberOfCells", cells);
  one("NumberOfConnectivityIds", static_cast<std::int64_t>(f.connectivity.size()));
  file_.append("/VTKHDF/Steps/Values", 1, &f.time);
  one("Steps/PartOffsets", frames_);
  one("Steps/NumberOfParts", 1);
  one("Steps/PointOffsets", points_);
  one("Steps/CellOffsets", cells_);
  one("Steps/ConnectivityIdOffsets", connectivity_);
}

void VtkHdfSeries::add(const VtkHdfFrame& f) {
  if (frames_ == 0) {
    normals_ = f.normals.has_value(), velocities_ = f.velocities.has_value();
    temperatures_ = f.temperatures.has_value(), liquid_ = f.liquid.has_value(), uvs_ = f.uvs.has_value();
    for (const Dataset& d : datasetsOf(f)) file_.createDataset("/VTKHDF/" + d.name, d.shape);
  }
  const std::size_t n = f.points.size();
  const std::int64_t cells = f.triangles + f.lines + particlesOf(f);
  std::vector<std::int64_t> offsets{0};
  for (std::int64_t c = 0; c < cells; c++)
    offsets.push_back(offsets.back() + (c < f.triangles ? 3 : c < f.triangles + f.lines ? 2 : 1));
  std::vector<std::uint8_t> types(static_cast<std::size_t>(cells), vertexCell);
  std::fill_n(std::fill_n(types.begin(), f.triangles, triangleCell), f.lines, lineCell);
  addSteps(f, cells);
  file_.append("/VTKHDF/Points", n, f.points.data());
  file_.append("/VTKHDF/Connectivity", f.connectivity.size(), f.connectivity.data());
  file_.append("/VTKHDF/Offsets", offsets.size(), offsets.data());
  file_.append("/VTKHDF/Types", types.size(), types.data());
  const auto field = [&](const std::string& name, const void* values) {
    file_.append("/VTKHDF/Steps/PointDataOffsets/" + name, 1, &points_);
    file_.append("/VTKHDF/PointData/" + name, n, values);
  };
  field("color", f.colours.data());
  field("object", f.objects.data());
  field("component", f.labels.data());
  field("id", f.ids.data());
  if (normals_) field("normal", valuesOf(f.normals, n, noVector).data());
  if (velocities_) field("velocity", valuesOf(f.velocities, n, noVector).data());
  if (temperatures_) field("temperature", valuesOf(f.temperatures, n, noNumber).data());
  if (liquid_) field("liquid", valuesOf(f.liquid, n, noNumber).data());
  if (uvs_) field("uv", valuesOf(f.uvs, n, noUv).data());
  frames_++;
  points_ += static_cast<std::int64_t>(n);
  cells_ += cells;
  connectivity_ += static_cast<std::int64_t>(f.connectivity.size());
}

void VtkHdfSeries::finish() {
  file_.finish([&](H5File& file) {
    file.setIntegers("/VTKHDF", "Version", {2, 0});
    file.setText("/VTKHDF", "Type", "UnstructuredGrid");
    file.setInteger("/VTKHDF/Steps", "NSteps", frames_);
  });
}

}  // namespace thaw
