// SPDX-License-Identifier: Apache-2.0
#include "io/commands/render.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <numbers>
#include <stdexcept>

#include "io/frames/read_surface_frame.hpp"
#include "io/hdf5/io_error.hpp"
#include "io/render/frame_source.hpp"
#include "io/render/movie.hpp"
#include "io/render/scene_job.hpp"
#include "io/text/command_error.hpp"
#include "io/text/number_options.hpp"
#include "io/text/png_name.hpp"

namespace thaw {

namespace fs = std::filesystem;

namespace {

Vec3d vectorOf(const std::vector<double>& v) { return {v.at(0), v.at(1), v.at(2)}; }

/// Returns the requested field, else the scene's if the frames have it, else a default.
std::string fieldFor(const RenderOptions& options, const std::string& ofScene,
                     const std::vector<std::string>& fields, bool surface) {
  if (options.field == "none") return {};
  if (!options.field.empty()) return options.field;
  const auto has = [&](const std::string& name) {
    return std::find(fields.begin(), fields.end(), name == "speed" ? "velocity" : name) != fields.end();
  };
  if (surface && (ofScene == "surface" || (ofScene == "glow" && has("temperature")))) return ofScene;
  for (const std::string& name : {ofScene, std::string("temperature"), std::string(surface ? "" : "speed")})
    if (!name.empty() && has(name)) return name;
  return surface ? "surface" : "";
}

/// Refuses a field that the frame lacks, also for sheets and oriented particles, which have own colours.
void refuseUnknownField(const std::string& field, const fs::path& frame,
                        const std::vector<std::string>& fields) {
  const bool surface = drawnAsSurface(frame);
  if (field.empty() || field == "none" || (surface && (field == "surface" || field == "glow"))) return;
  if (std::find(fields.begin(), fields.end(), field == "speed" ? "velocity" : field) != fields.end()) return;
  std::string names;
  for (const std::string& name : fields) names += (names.empty() ? "" : ", ") + name;
  throw IoError(frame.string(),
                "has no field '" + field + "'; there are: " + names + (surface ? ", surface, glow" : ""));
}

/// Returns pictures/ in the run folder. The input is that folder, its frames/ or a file in there.
fs::path picturesFolder(const fs::path& input) {
  fs::path folder = fs::is_directory(input) ? input : input.parent_path();
  if (folder.filename().empty() && folder.has_parent_path()) folder = folder.parent_path();  // "run/"
  if (folder.filename() == "frames") folder = folder.parent_path();
  return folder / "pictures";
}

void setCamera(const RenderOptions& options, FrameJob& job) {
  if (options.fit) job.camera.reset();
  if (options.from.empty() != options.at.empty())
    throw std::invalid_argument("--from and --at must be given together");
  if (!options.from.empty()) {
    Camera camera = job.camera.value_or(Camera{});
    camera.fitted = false;
    camera.from = vectorOf(options.from);
    camera.at = vectorOf(options.at);
    job.camera = camera;
  }
  if (options.fieldOfView > 0) {
    if (!job.camera)
      throw std::invalid_argument("--fov needs a camera: --from and --at, or one in the scene");
    job.camera->fieldOfView = options.fieldOfView * std::numbers::pi / 180;
  }
}

/// Returns the settings of the scene that the run stored. An unusable scene (an obstacle mesh is missing)
/// leaves the defaults.
FrameJob jobOfRun(const fs::path& frame) {
  const StoredScene kept = storedSceneOf(frame);
  if (kept.text.empty()) return {};
  try {
    return jobOfScene(sceneOfText(kept.text, kept.name));
  } catch (const std::exception& error) {
    fmt::print(stderr, "thaw render: warning: the scene in {} is not used for the pictures: {}\n",
               frame.string(), error.what());
    return {};
  }
}

FrameKind kindOf(const std::string& what) {
  if (what == "surface") return FrameKind::Surface;
  if (what == "particles") return FrameKind::Particles;
  if (what == "automatic") return FrameKind::Automatic;
  throw std::invalid_argument("unknown --what " + what + "; expected surface, particles or automatic");
}

/// Refuses the file of a scene, and names the commands for it.
void refuseScene(const fs::path& input) {
  if (input.extension() != ".toml") return;
  const std::string scene = input.string(), run = "out/" + input.stem().string();
  throw std::invalid_argument(
      fmt::format("{0} is a scene; use `thaw preview {0}`, or render its run {1}", scene, run));
}

FrameJob jobOf(const RenderOptions& options) {
  refuseScene(options.input);
  std::vector<fs::path> frames = findFrames(options.input, kindOf(options.what));
  if (options.latest) frames.erase(frames.begin(), frames.end() - 1);
  FrameJob job = jobOfRun(frames.back());
  job.frames = frames;
  job.out = options.out.empty() ? picturesFolder(options.input) : options.out;
  job.sheet = options.sheet;
  job.columns = options.columns;
  job.cells = options.cells;
  const std::vector<std::string> fields = fieldsOf(frames.back());
  refuseUnknownField(options.field, frames.back(), fields);
  // The default field is one that all drawn frames have: a surface has fewer fields than sheets.
  const bool surfels = isSurfaceFrame(readFrameInfo(frames.back().string()));
  job.field = fieldFor(options, job.field, fieldsOf(frames.back(), !surfels), drawnAsSurface(frames.back()));
  if (options.min) job.min = options.min;
  if (options.max) job.max = options.max;
  if (job.min && job.max && !(*job.max > *job.min)) throw std::invalid_argument("--max must be above --min");
  job.map = colourMapNamed(options.map);
  if (options.width > 0) job.width = options.width;
  if (options.height > 0) job.height = options.height;
  job.radius = static_cast<float>(options.radius);
  job.threads = options.threads;
  if (!options.spray.empty()) job.spray = sprayNamed(options.spray);
  if (!options.obstacles) job.walls.list.clear();
  setCamera(options, job);
  return job;
}

/// Makes a movie of the pictures, or prints the command for it. Without ffmpeg the command still succeeds,
/// since the pictures are there.
void filmOf(std::vector<fs::path> pictures, const RenderOptions& options) {
  std::string name = pictures[0].stem().string();
  if (const std::size_t end = name.find_last_not_of("0123456789");
      end != std::string::npos && name[end] == '_' && end > 0)
    name.resize(end);
  const fs::path file = pictures[0].parent_path() / (name + ".mp4");
  if (makeMovie(pictures, file, options.rate)) fmt::print("{}\n", file.string());
  else
    fmt::print(
        stderr,
        "thaw render: warning: no movie: ffmpeg is not installed (Debian: apt-get install ffmpeg); with it, "
        "make one from the pictures:\n  {}\n",
        movieCommand(pictures, file, options.rate));
}

}  // namespace

void addRenderOptions(CLI::App& command, RenderOptions& o) {
  command.add_option("path", o.input, "frame (.hdf), series index (.hdf.series), or run folder")->required();
  command.add_option("--out", o.out, "folder of the pictures (default: pictures/ in the run's folder)");
  auto* latest = command.add_flag("--latest", o.latest, "only the newest frame, also of a running run");
  command.add_option("--sheet", o.sheet, "write a contact sheet (PNG) of the run to this file as well")
      ->check(pngName())
      ->excludes(latest);
  command.add_option(
      "--field", o.field,
      "field of the colours: a name, speed, or none; for surfaces also surface (its own colours) and glow "
      "(own colours that blend into those of the temperature) (default: the scene's choice)");
  command
      .add_option("--min", o.min,
                  "lowest value of the colour scale, SI (default: the scene's, or the lowest in all frames)")
      ->check(finiteNumber());
  command.add_option("--max", o.max, "highest value of the colour scale, SI")->check(finiteNumber());
  command.add_option("--map", o.map, "colour map: ember, sea, grey")->capture_default_str();
  command.add_option("--from", o.from, "position of the camera in m: x y z")
      ->expected(3)
      ->check(finiteNumber());
  command.add_option("--at", o.at, "point in m that the camera looks at: x y z")
      ->expected(3)
      ->check(finiteNumber());
  command.add_option("--fov", o.fieldOfView, "vertical field of view in degrees")
      ->check(finiteNumber())
      ->check(CLI::Range(1.0, 170.0));
  command.add_flag("--fit", o.fit, "fit the camera to the particles, instead of the scene's camera");
  command.add_flag("!--no-obstacles", o.obstacles, "do not draw obstacles and floors");
  command.add_option("--width", o.width, "pixels (default: the scene's)")->check(CLI::Range(16, 16384));
  command.add_option("--height", o.height, "pixels")->check(CLI::Range(16, 16384));
  command.add_option("--columns", o.columns, "columns of the contact sheet")
      ->check(CLI::Range(1, 100))
      ->capture_default_str();
  command.add_option("--cells", o.cells, "pictures on the contact sheet, at most")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  command
      .add_option("--radius", o.radius,
                  "radius of the spheres, in particle spacings (default 0.7), or of the surface's discs, in "
                  "their own radii (default 1.25)")
      ->check(finiteNumber())
      ->check(CLI::Range(0.01, 100.0));
  command.add_option("--what", o.what, "surface, particles, or automatic: the surface if the run has one")
      ->check(CLI::IsMember({"surface", "particles", "automatic"}))
      ->capture_default_str();
  command
      .add_option("--look", o.look,
                  "look of oriented particles: mesh (shaded triangles), wire, discs, or axes")
      ->check(CLI::IsMember({"mesh", "wire", "discs", "axes"}))
      ->capture_default_str();
  command
      .add_option(
          "--spray", o.spray,
          "drops of one and two particles of a surface: ellipsoids of their volume along their motion, "
          "spheres, hide, or surfels (default: the scene's)")
      ->check(CLI::IsMember({"ellipsoids", "spheres", "hide", "surfels"}));
  command.add_flag("--movie", o.movie, "make a movie (mp4) of the pictures as well; needs ffmpeg")
      ->excludes(latest);
  command.add_option("--rate", o.rate, "pictures per second of the movie")
      ->check(finiteNumber())
      ->check(CLI::Range(0.1, 240.0))
      ->capture_default_str();
  command.add_option("--threads", o.threads, "frames drawn at once (default: one per core)")
      ->check(CLI::Range(0, 4096));
}

int renderCommand(const RenderOptions& options) {
  try {
    const FrameJob job = jobOf(options);
    const ViewStyle style{orientedLookNamed(options.look),
                          job.spacing,
                          job.periodic,
                          {job.spray, job.spacing, 0.5 * job.interval}};
    const std::vector<fs::path> written = renderFrames(
        job, [&](const std::filesystem::path& file, const std::string& field) {
          return readFullView(file, field, style);
        });
    const std::size_t pictures = written.size() - (job.sheet.empty() ? 0 : 1);
    if (!job.sheet.empty()) fmt::print("{}\n", job.sheet.string());
    if (pictures == 1) fmt::print("{}\n", written[0].string());
    else
      fmt::print("{} to {}: {} pictures\n", written[0].string(), written[pictures - 1].filename().string(),
                 pictures);
    if (options.movie)
      filmOf({written.begin(), written.begin() + static_cast<std::ptrdiff_t>(pictures)}, options);
    return 0;
  } catch (const std::invalid_argument& error) {
    printCommandError("render", error.what());
    return 2;
  } catch (const std::bad_alloc&) {
    printCommandError("render", options.input.string() + ": not enough memory");
    return exitInputOutput;
  } catch (const fs::filesystem_error& error) {
    printCommandError("render", error.path1().string() + ": " + error.code().message());
    return exitInputOutput;
  } catch (const std::runtime_error& error) {  // IoError
    printCommandError("render", error.what());
    return exitInputOutput;
  }
}

}  // namespace thaw
