// SPDX-License-Identifier: Apache-2.0
#include "io/scene/scene_files.hpp"

#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include "io/scene/resolve_scene.hpp"

namespace thaw {
namespace {

constexpr std::uintmax_t largestFile = 16u << 20;
constexpr std::size_t longestLine = 16384;  // limits the nesting of dotted keys before the stack of the
                                            // parser overflows

/// Returns the reason why a text cannot be a scene, or "".
std::string problemOf(const std::string& text) {
  if (text.empty()) return "the file is empty";
  if (text.find('\0') != std::string::npos) return "has a zero byte: not a text file";
  std::size_t line = 1;
  for (std::size_t begin = 0; begin < text.size(); line++) {
    std::size_t end = text.find('\n', begin);
    if (end == std::string::npos) end = text.size();
    if (end - begin > longestLine)
      return "line " + std::to_string(line) + " is longer than " + std::to_string(longestLine) +
             " characters (it has " + std::to_string(end - begin) +
             "); split it: a list may span several lines";
    begin = end + 1;
  }
  return "";
}

/// Returns the text of a file, or sets `problem`.
std::string readText(const std::string& path, std::string& problem) {
  std::error_code code;
  const auto status = std::filesystem::status(path, code);
  if (!std::filesystem::exists(status)) return problem = "no such file", "";
  if (std::filesystem::is_directory(status)) return problem = "a folder, not a file", "";
  if (!std::filesystem::is_regular_file(status)) return problem = "not a regular file", "";
  if (std::filesystem::file_size(path, code) > largestFile)
    return problem = "larger than 16 MiB: not a scene", "";
  std::ifstream in(path, std::ios::binary);
  if (!in) return problem = "cannot be opened for reading", "";
  std::string text((std::istreambuf_iterator<char>(in)), std::istreambuf_iterator<char>());
  if (in.bad()) return problem = "cannot be read", "";
  problem = problemOf(text);
  return text;
}

void load(SceneFiles& files, const std::string& path, int depth) {
  if (depth > deepestInclude || files.texts.count(path) || files.problems.count(path)) return;
  std::string problem, text = readText(path, problem);
  if (!problem.empty()) {
    files.problems[path] = problem;
    return;
  }
  try {
    const toml::table t = toml::parse(text, path);
    files.texts[path] = std::move(text);
    for (const auto& [other, where] : includesOf(t, path, nullptr)) load(files, other, depth + 1);
  } catch (const toml::parse_error&) {  // reported when the scene is read
    files.texts[path] = std::move(text);
  }
}

void put(std::string& bytes, const std::string& s) { bytes += std::to_string(s.size()) + ":" + s; }

struct Unpacker {
  const std::string& bytes;
  std::size_t at = 0;
  std::string next() {
    std::size_t n = 0, digits = 0;
    while (at < bytes.size() && bytes[at] >= '0' && bytes[at] <= '9' && digits++ < 15)
      n = 10 * n + static_cast<std::size_t>(bytes[at++] - '0');
    if (digits == 0 || at >= bytes.size() || bytes[at] != ':' || n > bytes.size() - at - 1)
      throw std::runtime_error("the packed scene files are damaged");
    std::string s = bytes.substr(at + 1, n);
    at += n + 1;
    return s;
  }
  std::map<std::string, std::string> nextMap() {
    std::map<std::string, std::string> m;
    const std::string count = next();
    std::string path;
    for (std::size_t k = 0; std::to_string(k) != count; k++) {
      path = next();
      m[path] = next();
    }
    return m;
  }
};

}  // namespace

SceneFiles loadSceneFiles(const std::string& path) {
  SceneFiles files;
  std::error_code code;
  files.main = std::filesystem::path(path).lexically_normal().string();
  files.base = std::filesystem::current_path(code).string();
  load(files, files.main, 0);
  return files;
}

SceneFiles sceneFilesOf(const std::string& name, const std::string& text) {
  SceneFiles files;
  std::error_code code;
  files.main = name;
  files.base = std::filesystem::current_path(code).string();
  const std::string problem = text.size() > largestFile ? "larger than 16 MiB: not a scene" : problemOf(text);
  (problem.empty() ? files.texts : files.problems)[name] = problem.empty() ? text : problem;
  return files;
}

std::string packSceneFiles(const SceneFiles& files) {
  std::string bytes;
  put(bytes, files.main);
  put(bytes, files.base);
  for (const auto* m : {&files.texts, &files.problems}) {
    put(bytes, std::to_string(m->size()));
    for (const auto& [path, text] : *m) {
      put(bytes, path);
      put(bytes, text);
    }
  }
  return bytes;
}

SceneFiles unpackSceneFiles(const std::string& bytes) {
  Unpacker u{bytes};
  SceneFiles files;
  files.main = u.next();
  files.base = u.next();
  files.texts = u.nextMap();
  files.problems = u.nextMap();
  return files;
}

}  // namespace thaw
