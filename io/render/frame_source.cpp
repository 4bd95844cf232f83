#include "io/render/frame_source.hpp"

#include <algorithm>
#include <cmath>

#include "io/output/frame.hpp"
#include "io/output/series.hpp"

namespace thaw {

namespace fs = std::filesystem;

namespace {

std::vector<fs::path> framesOfIndex(const fs::path& index) {
  std::vector<SeriesEntry> entries = readSeries(index.string());
  std::stable_sort(entries.begin(), entries.end(), [](const auto& a, const auto& b) { return a.time < b.time; });
  std::vector<fs::path> frames;
  for (const SeriesEntry& entry : entries) frames.push_back(index.parent_path() / entry.name);
  return frames;
}

std::vector<fs::path> filesNamedFrames(const fs::path& folder) {
  std::vector<fs::path> found;
  for (const auto& entry : fs::directory_iterator(folder))
    if (entry.is_regular_file() && entry.path().extension() == ".hdf") found.push_back(entry.path());
  std::sort(found.begin(), found.end());
  return found;
}

/// Length of a vector, Frobenius norm of a symmetric tensor (XX YY ZZ XY YZ XZ).
float lengthOfRow(const FrameColumn& column, std::size_t row) {
  if (column.components == 1) return static_cast<float>(column.value(row, 0));
  double sum = 0;
  for (int c = 0; c < column.components; c++) {
    const double v = column.value(row, c);
    sum += (column.components == 6 && c >= 3 ? 2 : 1) * v * v;
  }
  return static_cast<float>(std::sqrt(sum));
}

}  // namespace

std::vector<fs::path> findFrames(const fs::path& path) {
  if (!fs::exists(path)) throw IoError(path.string(), "there is no such file or folder");
  if (!fs::is_directory(path)) return path.extension() == ".series" ? framesOfIndex(path) : std::vector<fs::path>{path};
  for (const fs::path& folder : {path / "frames", path}) {
    if (!fs::is_directory(folder)) continue;
    const std::vector<std::string> indices = findSeries(folder.string());
    if (indices.size() > 1) throw IoError(folder.string(), "several series in one folder; name one of them: " + indices[0]);
    const std::vector<fs::path> frames = indices.empty() ? filesNamedFrames(folder) : framesOfIndex(indices[0]);
    if (!frames.empty()) return frames;
  }
  throw IoError(path.string(), "there are no frames (.hdf) in this folder");
}

std::vector<std::string> fieldsOf(const fs::path& frame) {
  std::vector<std::string> names;
  for (const FrameInfo::Field& field : readFrameInfo(frame.string()).fields)
    if (field.name != "position") names.push_back(field.name);
  std::sort(names.begin(), names.end());
  return names;
}

FrameView readFrameView(const fs::path& frame, const std::string& field) {
  const std::string name = field == "speed" ? "velocity" : field;
  const FrameData data = readFrame(frame.string(), [&](const std::string& n) { return n == name; });
  FrameView view;
  view.time = data.time;
  view.positions.reserve(data.positions.size());
  for (const Vec3d& p : data.positions) view.positions.push_back({static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)});
  if (field.empty()) return view;
  const FrameColumn* column = data.find(name);
  if (!column) {
    std::string names;
    for (const std::string& n : fieldsOf(frame)) names += (names.empty() ? "" : ", ") + n;
    throw IoError(frame.string(), "no field '" + field + "'; there are: " + names);
  }
  view.unit = column->unit;
  view.values.resize(view.positions.size());
  for (std::size_t i = 0; i < view.values.size(); i++) view.values[i] = lengthOfRow(*column, i);
  return view;
}

KeptScene keptSceneOf(const fs::path& frame) {
  FrameData data = readFrame(frame.string(), [](const std::string&) { return false; });
  return {std::move(data.sceneName), std::move(data.sceneText)};
}

}  // namespace thaw
