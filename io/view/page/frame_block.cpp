// SPDX-License-Identifier: Apache-2.0
#include "io/view/page/frame_block.hpp"

#include <cstring>
#include <nlohmann/json.hpp>

#include "io/frames/rows_by_id.hpp"
#include "io/view/frames/mesh_packet.hpp"
#include "io/view/frames/thin_rows.hpp"
#include "io/view/page/byte_planes.hpp"

namespace thaw {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::uint64_t verticesPerSurfel = 2;  // at most, to limit the size of meshes
constexpr Accuracy coarse{254, 0};              // as many steps as a colour map has colours

template<class T> std::vector<T> numbersOf(const PacketArray& array) {
  std::vector<T> numbers(array.bytes.size() / sizeof(T));
  if (!numbers.empty()) std::memcpy(numbers.data(), array.bytes.data(), array.bytes.size());
  return numbers;
}

/// Adds whole numbers under a name, and their decoding parameters to the header.
void addWhole(Packet& packet, const std::string& name, const WholeRows& rows,
              const Json& more = Json::object()) {
  const std::vector<std::uint8_t> planes = bytePlanes(rows);
  Json column = {{"components", rows.components},
                 {"rows", rows.values.size() / static_cast<std::size_t>(rows.components)},
                 {"width", rows.width}};
  column.update(more);
  packet.header["columns"][name] = column;
  packet.add(name.c_str(), std::span<const std::uint8_t>(planes), 1);
}

void addQuantised(Packet& packet, const std::string& name, const QuantisedRows& rows) {
  addWhole(packet, name, rows.codes, {{"low", rows.low}, {"step", rows.step}});
}

WholeRows wholeOf(const std::vector<std::uint32_t>& numbers, int components) {
  std::uint32_t largest = 0;
  for (const std::uint32_t v : numbers) largest = std::max(largest, v);
  return {{numbers.begin(), numbers.end()}, components, largest < 256 ? 1 : largest < 65536 ? 2 : 4};
}

/// Adds an array of framePacket in its smallest form.
void addArray(Packet& packet, const PacketArray& array, double spacing) {
  const auto components = static_cast<int>(array.components);
  if (array.name == "position") {
    const Accuracy accuracy{65534, spacing / 64};
    addQuantised(packet, array.name, quantised(numbersOf<float>(array), components, 2, accuracy));
  } else if (array.name == "normal") {
    addWhole(packet, array.name, octahedral(numbersOf<std::int16_t>(array)));
  } else if (array.type == "f32") {
    addQuantised(packet, array.name, quantised(numbersOf<float>(array), components, 1, coarse));
  } else if (array.type == "u8") {
    WholeRows rows{{}, 3, 1};  // the fourth component is for the alignment
    for (std::size_t k = 0; k < array.bytes.size(); k++)
      if (k % 4 < 3) rows.values.push_back(static_cast<unsigned char>(array.bytes[k]));
    addWhole(packet, array.name, rows);
  } else {
    addWhole(packet, array.name, wholeOf(numbersOf<std::uint32_t>(array), components));
  }
}

/// Adds all components of a field; names begin with "field:", apart from those of arrays.
void addField(Packet& packet, const FrameColumn& column, std::size_t rows) {
  const std::string name = "field:" + column.name;
  if (isLabel(column.name, column.element)) return addWhole(packet, name, wholeOf(labelsOf(column, rows), 1));
  std::vector<float> values;
  values.reserve(rows * static_cast<std::size_t>(column.components));
  for (std::size_t i = 0; i < rows; i++)
    for (int c = 0; c < column.components; c++) values.push_back(static_cast<float>(column.value(i, c)));
  addQuantised(packet, name, quantised(values, column.components, 1, coarse));
}

/// Returns whether the arrays of a packet already contain this field.
bool isLook(const std::string& name) { return name == "normal" || name == "radius" || name == "cut_sides"; }

}  // namespace

std::string meshBlock(const BlockRequest& q, const PeriodicSides& sides) {
  FrameRequest request;
  request.path = q.path;
  request.type = PointType::Surface;
  request.most = q.most;
  SurfaceToMesh surface = readSurfaceToMesh(request);
  surface.most = std::min<std::uint64_t>(surface.most, verticesPerSurfel * surface.surfels.positions.size());
  const Packet mesh = meshPacket(surface, sides);
  Packet packet;
  packet.header = mesh.header;
  for (const PacketArray& array : mesh.arrays()) addArray(packet, array, q.spacing);
  return deflated(packet.bytes());
}

FrameBlock frameBlock(const BlockRequest& q, const Json& poses) {
  FrameRequest request;
  request.path = q.path;
  request.type = q.type;
  request.most = q.most;
  const Packet look = framePacket(request);
  ThinnedFrame read = readThinned(request, [](const std::string&) { return true; });
  keepRows(read.frame, read.rows);
  const std::size_t rows = read.frame.positions.size();
  FrameBlock block{{}, rows, read.level, {}};
  Packet packet;
  packet.header = look.header;
  packet.header["obstacles"] = poses;
  packet.header["fields"] = Json::array();
  for (const PacketArray& array : look.arrays()) addArray(packet, array, q.spacing);
  const std::vector<std::uint64_t> ids = idsOf(read.frame);
  if (!ids.empty()) addWhole(packet, "id", {ids, 1, 8});
  for (const Json& field : look.header["fields"]) {
    const auto name = field["name"].get<std::string>();
    const FrameColumn* column = read.frame.find(name);
    const int components = field["components"].get<int>();
    if (components == 6) block.tensors.push_back(name);
    if (!column || isLook(name) || (components == 6 && !q.tensors)) continue;
    addField(packet, *column, rows);
    packet.header["fields"].push_back(field);
  }
  block.stream = deflated(packet.bytes());
  return block;
}

}  // namespace thaw
