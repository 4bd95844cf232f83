// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <cstring>

#include "io/frames/frame.hpp"

namespace thaw {
namespace {

template<class T> double valueAt(const std::byte* bytes, std::size_t k) {
  T v;
  std::memcpy(&v, bytes + k * sizeof(T), sizeof(T));
  return static_cast<double>(v);
}

std::string optionalText(const H5File& file, const std::string& attribute) {
  return file.hasAttribute("/run", attribute) ? file.text("/run", attribute) : std::string();
}

/// Returns the number of points of all pieces. Throws IoError if it differs from the number of rows.
std::uint64_t countPoints(const H5File& file, std::uint64_t& pieces) {
  const std::vector<std::int64_t> sizes = readRows<std::int64_t>(file, "/VTKHDF/NumberOfPoints",
                                                                 Element::I64);
  const std::uint64_t rows = file.shape("/VTKHDF/Points").rows;
  std::uint64_t sum = 0;
  for (std::int64_t n : sizes) {
    if (n < 0 || static_cast<std::uint64_t>(n) > rows - sum)
      throw IoError(file.path(),
                    fmt::format("is damaged: its pieces have more points than the dataset, {}", rows));
    sum += static_cast<std::uint64_t>(n);
  }
  if (sum != rows)
    throw IoError(file.path(),
                  fmt::format("is damaged: its pieces have {} points, the dataset {}", sum, rows));
  pieces = sizes.size();
  return rows;
}

FrameInfo infoOf(const H5File& file) {
  if (!isFrame(file)) throw IoError(file.path(), "is not a frame: it has no group /VTKHDF");
  FrameInfo info;
  info.count = countPoints(file, info.pieces);
  if (file.has("/VTKHDF/FieldData/Time")) {
    const std::vector<double> time = readRows<double>(file, "/VTKHDF/FieldData/Time", Element::F64);
    if (!time.empty()) info.time = time[0];
  }
  if (file.has("/VTKHDF/FieldData/Step")) {
    const std::vector<std::int64_t> step = readRows<std::int64_t>(file, "/VTKHDF/FieldData/Step",
                                                                  Element::I64);
    if (!step.empty()) info.step = step[0];
  }
  if (file.has("/run")) {
    info.code = optionalText(file, "code");
    info.commit = optionalText(file, "commit");
    if (file.hasAttribute("/run", "ranks")) info.ranks = file.integer("/run", "ranks");
    if (file.has("/run/scene_name")) info.sceneName = file.readText("/run/scene_name");
  }
  const auto unit = [&](const std::string& name) {
    return file.hasAttribute(name, "units") ? file.text(name, "units") : std::string();
  };
  info.fields.push_back({"position", unit("/VTKHDF/Points"), file.shape("/VTKHDF/Points")});
  if (info.fields[0].shape.components != 3)
    throw IoError(file.path(), "is damaged: points do not have three coordinates");
  for (const std::string& name : file.children("/VTKHDF/PointData")) {
    const std::string path = "/VTKHDF/PointData/" + name;
    info.fields.push_back({name, unit(path), file.shape(path)});
    if (info.fields.back().shape.rows != info.count)
      throw IoError(file.path(), "is damaged: field " + name + " has " +
                                     std::to_string(info.fields.back().shape.rows) + " rows for " +
                                     std::to_string(info.count) + " points");
  }
  return info;
}

/// Reads triangles, if the cells are triangles and the frame has one piece.
void readTriangles(const H5File& file, const FrameInfo& info, FrameData& data) {
  if (info.pieces != 1 || !file.has("/VTKHDF/Types") || !file.has("/VTKHDF/Connectivity")) return;
  const std::uint64_t cells = file.shape("/VTKHDF/Types").rows,
                      ends = file.shape("/VTKHDF/Connectivity").rows;
  if (cells == 0 || ends != 3 * cells) return;
  std::uint8_t type = 0;
  file.read("/VTKHDF/Types", {0, 1}, Element::U8, &type);
  if (type != 5) return;
  std::vector<std::int64_t> rows(ends);
  file.read("/VTKHDF/Connectivity", {0, ends}, Element::I64, rows.data());
  data.triangles.resize(cells);
  for (std::uint64_t k = 0; k < ends; k++) {
    if (rows[k] < 0 || static_cast<std::uint64_t>(rows[k]) >= info.count)
      throw IoError(file.path(), "is damaged: a triangle has a point that does not exist");
    data.triangles[k / 3][k % 3] = static_cast<std::uint32_t>(rows[k]);
  }
}

}  // namespace

double FrameColumn::value(std::size_t row, int c) const {
  const std::size_t k = row * static_cast<std::size_t>(components) + static_cast<std::size_t>(c);
  switch (element) {
    case Element::F64: return valueAt<double>(bytes.data(), k);
    case Element::F32: return valueAt<float>(bytes.data(), k);
    case Element::U64: return valueAt<std::uint64_t>(bytes.data(), k);
    case Element::U32: return valueAt<std::uint32_t>(bytes.data(), k);
    case Element::U16: return valueAt<std::uint16_t>(bytes.data(), k);
    case Element::U8: return valueAt<std::uint8_t>(bytes.data(), k);
    case Element::I64: return valueAt<std::int64_t>(bytes.data(), k);
    case Element::I32: return valueAt<std::int32_t>(bytes.data(), k);
    case Element::Other: break;
  }
  return 0;
}

const FrameColumn* FrameData::find(const std::string& name) const {
  for (const FrameColumn& c : columns)
    if (c.name == name) return &c;
  return nullptr;
}

bool isFrame(const H5File& file) {
  return file.has("/VTKHDF/Points") && file.has("/VTKHDF/NumberOfPoints") && file.has("/VTKHDF/PointData");
}

FrameInfo readFrameInfo(const std::string& path) { return infoOf(H5File::openToRead(path)); }

FrameData readFrame(const std::string& path, const std::function<bool(const std::string&)>& wanted) {
  const H5File file = H5File::openToRead(path);
  const FrameInfo info = infoOf(file);
  FrameData data;
  data.time = info.time;
  data.step = info.step;
  data.pieces = info.pieces;
  data.code = info.code;
  data.commit = info.commit;
  data.ranks = info.ranks;
  data.sceneName = info.sceneName;
  if (file.has("/run/scene_toml")) data.sceneText = file.readText("/run/scene_toml");
  data.positions.resize(info.count);
  file.read("/VTKHDF/Points", {0, info.count}, Element::F64, data.positions.data());
  readTriangles(file, info, data);
  for (std::size_t k = 1; k < info.fields.size(); k++) {
    const FrameInfo::Field& f = info.fields[k];
    if (f.shape.element == Element::Other || (wanted && !wanted(f.name))) continue;
    FrameColumn c{f.name, f.unit, f.shape.element, f.shape.components > 0 ? f.shape.components : 1, {}};
    c.bytes.resize(info.count * f.shape.rowBytes());
    file.read("/VTKHDF/PointData/" + f.name, {0, info.count}, f.shape.element, c.bytes.data());
    data.columns.push_back(std::move(c));
  }
  return data;
}

}  // namespace thaw
