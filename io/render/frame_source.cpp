#include "io/render/frame_source.hpp"

#include <algorithm>
#include <cmath>

#include "io/output/frame.hpp"
#include "io/output/read_oriented_frame.hpp"
#include "io/output/read_surface_frame.hpp"
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

namespace {

/// What stands before the number in the name of a frame: "melt_surface" of melt_surface_000120.hdf.
std::string stemOf(const fs::path& frame) {
  const std::string stem = frame.stem().string();
  const std::size_t digits = stem.find_last_not_of("0123456789");
  return digits != std::string::npos && digits + 1 < stem.size() && stem[digits] == '_' ? stem.substr(0, digits) : stem;
}

bool ofSurface(const fs::path& frame) {
  const std::string stem = stemOf(frame);
  if (!stem.ends_with("_surface")) return false;  // the name is looked at first: a file that is damaged is found out where it is read
  try {
    return isSurfaceFrame(readFrameInfo(frame.string()));
  } catch (const IoError&) {
    return true;
  }
}

struct FolderFrames {
  std::vector<fs::path> particles, surface;
  std::vector<std::string> particleIndices, surfaceIndices;
};

/// What one folder holds of both kinds.
FolderFrames framesIn(const fs::path& folder) {
  FolderFrames found;
  for (const std::string& index : findSeries(folder.string())) {
    if (index.ends_with("_oriented.hdf.series") || index.ends_with("_sheet.hdf.series")) continue;  // drawn with the frame beside
    const std::vector<fs::path> frames = framesOfIndex(index);
    const bool surface = frames.empty() ? fs::path(index).filename().string().ends_with("_surface.hdf.series") : ofSurface(frames.back());
    (surface ? found.surfaceIndices : found.particleIndices).push_back(index);
    std::vector<fs::path>& list = surface ? found.surface : found.particles;
    list.insert(list.end(), frames.begin(), frames.end());
  }
  const auto ofKind = [](const std::string& stem) { return stem.ends_with("_oriented") || stem.ends_with("_sheet"); };  // drawn with the frame beside
  std::vector<std::pair<std::string, bool>> known;  // stems, and whether they are of surfaces
  for (const fs::path& file : filesNamedFrames(folder)) {
    const std::string stem = stemOf(file);
    if (ofKind(stem)) continue;
    auto is = std::find_if(known.begin(), known.end(), [&](const auto& k) { return k.first == stem; });
    if (is == known.end()) is = known.insert(known.end(), {stem, ofSurface(file)});
    if (is->second && found.surfaceIndices.empty()) found.surface.push_back(file);
    if (!is->second && found.particleIndices.empty()) found.particles.push_back(file);
  }
  return found;
}

}  // namespace

std::vector<fs::path> findFrames(const fs::path& path, FrameKind kind) {
  if (!fs::exists(path)) throw IoError(path.string(), "there is no such file or folder");
  if (!fs::is_directory(path)) return path.extension() == ".series" ? framesOfIndex(path) : std::vector<fs::path>{path};
  if (kind == FrameKind::Oriented) {
    for (const fs::path& folder : {path / "frames", path}) {
      if (!fs::is_directory(folder)) continue;
      for (const std::string& index : findSeries(folder.string()))
        if (index.ends_with("_oriented.hdf.series")) return framesOfIndex(index);
    }
    throw IoError(path.string(), "there are no frames of oriented particles in this folder");
  }
  bool particles = false;
  for (const fs::path& folder : {path / "frames", path}) {
    if (!fs::is_directory(folder)) continue;
    const FolderFrames found = framesIn(folder);
    const bool surface = kind == FrameKind::Surface || (kind == FrameKind::Automatic && !found.surface.empty());
    const std::vector<std::string>& indices = surface ? found.surfaceIndices : found.particleIndices;
    if (indices.size() > 1) throw IoError(folder.string(), "several series in one folder; name one of them: " + indices[0]);
    const std::vector<fs::path>& frames = surface ? found.surface : found.particles;
    if (!frames.empty()) return frames;
    particles = particles || !found.particles.empty();
  }
  if (kind == FrameKind::Surface && particles)
    throw IoError(path.string(), "there are no frames of a surface in this folder, only of particles: a scene has a surface if it has a table [surface]");
  throw IoError(path.string(), "there are no frames (.hdf) in this folder");
}

std::vector<std::string> fieldsOf(const fs::path& frame) {
  std::vector<std::string> names;
  for (const FrameInfo::Field& field : readFrameInfo(frame.string()).fields)
    if (field.name != "position") names.push_back(field.name);
  std::sort(names.begin(), names.end());
  return names;
}

namespace {

std::vector<Vec3f> inSinglePrecision(const std::vector<Vec3d>& positions) {
  std::vector<Vec3f> out;
  out.reserve(positions.size());
  for (const Vec3d& p : positions) out.push_back({static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)});
  return out;
}

/// Values of a column; IoError where there is none.
void setValues(FrameView& view, const FrameColumn* column, const fs::path& frame, const std::string& field, const std::string& more) {
  if (!column) {
    std::string names;
    for (const std::string& n : fieldsOf(frame)) names += (names.empty() ? "" : ", ") + n;
    throw IoError(frame.string(), "no field '" + field + "'; there are: " + names + more);
  }
  view.unit = column->unit;
  view.values.resize(view.positions.size());
  for (std::size_t i = 0; i < view.values.size(); i++) view.values[i] = lengthOfRow(*column, i);
}

FrameView surfaceView(const fs::path& file, const std::string& field) {
  const std::string name = field == "speed" ? "velocity" : field == "glow" ? "temperature" : field;
  SurfaceFrame frame = readSurfaceFrame(file.string(), [&](const std::string& n) { return n == name; });
  FrameView view;
  view.time = frame.time;
  view.positions = inSinglePrecision(frame.positions);
  view.normals = std::move(frame.normals);
  view.radii = std::move(frame.radii);
  view.colours = std::move(frame.colours);
  for (const std::uint64_t c : frame.components) view.components.push_back(static_cast<std::uint32_t>(c ^ c >> 32));
  view.paint = field.empty() ? SurfelPaint::Plain : field == "surface" ? SurfelPaint::Surface : field == "glow" ? SurfelPaint::Glow : SurfelPaint::Values;
  if (view.paint == SurfelPaint::Values || view.paint == SurfelPaint::Glow) setValues(view, frame.find(name), file, field, "; and surface, glow");
  return view;
}

}  // namespace

FrameView readFrameView(const fs::path& frame, const std::string& field) {
  if (isSurfaceFrame(readFrameInfo(frame.string()))) return surfaceView(frame, field);
  const std::string name = field == "speed" ? "velocity" : field;
  const FrameData data = readFrame(frame.string(), [&](const std::string& n) { return n == name; });
  FrameView view;
  view.time = data.time;
  view.positions = inSinglePrecision(data.positions);
  if (!field.empty()) setValues(view, data.find(name), frame, field, "");
  return view;
}

FrameView readWholeView(const fs::path& frame, const std::string& field, OrientedLook look, float spacing) {
  const FrameInfo info = readFrameInfo(frame.string());
  if (isOrientedFrame(info)) {
    FrameView view;
    view.time = info.time;
    addOriented(view, frame, look);
    return view;
  }
  // of a scene without particles there is no field to colour with
  FrameView view = readFrameView(frame, info.count > 0 ? field : std::string());
  addKindsBeside(view, frame, look, spacing);
  return view;
}

KeptScene keptSceneOf(const fs::path& frame) {
  FrameData data = readFrame(frame.string(), [](const std::string&) { return false; });
  return {std::move(data.sceneName), std::move(data.sceneText)};
}

}  // namespace thaw
