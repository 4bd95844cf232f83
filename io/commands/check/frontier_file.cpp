// SPDX-License-Identifier: Apache-2.0
#include "io/commands/check/frontier_file.hpp"

#include <fmt/format.h>

#include <charconv>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>

#include "io/hdf5/io_error.hpp"
#include "io/scene/scene_for_all.hpp"

namespace thaw {
namespace {

constexpr const char* header = "case,norm,settings,error,time,best";

std::vector<std::string> splitAtCommas(const std::string& line) {
  std::vector<std::string> fields{""};
  for (const char c : line)
    if (c == ',') fields.emplace_back();
    else fields.back() += c;
  return fields;
}

/// Returns whether the text is a number, and nothing else.
bool readNumber(const std::string& text, double& value) {
  const char* end = text.data() + text.size();
  const auto [stopped, error] = std::from_chars(text.data(), end, value);
  return error == std::errc() && stopped == end;
}

bool readPoint(const std::string& line, FrontierPoint& p) {
  const std::vector<std::string> fields = splitAtCommas(line);
  if (fields.size() != 6 || (fields[5] != "0" && fields[5] != "1")) return false;
  if (!fields[2].empty() && fields[2].find('=') == std::string::npos) return false;
  p.cases = fields[0], p.norm = fields[1], p.settings = fields[2], p.best = fields[5] == "1";
  return readNumber(fields[3], p.error) && readNumber(fields[4], p.cost);
}

}  // namespace

std::string frontierFile() {
  namespace fs = std::filesystem;
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/self/exe", error);
  if (error) return "";
  for (const char* folder : {"share/thaw", "../share/thaw", THAW_DATA_FOLDER}) {
    const fs::path file = (program.parent_path() / folder / "frontier.csv").lexically_normal();
    if (fs::is_regular_file(file, error)) return file.string();
  }
  return "";
}

std::vector<FrontierPoint> parseFrontier(const std::string& path, const std::string& text) {
  std::vector<FrontierPoint> points;
  std::istringstream lines(text);
  std::string line;
  for (int number = 1; std::getline(lines, line); number++) {
    if (FrontierPoint point; number > 1 && readPoint(line, point)) points.push_back(point);
    else if (number > 1 || line != header)
      throw IoError(fmt::format("{}:{}", path, number),
                    fmt::format("expected {}{}; install the file of this version of thaw, or delete it",
                                number > 1 ? "the fields " : "the header ", header));
  }
  return points;
}

std::vector<FrontierPoint> frontierForAll(const Communicator& comm) {
  const std::string path = comm.rank() == 0 ? frontierFile() : "";
  std::string text = path + "\n";
  if (!path.empty()) {
    std::ifstream file(path, std::ios::binary);
    text.append(std::istreambuf_iterator<char>(file), {});
  }
  broadcastText(comm, text);
  const std::size_t end = text.find('\n');
  return parseFrontier(text.substr(0, end), text.substr(end + 1));
}

}  // namespace thaw
