// SPDX-License-Identifier: Apache-2.0
#include "io/render/frame_source.hpp"

#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "io/frames/frame.hpp"
#include "io/frames/read_oriented_frame.hpp"
#include "io/frames/read_surface_frame.hpp"
#include "io/frames/series.hpp"
#include "io/render/mesh_faces.hpp"
#include "io/render/scene_job.hpp"
#include "io/render/surfels/cut_sides.hpp"
#include "io/surface_mesh/surface_mesh.hpp"

namespace thaw {

namespace fs = std::filesystem;

namespace {

std::vector<fs::path> framesOfIndex(const fs::path& index) {
  std::vector<SeriesEntry> entries = readSeries(index.string());
  std::stable_sort(entries.begin(), entries.end(),
                   [](const auto& a, const auto& b) { return a.time < b.time; });
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

/// Returns the length of a vector, or the Frobenius norm of a symmetric tensor (XX YY ZZ XY YZ XZ).
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

/// Returns the name of a frame without its number: "melt_surface" for melt_surface_000120.hdf.
std::string stemOf(const fs::path& frame) {
  const std::string stem = frame.stem().string();
  const std::size_t digits = stem.find_last_not_of("0123456789");
  return digits != std::string::npos && digits + 1 < stem.size() && stem[digits] == '_'
             ? stem.substr(0, digits)
             : stem;
}

bool ofSurface(const fs::path& frame) {
  const std::string stem = stemOf(frame);
  if (!stem.ends_with("_surface"))
    return false;  // the name is tested first; a damaged file is reported when it is read
  try {
    return isSurfaceFrame(readFrameInfo(frame.string()));
  } catch (const IoError&) { return true; }
}

/// Returns the body type of a frame that is drawn with others, "sheet" for melt_sheet_000120.hdf; else "".
std::string bodyTypeOfFrame(const fs::path& frame) {
  const std::string stem = stemOf(frame);
  for (std::string kind : {"sheet", "oriented"}) {
    if (!stem.ends_with("_" + kind)) continue;
    for (const FrameInfo::Field& f : readFrameInfo(frame.string()).fields)
      if (f.name == kind + "_body") return kind;
  }
  return {};
}

/// Returns the frame of the same number for another body type; empty without one.
fs::path companionOf(const fs::path& frame, const std::string& kind) {
  std::string scene = stemOf(frame);
  const std::string stem = frame.stem().string(), number = stem.substr(scene.size()),
                    own = ofSurface(frame) ? "surface" : bodyTypeOfFrame(frame);
  if (!own.empty()) scene.resize(scene.size() - own.size() - 1);
  const fs::path other = frame.parent_path() / (scene + "_" + kind + number + ".hdf");
  return other != frame && fs::exists(other) && bodyTypeOfFrame(other) == kind ? other : fs::path();
}

/// Returns the frame of particles at the time of a surface frame; empty without one.
fs::path particlesOf(const fs::path& surface) {
  std::string scene = stemOf(surface);
  if (!scene.ends_with("_surface")) return {};
  const std::string number = surface.stem().string().substr(scene.size());
  scene.resize(scene.size() - std::string("_surface").size());
  const fs::path particles = surface.parent_path() / (scene + number + ".hdf");
  return fs::exists(particles) ? particles : fs::path();
}

struct FolderFrames {
  std::vector<fs::path> particles, surface;
  std::vector<std::string> particleIndices, surfaceIndices;
};

/// Returns the frames of particles and surfaces in a folder.
FolderFrames framesIn(const fs::path& folder) {
  FolderFrames found;
  for (const std::string& index : findSeries(folder.string())) {
    // drawn with the associated frame
    if (index.ends_with("_oriented.hdf.series") || index.ends_with("_sheet.hdf.series")) continue;
    const std::vector<fs::path> frames = framesOfIndex(index);
    // drawn with the particles' frames
    if (!frames.empty() && !bodyTypeOfFrame(frames.back()).empty()) continue;
    const bool surface = frames.empty() ? fs::path(index).filename().string().ends_with("_surface.hdf.series")
                                        : ofSurface(frames.back());
    (surface ? found.surfaceIndices : found.particleIndices).push_back(index);
    std::vector<fs::path>& list = surface ? found.surface : found.particles;
    list.insert(list.end(), frames.begin(), frames.end());
  }
  // drawn with the associated frame
  const auto ofKind = [](const std::string& stem) {
    return stem.ends_with("_oriented") || stem.ends_with("_sheet");
  };
  std::vector<std::pair<std::string, bool>> known;  // stems, and whether their frames are surfaces
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
  if (!fs::exists(path)) throw IoError(path.string(), "no such file or folder");
  if (!fs::is_directory(path))
    return path.extension() == ".series" ? framesOfIndex(path) : std::vector<fs::path>{path};
  if (kind == FrameKind::Oriented || kind == FrameKind::Sheet) {
    const bool sheet = kind == FrameKind::Sheet;
    for (const fs::path& folder : {path / "frames", path}) {
      if (!fs::is_directory(folder)) continue;
      for (const std::string& index : findSeries(folder.string()))
        if (index.ends_with(sheet ? "_sheet.hdf.series" : "_oriented.hdf.series"))
          return framesOfIndex(index);
    }
    throw IoError(path.string(), std::string("there are no frames of ") +
                                     (sheet ? "sheets" : "oriented particles") + " in this folder");
  }
  bool particles = false;
  for (const fs::path& folder : {path / "frames", path}) {
    if (!fs::is_directory(folder)) continue;
    const FolderFrames found = framesIn(folder);
    const bool surface = kind == FrameKind::Surface ||
                         (kind == FrameKind::Automatic && !found.surface.empty());
    const std::vector<std::string>& indices = surface ? found.surfaceIndices : found.particleIndices;
    if (indices.size() > 1)
      throw IoError(folder.string(), "several series in one folder; name one of them: " +
                                         fmt::format("{}", fmt::join(indices, ", ")));
    const std::vector<fs::path>& frames = surface ? found.surface : found.particles;
    if (!frames.empty()) return frames;
    particles = particles || !found.particles.empty();
  }
  if (!particles)  // scene without continuum
    for (const FrameKind other : {FrameKind::Sheet, FrameKind::Oriented}) try {
        std::vector<fs::path> frames = findFrames(path, other);
        if (kind != FrameKind::Surface) return frames;
        particles = true;
      } catch (const IoError&) {  // reported below
      }
  if (kind == FrameKind::Surface && particles)
    throw IoError(path.string(),
                  "there are no surface frames in this folder, only frames of particles, sheets or oriented "
                  "particles; a scene has a surface with a table [surface]");
  throw IoError(path.string(), "there are no frames (.hdf) in this folder");
}

bool drawnAsSurface(const fs::path& frame) {
  return isSurfaceFrame(readFrameInfo(frame.string())) || bodyTypeOfFrame(frame) == "sheet" ||
         !companionOf(frame, "sheet").empty();
}

std::vector<std::string> fieldsOf(const fs::path& frame, bool withSheets) {
  std::vector<std::string> names;
  const auto add = [&](const fs::path& file) {
    for (const FrameInfo::Field& field : readFrameInfo(file.string()).fields)
      if (field.name != "position" && std::find(names.begin(), names.end(), field.name) == names.end())
        names.push_back(field.name);
  };
  add(frame);
  if (const fs::path sheets = companionOf(frame, "sheet"); withSheets && !sheets.empty()) add(sheets);
  std::sort(names.begin(), names.end());
  return names;
}

namespace {

std::vector<Vec3f> inSinglePrecision(const std::vector<Vec3d>& positions) {
  std::vector<Vec3f> out;
  out.reserve(positions.size());
  for (const Vec3d& p : positions)
    out.push_back({static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)});
  return out;
}

/// Returns whether the values of a column are integers.
bool isWhole(const FrameColumn& column) {
  return column.components == 1 && column.element != Element::F32 && column.element != Element::F64;
}

/// Sets the values from a column; throws IoError without one.
void setValues(FrameView& view, const FrameColumn* column, const fs::path& frame, const std::string& field,
               const std::string& more) {
  if (!column) {
    std::string names;
    for (const std::string& n : fieldsOf(frame)) names += (names.empty() ? "" : ", ") + n;
    throw IoError(frame.string(), "no field '" + field + "'; there are: " + names + more);
  }
  view.unit = column->unit;
  view.whole = isWhole(*column);
  view.values.resize(view.positions.size());
  for (std::size_t i = 0; i < view.values.size(); i++) view.values[i] = lengthOfRow(*column, i);
}

/// Unwraps components across periodic sides, which would show their insides at the sides. Returns those that
/// join their own images, and are cut.
CutComponents unwrapComponents(SurfaceFrame& frame, const PeriodicSides& sides) {
  CutComponents cuts;
  if (!sides.any()) return cuts;
  for (const ComponentRows& c : rowsByComponent(frame)) {
    const UnwrappedComponent whole = unwrapComponent(frame, c.rows, sides);
    for (std::size_t k = 0; k < c.rows.size(); k++) frame.positions[c.rows[k]] = whole.positions[k];
    for (std::size_t a = 0; a < 3; a++)
      if (whole.selfJoined[a]) cuts[c.component] |= static_cast<std::uint8_t>(1u << a);
  }
  return cuts;
}

/// Sets the least volumes of drops, and their velocities unless they are `moving`, from the particles of the
/// same time. The label of a component is 1 + the id of one of its particles.
void addParticles(std::vector<SprayDrop>& drops, bool moving, const fs::path& particles) {
  const FrameData data = readFrame(particles.string(), [&](const std::string& n) {
    return n == "id" || n == "volume" || (n == "velocity" && !moving);
  });
  const FrameColumn *velocity = data.find("velocity"), *id = data.find("id"), *volume = data.find("volume");
  if (velocity && velocity->components != 3) velocity = nullptr;
  if (!id || !(velocity || volume)) return;
  for (std::size_t i = 0; i < data.positions.size(); i++) {
    const auto label = static_cast<std::uint64_t>(id->value(i)) + 1;
    const auto drop = std::lower_bound(
        drops.begin(), drops.end(), label,
        [](const SprayDrop& d, std::uint64_t component) { return d.component < component; });
    if (drop == drops.end() || drop->component != label) continue;
    if (velocity) drop->velocity = {velocity->value(i, 0), velocity->value(i, 1), velocity->value(i, 2)};
    if (volume) drop->least = volume->value(i);
  }
}

bool hasField(const fs::path& frame, const std::string& name) {
  return std::ranges::any_of(readFrameInfo(frame.string()).fields,
                             [&](const FrameInfo::Field& f) { return f.name == name; });
}

void drawSpray(const fs::path& file, const SprayStyle& style, SurfaceFrame& frame) {
  if (style.look == Spray::Surfels) return;
  std::vector<SprayDrop> drops = findSpray(frame, style.spacing);
  if (drops.empty()) return;
  const bool moving = style.look != Spray::Ellipsoids || frame.find("velocity");
  const fs::path particles = particlesOf(file);
  if (!particles.empty() && (!moving || hasField(particles, "volume")))
    addParticles(drops, moving, particles);
  replaceSpray(frame, drops, style);
}

/// Reads surfels. alone: without sheets; with sheets the field may belong to them, and the surface keeps its
/// own colours.
FrameView surfaceView(const fs::path& file, const std::string& field, const ViewStyle& style, bool alone) {
  const std::string name = field == "speed" ? "velocity" : field == "glow" ? "temperature" : field;
  SurfaceFrame frame = readSurfaceFrame(file.string(),
                                        [&](const std::string& n) { return n == name || n == "velocity"; });
  const CutComponents cuts = unwrapComponents(frame, style.sides);
  drawSpray(file, style.spray, frame);
  CutSides cut = closeCutSides(frame, cuts, style.sides);
  FrameView view;
  view.cutAxes = std::move(cut.axes);
  view.faces = std::move(cut.faces);
  view.sides = style.sides;
  view.time = frame.time;
  view.positions = inSinglePrecision(frame.positions);
  view.normals = std::move(frame.normals);
  view.radii = std::move(frame.radii);
  view.colours = std::move(frame.colours);
  for (const std::uint64_t c : frame.components)
    view.components.push_back(static_cast<std::uint32_t>(c ^ c >> 32));
  view.paint = field.empty()        ? SurfelPaint::Plain
               : field == "surface" ? SurfelPaint::Surface
               : field == "glow"    ? SurfelPaint::Glow
                                    : SurfelPaint::Values;
  if (!alone && !frame.find(name)) return view;
  if (view.paint == SurfelPaint::Values || view.paint == SurfelPaint::Glow)
    setValues(view, frame.find(name), file, field, "; and surface, glow");
  return view;
}

/// Adds the sheets of a frame to a view of surfels.
void addSheets(const fs::path& file, const std::string& field, FrameView& view) {
  const std::string name = field == "speed" ? "velocity" : field == "glow" ? "temperature" : field;
  const FrameData data = readFrame(file.string(),
                                   [&](const std::string& n) { return n == name || n == "color"; });
  const std::vector<Vec3f> positions = inSinglePrecision(data.positions);
  std::vector<float> values;
  if (const FrameColumn* column = data.find(name)) {
    if (view.unit.empty()) view.unit = column->unit;
    view.whole = isWhole(*column);
    for (std::size_t i = 0; i < positions.size(); i++) values.push_back(lengthOfRow(*column, i));
  }
  std::vector<Rgb> colours(positions.size(), Rgb{200, 200, 200});
  if (const FrameColumn* column = data.find("color"); column && column->components == 3)
    for (std::size_t i = 0; i < colours.size(); i++) {
      const auto byte = [&](int c) {
        return static_cast<std::uint8_t>(std::clamp(column->value(i, c), 0.0, 255.0));
      };
      colours[i] = {byte(0), byte(1), byte(2)};
    }
  view.time = data.time;
  addMeshFaces({positions, data.triangles, values, colours}, view);
}

/// Returns the paint for several body types: values if any exist, else own colours.
SurfelPaint paintOf(const FrameView& view, const std::string& field) {
  if (field == "glow") return SurfelPaint::Glow;
  for (const float v : view.values)
    if (!std::isnan(v)) return SurfelPaint::Mixed;
  return SurfelPaint::Surface;
}

/// Reads particles. spacing: m; 0: unknown, and all are drawn at one size.
FrameView particleView(const fs::path& frame, const std::string& field, bool alone, double spacing) {
  const std::string name = field == "speed" ? "velocity" : field;
  const FrameData data = readFrame(frame.string(),
                                   [&](const std::string& n) { return n == name || n == "volume"; });
  FrameView view;
  view.time = data.time;
  view.positions = inSinglePrecision(data.positions);
  if (const FrameColumn* volume = data.find("volume"); volume && spacing > 0)
    for (std::size_t i = 0; i < view.positions.size(); i++)
      view.sizes.push_back(static_cast<float>(std::cbrt(volume->value(i)) / spacing));
  if (!field.empty() && (alone || data.find(name))) setValues(view, data.find(name), frame, field, "");
  return view;
}

}  // namespace

FrameView readFrameView(const fs::path& frame, const std::string& field, const PeriodicSides& sides,
                        const SprayStyle& spray) {
  const ViewStyle style{OrientedLook::Mesh, 0, sides, spray};
  const std::string kind = bodyTypeOfFrame(frame);
  if (kind == "sheet") {
    FrameView view;
    addSheets(frame, field, view);
    view.paint = paintOf(view, field);
    return view;
  }
  const bool surfels = isSurfaceFrame(readFrameInfo(frame.string()));
  const fs::path sheets = companionOf(frame, "sheet");
  if (sheets.empty())
    return surfels ? surfaceView(frame, field, style, true) : particleView(frame, field, true, spray.spacing);
  FrameView view = surfels ? surfaceView(frame, field, style, false)
                           : particleView(frame, field, false, spray.spacing);
  if (!surfels && !view.positions.empty()) {
    const StoredScene scene = storedSceneOf(frame);
    spheresToDiscs(view, static_cast<float>(0.6 * sceneOfText(scene.text, scene.name).spacing));
  }
  extendArrays(view);
  addSheets(sheets, field, view);
  view.paint = paintOf(view, field);
  return view;
}

FrameView readFullView(const fs::path& frame, const std::string& field, const ViewStyle& style) {
  const FrameInfo info = readFrameInfo(frame.string());
  if (isOrientedFrame(info)) {
    FrameView view;
    view.time = info.time;
    addOriented(view, frame, style.look);
    return view;
  }
  // a scene without particles has no field to colour by
  FrameView view = readFrameView(frame, info.count > 0 || drawnAsSurface(frame) ? field : std::string(),
                                 style.sides, style.spray);
  if (const fs::path oriented = companionOf(frame, "oriented"); !oriented.empty())
    addOrientedBeside(view, oriented, style.look, style.spacing);
  return view;
}

StoredScene storedSceneOf(const fs::path& frame) {
  FrameData data = readFrame(frame.string(), [](const std::string&) { return false; });
  return {std::move(data.sceneName), std::move(data.sceneText)};
}

}  // namespace thaw
