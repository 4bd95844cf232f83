// SPDX-License-Identifier: Apache-2.0
#include "io/checkpoint/damaged_rows.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "io/hdf5/parallel_file.hpp"

namespace thaw {
namespace {

bool fits(const H5File& file, const std::string& dataset) {
  constexpr std::uint64_t piece = 1 << 18;
  const DatasetShape s = file.shape(dataset);
  std::vector<std::byte> rows(std::min(piece, s.rows) * s.rowBytes());
  std::uint64_t sum = 0;
  for (std::uint64_t at = 0; at < s.rows; at += piece) {
    const RowRange range{at, std::min(piece, s.rows - at)};
    file.read(dataset, range, s.element, rows.data());
    sum += checksumRows(rows.data(), range, s.rowBytes());
  }
  return sum == static_cast<std::uint64_t>(file.integer(dataset, "checksum"));
}

void addDamaged(const H5File& file, const std::string& group, std::vector<std::string>& damaged) {
  for (const std::string& name : file.children(group)) {
    const std::string path = group + "/" + name;
    if (file.hasAttribute(path, "checksum") && !fits(file, path)) damaged.push_back(path);
  }
}

}  // namespace

std::vector<std::string> damagedRows(const H5File& file) {
  std::vector<std::string> damaged;
  for (const char* group : {"/particles", "/solids", "/bonds", "/order", "/pieces", "/surfels",
                            "/surface/components", "/surface/events", "/oriented", "/sheet"})
    if (file.has(group)) addDamaged(file, group, damaged);
  return damaged;
}

std::string damageText(const std::vector<std::string>& datasets) {
  std::string text;
  for (const std::string& name : datasets) text += (text.empty() ? "" : ", ") + name;
  return "is damaged: the checksum of " + text + " is wrong";
}

}  // namespace thaw
