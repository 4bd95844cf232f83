// SPDX-License-Identifier: Apache-2.0
#include "io/commands/export.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <optional>
#include <set>
#include <stdexcept>
#include <thread>

#include "core/oriented/mesh/manifold.hpp"
#include "io/export/export_surface.hpp"
#include "io/frames/read_oriented_frame.hpp"
#include "io/frames/rows_by_id.hpp"
#include "io/hdf5/io_error.hpp"
#include "io/render/frame_source.hpp"
#include "io/render/image/parallel_for.hpp"
#include "io/render/scene_job.hpp"

namespace thaw {

namespace fs = std::filesystem;

namespace {

const std::vector<std::string> formats{"ply-discs", "pov", "vtp", "ply", "obj"};

std::string extensionOf(const std::string& as) { return as == "ply-discs" ? ".discs.ply" : "." + as; }

/// Returns one colour per surfel. Throws IoError for an unknown field.
std::vector<Rgb> coloursOf(const SurfaceFrame& frame, const ExportOptions& options, const fs::path& file) {
  if (options.field == "surface") return frame.colours;
  const FrameColumn* column = frame.find(options.field);
  if (!column || column->components != 1) {
    std::string names = "surface";
    for (const FrameColumn& c : frame.columns)
      if (c.components == 1) names += ", " + c.name;
    throw IoError(file.string(), "has no field '" + options.field + "' for the colours; there are: " + names);
  }
  double low = INFINITY, high = -INFINITY;
  for (std::size_t i = 0; i < frame.positions.size(); i++)
    if (const double v = column->value(i); std::isfinite(v)) low = std::min(low, v), high = std::max(high, v);
  const ColourScale scale{
      options.min.value_or(low), options.max.value_or(high), colourMapNamed(options.map), {}, {}};
  const Palette palette = paletteOf(scale.map);
  std::vector<Rgb> colours(frame.positions.size());
  for (std::size_t i = 0; i < colours.size(); i++)
    colours[i] = palette[static_cast<std::size_t>(paletteIndex(scale, column->value(i)))];
  return colours;
}

/// Returns the scene that a frame stores, or nothing if there is none. A scene that cannot be read gives a
/// note and nothing.
std::optional<Scene> sceneOf(const SurfaceFrame& frame, const fs::path& file, const char* what) {
  if (frame.sceneText.empty()) return {};
  try {
    return sceneOfText(frame.sceneText, frame.sceneName);
  } catch (const std::exception& error) {
    fmt::print(stderr, "thaw export: the scene in {} is not used for {}: {}\n", file.string(), what,
               error.what());
    return {};
  }
}

/// Returns camera, picture size and walls, as `thaw render` uses them.
RenderStyle styleOf(const SurfaceFrame& frame, const fs::path& file) {
  RenderStyle style;
  FrameJob job;
  if (const auto scene = sceneOf(frame, file, "the camera")) try {
      job = jobOfScene(*scene);
    } catch (const std::exception& error) {
      fmt::print(stderr, "thaw export: the scene in {} is not used for the camera: {}\n", file.string(),
                 error.what());
    }
  std::vector<Vec3f> places;
  for (const Vec3d& x : frame.positions)
    places.push_back({static_cast<float>(x.x), static_cast<float>(x.y), static_cast<float>(x.z)});
  style.width = job.width;
  style.height = job.height;
  style.stage = robustBox(places);
  style.camera = job.camera ? *job.camera
                            : fittedCamera(style.stage, static_cast<double>(job.width) / job.height);
  addWalls(job.walls, frame.time, style);
  return style;
}

struct MeshCount {
  std::size_t components = 0, empty = 0, triangles = 0;
};

MeshCount writeMesh(const fs::path& file, const fs::path& out, const SurfaceFrame& frame,
                    const std::vector<Rgb>& colours, const ExportOptions& options) {
  const std::vector<ComponentRows> components = rowsByComponent(frame);
  std::vector<ComponentMesh> meshes(components.size());
  const int threads = options.threads > 0
                          ? options.threads
                          : static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
  const auto scene = sceneOf(frame, file, "periodic sides");
  const PeriodicSides sides = scene ? periodicSidesOf(scene->domain) : PeriodicSides{};
  parallelFor(components.size(), threads, [&](std::size_t c) {
    meshes[c] = meshOfComponent(frame, components[c], colours, sides, options.cell);
  });
  MeshCount count{meshes.size(), 0, 0};
  count.empty = static_cast<std::size_t>(
      std::erase_if(meshes, [](const ComponentMesh& m) { return m.mesh.triangles.empty(); }));
  for (const ComponentMesh& m : meshes) count.triangles += m.mesh.triangles.size();
  (options.as == "ply" ? writeMeshPly : writeMeshObj)(out, meshes);
  std::size_t finer = 0;
  for (const ComponentMesh& m : meshes) {
    finer += m.edge < m.asked;
    if (const std::string note = cutNote(m); !note.empty()) fmt::print("component {}{}\n", m.component, note);
  }
  if (options.cell > 1 && finer > 0)
    fmt::print(stderr,
               "thaw export: warning: {}: --cell {:g}: cubes of {:.3g} m are too wide for {} of {} "
               "components, which use finer ones; 0.5 to 2 is recommended\n",
               file.string(), options.cell, meshes[0].asked, finer, meshes.size());
  return count;
}

/// Mesh of oriented particles: triangles of the smallest-sphere test, and lines of groups without triangles.
/// used: 1 for particles of a triangle or line.
struct OrientedMesh {
  std::vector<Corners> triangles;
  std::vector<std::array<std::uint32_t, 2>> lines;
  std::vector<std::uint8_t> used;
  explicit OrientedMesh(const OrientedFrame& frame)
      : triangles(triangulate(frame.points())), used(frame.positions.size(), 0) {
    std::set<std::uint32_t> meshed;
    for (const Corners& t : triangles) meshed.insert(frame.groups[t[0]]);
    std::vector<std::uint8_t> withoutTriangles;
    for (const std::uint32_t group : frame.groups) withoutTriangles.push_back(!meshed.contains(group));
    lines = joinLines(frame.points(), withoutTriangles);
    for (const Corners& t : triangles)
      for (const std::uint32_t v : t) used[v] = 1;
    for (const auto& l : lines)
      for (const std::uint32_t v : l) used[v] = 1;
  }
};

std::vector<ComponentMesh> meshesOf(const OrientedFrame& frame, const OrientedMesh& made) {
  std::map<std::uint32_t, ComponentMesh> byGroup;
  std::vector<std::uint32_t> vertexOf(frame.positions.size());
  for (std::uint32_t i = 0; i < frame.positions.size(); i++) {
    if (!made.used[i]) continue;
    ComponentMesh& m = byGroup[frame.groups[i]];
    m.component = frame.groups[i];
    vertexOf[i] = static_cast<std::uint32_t>(m.mesh.vertices.size());
    const Vec3d n = frame.normals[i];
    m.mesh.vertices.push_back(frame.positions[i]);
    m.normals.push_back({static_cast<float>(n.x), static_cast<float>(n.y), static_cast<float>(n.z)});
    const auto& c = frame.colours[i];
    m.colours.push_back({static_cast<float>(c[0]), static_cast<float>(c[1]), static_cast<float>(c[2])});
    if (!frame.ids.empty()) m.ids.push_back(frame.ids[i]);
  }
  for (const Corners& t : made.triangles)
    byGroup[frame.groups[t[0]]].mesh.triangles.push_back({vertexOf[t[0]], vertexOf[t[1]], vertexOf[t[2]]});
  for (const auto& l : made.lines)
    byGroup[frame.groups[l[0]]].lines.push_back({vertexOf[l[0]], vertexOf[l[1]]});
  std::vector<ComponentMesh> meshes;
  for (auto& [group, mesh] : byGroup) meshes.push_back(std::move(mesh));
  return meshes;
}

/// Returns a note on particles without triangle and line: their number and the first id. Empty without such
/// particles.
std::string aloneText(const OrientedFrame& frame, const std::vector<std::uint8_t>& used) {
  const auto alone = std::count(used.begin(), used.end(), std::uint8_t{0});
  if (alone == 0) return "";
  const std::uint64_t first = frame.ids.empty()
                                  ? 0
                                  : frame.ids[static_cast<std::size_t>(
                                        std::find(used.begin(), used.end(), std::uint8_t{0}) - used.begin())];
  return alone == 1 ? fmt::format(
                          "; 1 particle (id {}) has no triangle or line: all others are further than twice "
                          "its spacing",
                          first)
                    : fmt::format(
                          "; {} particles (the first: id {}) have no triangle or line: all others are "
                          "further than twice their spacing",
                          alone, first);
}

void exportOriented(const fs::path& file, const fs::path& out, const ExportOptions& options) {
  if (options.as != "ply" && options.as != "obj" && options.as != "vtp")
    throw std::invalid_argument("oriented particles are exported as ply, obj or vtp, not as " + options.as);
  FrameData all = readFrame(file.string());
  orderById(all);
  const OrientedFrame frame = orientedFrameOf(all, file.string());
  const OrientedMesh made(frame);
  if (out.has_parent_path()) fs::create_directories(out.parent_path());
  if (options.as == "vtp") {
    all.triangles = made.triangles;
    writeTrianglesVtp(out, all, made.lines);
  } else {
    (options.as == "ply" ? writeMeshPly : writeMeshObj)(out, meshesOf(frame, made));
  }
  fmt::print("{}: {} particles, {} triangles, {} lines (curves){}\n", out.string(), frame.positions.size(),
             made.triangles.size(), made.lines.size(), aloneText(frame, made.used));
}

bool isSheetFrame(const FrameInfo& info) {
  return std::any_of(info.fields.begin(), info.fields.end(),
                     [](const FrameInfo::Field& f) { return f.name == "sheet_body"; });
}

/// Writes the triangles of a frame, one mesh per sheet, with its colours. Vertex normals are area-weighted
/// means over the adjacent triangles.
void exportSheets(const fs::path& file, const fs::path& out, const ExportOptions& options) {
  if (options.as != "ply" && options.as != "obj" && options.as != "vtp")
    throw std::invalid_argument("sheets are exported as ply, obj or vtp, not as " + options.as);
  FrameData frame = readFrame(file.string());
  orderById(frame);  // the same order in all frames, for animations
  const std::vector<std::uint64_t> ids = idsOf(frame);
  if (options.as == "vtp") {
    if (out.has_parent_path()) fs::create_directories(out.parent_path());
    writeTrianglesVtp(out, frame);
    fmt::print("{}: {} vertices, {} triangles\n", out.string(), frame.positions.size(),
               frame.triangles.size());
    return;
  }
  const FrameColumn *body = frame.find("sheet_body"), *colour = frame.find("color");
  if (!body || !colour) throw IoError(file.string(), "has no fields 'sheet_body' and 'color'");
  std::map<std::uint32_t, ComponentMesh> byBody;
  std::vector<std::uint32_t> vertexOf(frame.positions.size());
  for (std::size_t i = 0; i < frame.positions.size(); i++) {
    ComponentMesh& m = byBody[static_cast<std::uint32_t>(body->value(i))];
    vertexOf[i] = static_cast<std::uint32_t>(m.mesh.vertices.size());
    m.mesh.vertices.push_back(frame.positions[i]);
    m.normals.push_back({});
    if (!ids.empty()) m.ids.push_back(ids[i]);
    m.colours.push_back({static_cast<float>(colour->value(i, 0)), static_cast<float>(colour->value(i, 1)),
                         static_cast<float>(colour->value(i, 2))});
  }
  for (const auto& t : frame.triangles) {
    ComponentMesh& m = byBody[static_cast<std::uint32_t>(body->value(t[0]))];
    const Vec3d n = cross(frame.positions[t[1]] - frame.positions[t[0]],
                          frame.positions[t[2]] - frame.positions[t[0]]);
    for (const std::uint32_t k : t)
      m.normals[vertexOf[k]] += Vec3f{static_cast<float>(n.x), static_cast<float>(n.y),
                                      static_cast<float>(n.z)};
    m.mesh.triangles.push_back({vertexOf[t[0]], vertexOf[t[1]], vertexOf[t[2]]});
  }
  std::vector<ComponentMesh> meshes;
  for (auto& [number, m] : byBody) {
    m.component = number;
    for (Vec3f& n : m.normals) n = dot(n, n) > 0 ? n * (1 / std::sqrt(dot(n, n))) : Vec3f{0, 0, 1};
    meshes.push_back(std::move(m));
  }
  if (out.has_parent_path()) fs::create_directories(out.parent_path());
  (options.as == "ply" ? writeMeshPly : writeMeshObj)(out, meshes);
  fmt::print("{}: {} vertices, {} {}, {} triangles\n", out.string(), frame.positions.size(), meshes.size(),
             meshes.size() == 1 ? "sheet" : "sheets", frame.triangles.size());
}

void exportFrame(const fs::path& file, const fs::path& out, const ExportOptions& options) {
  const FrameInfo info = readFrameInfo(file.string());
  if ((isOrientedFrame(info) || isSheetFrame(info)) && options.field != "surface")
    throw std::invalid_argument(
        "sheets and oriented particles are exported in their own colours, --as vtp with all fields: expected "
        "no --field, got " +
        options.field);
  if (isOrientedFrame(info)) return exportOriented(file, out, options);
  if (isSheetFrame(info)) return exportSheets(file, out, options);
  const SurfaceFrame frame = readSurfaceFrame(file.string());
  const std::vector<Rgb> colours = coloursOf(frame, options, file);
  if (out.has_parent_path()) fs::create_directories(out.parent_path());
  std::string more = fmt::format("{} surfels", frame.positions.size());
  if (options.as == "ply-discs") writePlyDiscs(out, frame, colours);
  else if (options.as == "vtp") writeVtp(out, frame, colours);
  else if (options.as == "pov") writePov(out, frame, colours, styleOf(frame, file));
  else {
    const MeshCount count = writeMesh(file, out, frame, colours, options);
    more = fmt::format("{} component{}, {} triangles", count.components - count.empty,
                       count.components - count.empty == 1 ? "" : "s", count.triangles);
    if (count.empty > 0) more += fmt::format("; {} components enclose nothing and are left out", count.empty);
  }
  fmt::print("{}: {}\n", out.string(), more);
}

/// Returns export/ in the run folder. The input is that folder, its frames/ or a file in there.
fs::path exportFolder(const fs::path& input) {
  fs::path folder = fs::is_directory(input) ? input : input.parent_path();
  if (folder.filename().empty() && folder.has_parent_path()) folder = folder.parent_path();  // "run/"
  if (folder.filename() == "frames") folder = folder.parent_path();
  return folder / "export";
}

/// Returns the frames of the requested kind, by default of the first kind that the run has.
std::vector<fs::path> framesToExport(const ExportOptions& options) {
  if (options.what == "oriented") return findFrames(options.input, FrameKind::Oriented);
  if (options.what == "sheet") return findFrames(options.input, FrameKind::Sheet);
  try {
    return findFrames(options.input, FrameKind::Surface);
  } catch (const IoError&) {
    if (!options.what.empty() || !fs::is_directory(options.input)) throw;
    for (const FrameKind kind : {FrameKind::Oriented, FrameKind::Sheet}) try {
        return findFrames(options.input, kind);
      } catch (const IoError&) {  // the error about the surface is thrown instead
      }
    throw;
  }
}

}  // namespace

void addExportOptions(CLI::App& command, ExportOptions& o) {
  command
      .add_option("path", o.input,
                  "frame of a surface, of oriented particles or of sheets (NAME_surface_000120.hdf, "
                  "NAME_oriented_..., NAME_sheet_...), series index, or run folder (all its frames)")
      ->required();
  command
      .add_option("--as", o.as,
                  "ply-discs: a polygon for each surfel (Blender); pov: a scene of POV-Ray; vtp: points with "
                  "all fields, and the triangles of sheets and oriented particles (ParaView); ply, obj: a "
                  "closed triangle mesh of each component, or the triangles of each sheet or oriented "
                  "surface, and the lines of a curve")
      ->required()
      ->check(CLI::IsMember(formats));
  command
      .add_option(
          "--what", o.what,
          "kind of frames in a folder: surface (surfels), oriented (oriented particles) or sheet (sheets), "
          "the latter two as ply, obj or vtp (default: the first of these that the run has)")
      ->check(CLI::IsMember({"surface", "oriented", "sheet"}));
  command.add_option("--out", o.out,
                     "file for one frame, folder for several (default: export/ in the run's folder)");
  command
      .add_option("--field", o.field,
                  "source of the colours: surface (its own colours) or a field: temperature, liquid, detail")
      ->capture_default_str();
  command.add_option("--map", o.map, "colour map of a field: ember, sea, grey")->capture_default_str();
  command.add_option("--min", o.min,
                     "lowest value of the colour scale, SI (default: the lowest of the frame)");
  command.add_option("--max", o.max, "highest value of the colour scale, SI");
  command
      .add_option("--cell", o.cell, "edge of the cubes of the mesh grid, over the mean radius of the surfels")
      ->check(CLI::Range(0.2, 10.0))
      ->capture_default_str();
  command.add_option("--threads", o.threads, "threads for the meshes of components (default: one per core)")
      ->check(CLI::Range(0, 4096));
}

int exportCommand(const ExportOptions& options) {
  try {
    if (std::find(formats.begin(), formats.end(), options.as) == formats.end())
      throw std::invalid_argument("there is no format '" + options.as + "'");
    if (options.min && options.max && !(*options.max > *options.min))
      throw std::invalid_argument("the range of the colours is empty: --max must be above --min");
    colourMapNamed(options.map);
    const std::vector<fs::path> frames = framesToExport(options);
    const bool one = frames.size() == 1 && !fs::is_directory(options.out) && options.out.has_extension();
    const fs::path folder = options.out.empty() ? exportFolder(options.input) : options.out;
    for (const fs::path& frame : frames)
      exportFrame(frame, one ? options.out : folder / (frame.stem().string() + extensionOf(options.as)),
                  options);
    return 0;
  } catch (const std::invalid_argument& error) {
    fmt::print(stderr, "thaw export: {}\n", error.what());
    return 2;
  } catch (const std::bad_alloc&) {
    fmt::print(stderr, "thaw export: {}: not enough memory\n", options.input.string());
    return exitInputOutput;
  } catch (const std::runtime_error& error) {  // IoError or a file system error
    fmt::print(stderr, "thaw export: {}\n", error.what());
    return exitInputOutput;
  }
}

}  // namespace thaw
