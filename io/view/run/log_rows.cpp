// SPDX-License-Identifier: Apache-2.0
#include "io/view/run/log_rows.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string_view>

#include "io/hdf5/io_error.hpp"

namespace thaw {
namespace {

using Json = nlohmann::ordered_json;

struct LogColumn {
  std::string name;
  std::size_t at;  ///< number of the cell in a line
  Json values;
};

/// Returns the complete lines.
std::vector<std::string_view> linesOf(std::string_view text) {
  std::vector<std::string_view> lines;
  for (std::size_t end = text.find('\n'); end != text.npos; end = text.find('\n')) {
    lines.push_back(text.substr(0, end));
    text.remove_prefix(end + 1);
  }
  return lines;
}

std::vector<std::string_view> cellsOf(std::string_view line) {
  std::vector<std::string_view> cells;
  for (std::size_t end = line.find(','); end != line.npos; end = line.find(',')) {
    cells.push_back(line.substr(0, end));
    line.remove_prefix(end + 1);
  }
  cells.push_back(line);
  return cells;
}

Json valueOf(std::string_view cell) {
  if (cell.empty()) return nullptr;
  double number = 0;
  const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), number);
  if (error != std::errc() || end != cell.data() + cell.size()) return std::string(cell);
  return std::isfinite(number) ? Json(number) : Json(nullptr);
}

std::string textOf(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw IoError(path, "cannot be read");
  return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace

Json logRows(const LogRequest& q) {
  std::error_code error;
  const auto size = static_cast<std::int64_t>(std::filesystem::file_size(q.path, error));
  if (error) throw IoError(q.path, "cannot be read: " + error.message());
  if (size == q.known) return {{"bytes", size}, {"same", true}};
  const std::string text = textOf(q.path);
  const std::vector<std::string_view> lines = linesOf(text);
  Json log = {{"bytes", text.size()}, {"rows", 0}, {"columns", Json::object()}};
  if (lines.empty()) return log;
  const std::vector<std::string_view> names = cellsOf(lines[0]);
  const std::size_t rows = lines.size() - 1;
  std::size_t stride = 1;
  while (rows / stride > std::max<std::size_t>(q.most, 1)) stride *= 2;
  log["rows"] = rows;
  std::vector<LogColumn> wanted;
  for (const std::string& name : q.columns)
    if (const auto at = std::find(names.begin(), names.end(), name); at != names.end())
      wanted.push_back({name, static_cast<std::size_t>(at - names.begin()), Json::array()});
  for (std::size_t row = 1; row < lines.size(); row++) {
    if ((row - 1) % stride != 0 && row + 1 != lines.size()) continue;
    const std::vector<std::string_view> cells = cellsOf(lines[row]);
    for (LogColumn& column : wanted)
      column.values.push_back(column.at < cells.size() ? valueOf(cells[column.at]) : Json(nullptr));
  }
  for (LogColumn& column : wanted) log["columns"][column.name] = std::move(column.values);
  return log;
}

}  // namespace thaw
