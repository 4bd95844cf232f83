// SPDX-License-Identifier: Apache-2.0
#include "io/view/frames/frame_list.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>

#include "core/math/hash_random.hpp"
#include "io/frames/frame.hpp"
#include "io/frames/series.hpp"

namespace fs = std::filesystem;

namespace thaw {
namespace {

constexpr std::array<const char*, 4> nameEnds{"", "_surface", "_sheet", "_oriented"};
constexpr const char* indexEnd = ".hdf.series";

/// Returns the scenes that could have these indices: of "cloth_sheet" alone, "cloth" and "cloth_sheet".
std::vector<std::string> scenesOf(const std::vector<std::string>& names) {
  std::vector<std::string> scenes;
  for (auto end = nameEnds.rbegin(); end != nameEnds.rend(); end++) {
    const std::string &name = names.front(), text = *end;
    if (!name.ends_with(text) || name.size() == text.size()) continue;
    const std::string scene = name.substr(0, name.size() - text.size());
    if (std::all_of(names.begin(), names.end(), [&](const std::string& other) {
          return std::any_of(nameEnds.begin(), nameEnds.end(),
                             [&](const char* e) { return other == scene + e; });
        }))
      scenes.push_back(scene);
  }
  return scenes;
}

/// Returns the name of the scene in the first frame of an index, or "".
std::string sceneInFrame(const std::string& index) {
  try {
    for (const SeriesEntry& entry : readSeries(index))
      if (entry.name.find('/') == std::string::npos)
        return readFrameInfo((fs::path(index).parent_path() / entry.name).string()).sceneName;
  } catch (const IoError&) {  // the names decide
  }
  return {};
}

/// Returns the number in NAME_000012.hdf, or -1 for another name.
std::int64_t numberIn(const std::string& file, const std::string& name) {
  std::int64_t number = -1;
  if (file.size() <= name.size() + 5) return -1;
  const char *begin = file.data() + name.size() + 1, *end = file.data() + file.size() - 4;
  const auto [stop, error] = std::from_chars(begin, end, number);
  if (error != std::errc() || stop != end || number < 0) return -1;
  return file == frameName(name, number) ? number : -1;
}

/// Mixes time and size of a file into a hash.
std::uint64_t withFile(std::uint64_t hash, const fs::path& file) {
  std::error_code error;
  const auto time = fs::last_write_time(file, error).time_since_epoch().count();
  const auto size = fs::file_size(file, error);
  return mixBits(mixBits(hash + static_cast<std::uint64_t>(time)) + size);
}

std::vector<SeriesEntry> entriesOf(const std::string& index) {
  try {
    return readSeries(index);
  } catch (const IoError&) {  // removed or replaced since the folder was read; the next look finds it
    return {};
  }
}

}  // namespace

std::optional<PointType> pointTypeNamed(const std::string& name) {
  for (std::size_t k = 0; k < pointTypeNames.size(); k++)
    if (name == pointTypeNames[k]) return static_cast<PointType>(k);
  return std::nullopt;
}

const ListedFrame* FrameList::find(std::int64_t number) const {
  const auto at = std::lower_bound(frames.begin(), frames.end(), number,
                                   [](const ListedFrame& f, std::int64_t n) { return f.number < n; });
  return at != frames.end() && at->number == number ? &*at : nullptr;
}

FrameList readFrameList(const fs::path& run) {
  FrameList list;
  std::vector<std::string> indices, names;
  for (const std::string& path : findSeries(run.string())) {
    const std::string file = fs::path(path).filename().string();
    if (fs::path(path).parent_path() != fs::path(frameFolder(run.string()))) continue;
    indices.push_back(path);
    names.push_back(file.substr(0, file.size() - std::string(indexEnd).size()));
  }
  if (indices.empty()) return list;
  const std::vector<std::string> scenes = scenesOf(names);
  if (scenes.empty())
    throw IoError(frameFolder(run.string()),
                  "frames of several scenes: " + names.front() + ", " + names.back());
  list.scene = scenes.front();
  if (scenes.size() > 1)
    if (const std::string stored = sceneInFrame(indices.front());
        std::find(scenes.begin(), scenes.end(), stored) != scenes.end())
      list.scene = stored;
  std::map<std::int64_t, ListedFrame> byNumber;
  for (std::size_t k = 0; k < indices.size(); k++) {
    list.revision = withFile(list.revision, indices[k]);
    const auto type = static_cast<std::size_t>(
        std::find_if(nameEnds.begin(), nameEnds.end(),
                     [&](const char* end) { return names[k] == list.scene + end; }) -
        nameEnds.begin());
    for (const SeriesEntry& entry : entriesOf(indices[k])) {
      const std::int64_t number = numberIn(entry.name, names[k]);
      if (number < 0 || !std::isfinite(entry.time)) continue;
      ListedFrame& frame = byNumber[number];
      frame.number = number;
      frame.time = entry.time;
      frame.has[type] = true;
    }
  }
  for (const auto& [number, frame] : byNumber) list.frames.push_back(frame);
  return list;
}

fs::path framePath(const fs::path& run, const std::string& scene, PointType type, std::int64_t number) {
  return fs::path(frameFolder(run.string())) /
         frameName(scene + nameEnds[static_cast<std::size_t>(type)], number);
}

}  // namespace thaw
