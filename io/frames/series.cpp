// SPDX-License-Identifier: Apache-2.0
#include "io/frames/series.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "io/frames/frame.hpp"
#include "io/hdf5/parallel_file.hpp"

namespace fs = std::filesystem;

namespace thaw {
namespace {

/// Returns whether a name is NAME_<six or more digits>.hdf, followed by ".part" if `part` is true.
bool isFrameName(const std::string& file, const std::string& scene, bool part) {
  const std::string end = part ? ".hdf.part" : ".hdf";
  if (file.size() < scene.size() + 7 + end.size() || file.compare(0, scene.size() + 1, scene + "_") != 0 ||
      !file.ends_with(end))
    return false;
  return std::all_of(file.begin() + static_cast<std::ptrdiff_t>(scene.size() + 1),
                     file.end() - static_cast<std::ptrdiff_t>(end.size()),
                     [](char c) { return c >= '0' && c <= '9'; });
}

std::vector<fs::path> filesIn(const std::string& folder) {
  std::vector<fs::path> files;
  std::error_code error;
  for (const fs::directory_entry& e : fs::directory_iterator(folder, error))
    if (e.is_regular_file(error)) files.push_back(e.path());
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace

std::string frameFolder(const std::string& out) { return out + "/frames"; }
std::string frameName(const std::string& scene, std::int64_t number) {
  return fmt::format("{}_{:06}.hdf", scene, number);
}
std::string seriesPath(const std::string& out, const std::string& scene) {
  return frameFolder(out) + "/" + scene + ".hdf.series";
}

void makeFolder(const std::string& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error || !fs::is_directory(folder))
    throw IoError(folder,
                  "cannot make this folder: " + (error ? error.message() : "there is a file of this name"));
}

void makeOutputFolders(const std::string& out) {
  for (const std::string& folder : {out, frameFolder(out), out + "/checkpoint"}) makeFolder(folder);
}

void writeSeries(const std::string& path, const std::vector<SeriesEntry>& entries) {
  nlohmann::ordered_json files = nlohmann::ordered_json::array();
  for (const SeriesEntry& e : entries) files.push_back({{"name", e.name}, {"time", e.time}});
  const nlohmann::ordered_json all = {{"file-series-version", "1.0"}, {"files", files}};
  replaceTextFile(path, all.dump(1, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n");
}

std::vector<SeriesEntry> readSeries(const std::string& path) {
  std::ifstream file(path);
  if (!file) throw IoError(path, "cannot be read");
  std::stringstream text;
  text << file.rdbuf();
  std::vector<SeriesEntry> entries;
  try {
    const nlohmann::json all = nlohmann::json::parse(text.str());
    for (const auto& e : all.at("files"))
      entries.push_back({e.at("name").get<std::string>(), e.at("time").get<double>()});
  } catch (const nlohmann::json::exception& e) {
    throw IoError(path, std::string("is not an index of frames: ") + e.what());
  }
  return entries;
}

std::vector<SeriesEntry> framesPresent(const std::string& out, const std::string& scene, double until) {
  std::vector<SeriesEntry> entries;
  for (const fs::path& file : filesIn(frameFolder(out))) {
    const std::string name = file.filename().string();
    std::error_code error;
    if (isFrameName(name, scene, true)) fs::remove(file, error);
    if (!isFrameName(name, scene, false)) continue;
    try {
      const double time = readFrameInfo(file.string()).time;
      if (time <= until) entries.push_back({name, time});
    } catch (const IoError&) {  // written by another program, or damaged: not part of the animation
    }
  }
  std::stable_sort(entries.begin(), entries.end(),
                   [](const SeriesEntry& a, const SeriesEntry& b) { return a.time < b.time; });
  return entries;
}

void removeFramesAfter(const std::string& out, const std::string& scene, std::vector<SeriesEntry>& entries,
                       double time) {
  std::vector<std::string> gone;
  for (; !entries.empty() && entries.back().time > time; entries.pop_back())
    gone.push_back(entries.back().name);
  if (gone.empty()) return;
  writeSeries(seriesPath(out, scene), entries);
  std::error_code error;
  for (const std::string& name : gone) fs::remove(frameFolder(out) + "/" + name, error);
}

std::vector<std::string> findSeries(const std::string& folder) {
  std::vector<std::string> found;
  for (const std::string& f : {folder, frameFolder(folder)})
    for (const fs::path& file : filesIn(f))
      if (file.filename().string().ends_with(".hdf.series")) found.push_back(file.string());
  return found;
}

}  // namespace thaw
