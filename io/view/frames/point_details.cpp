// SPDX-License-Identifier: Apache-2.0
#include "io/view/frames/point_details.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <nlohmann/json.hpp>

#include "io/frames/rows_by_id.hpp"

namespace thaw {
namespace {

using Json = nlohmann::ordered_json;

/// Returns the row of a point in the frame as read.
std::size_t rowOf(const ThinnedFrame& read, const PointChoice& point, const std::string& path) {
  if (point.index && *point.index < read.rows.size()) return read.rows[*point.index];
  if (point.id) {
    const std::vector<std::uint64_t> ids = idsOf(read.frame);
    const auto at = std::find(ids.begin(), ids.end(), *point.id);
    if (at != ids.end()) return static_cast<std::size_t>(at - ids.begin());
  }
  throw IoError(path, point.id ? "has no point with id " + std::to_string(*point.id) : "has no such point");
}

Json numberOf(double value) { return std::isfinite(value) ? Json(value) : Json(std::to_string(value)); }

/// Returns the components of a row. Numbers of 64 bits are texts: numbers of JSON have 53 bits in a browser.
Json valuesOf(const FrameColumn& column, std::size_t row) {
  Json values = Json::array();
  const auto width = static_cast<std::size_t>(column.components);
  for (std::size_t c = 0; c < width; c++) {
    if (column.element == Element::U64 || column.element == Element::I64) {
      std::uint64_t whole = 0;
      std::memcpy(&whole, column.bytes.data() + (row * width + c) * sizeof whole, sizeof whole);
      values.push_back(column.element == Element::U64 ? std::to_string(whole)
                                                      : std::to_string(static_cast<std::int64_t>(whole)));
    } else {
      values.push_back(numberOf(column.value(row, static_cast<int>(c))));
    }
  }
  return values;
}

}  // namespace

Json pointDetails(const FrameRequest& q, const PointChoice& point) {
  const ThinnedFrame read = readThinned(q, [](const std::string&) { return true; });
  const std::size_t row = rowOf(read, point, q.path);
  const auto place = std::lower_bound(read.rows.begin(), read.rows.end(), row);
  const bool drawn = place != read.rows.end() && *place == row;
  const Vec3d& x = read.frame.positions[row];
  Json details = {{"type", pointTypeNames[static_cast<std::size_t>(q.type)]},
                  {"time", read.frame.time},
                  {"index", drawn ? place - read.rows.begin() : -1},
                  {"position", {x.x, x.y, x.z}},
                  {"fields", Json::array()}};
  const std::vector<std::uint64_t> ids = idsOf(read.frame);
  if (!ids.empty()) details["id"] = std::to_string(ids[row]);
  for (const FrameColumn& column : read.frame.columns)
    if (column.name != "id")
      details["fields"].push_back(
          {{"name", column.name}, {"unit", column.unit}, {"values", valuesOf(column, row)}});
  return details;
}

}  // namespace thaw
