// SPDX-License-Identifier: Apache-2.0
#include "io/commands/preview.hpp"

#include <fmt/format.h>
#include <stdlib.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

#include "core/geometry/basic/signed_distance.hpp"
#include "io/hdf5/io_error.hpp"
#include "io/hdf5/make_folder.hpp"
#include "io/image/text.hpp"
#include "io/render/draw_lines.hpp"
#include "io/render/frame_source.hpp"
#include "io/render/scene_job.hpp"
#include "io/render/scene_marks.hpp"
#include "io/scene/scene_for_all.hpp"
#include "io/simulation/simulation.hpp"
#include "io/text/command_error.hpp"
#include "io/text/png_name.hpp"
#include "io/view/page/export_page.hpp"
#include "io/view/page/page_file.hpp"

namespace fs = std::filesystem;

namespace thaw {
namespace {

constexpr std::uint64_t mostBytes = 100'000'000;  // largest size of a page

/// A temporary folder that is removed with the object.
struct TemporaryFolder {
  fs::path path;
  TemporaryFolder() {
    std::string name = (fs::temp_directory_path() / "thaw-preview-XXXXXX").string();
    if (!mkdtemp(name.data())) throw IoError(name, "cannot be created");
    path = name;
  }
  ~TemporaryFolder() {
    std::error_code error;
    fs::remove_all(path, error);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
};

Rgb colourOf(MarkKind kind) {
  switch (kind) {
    case MarkKind::Emitter: return {47, 120, 190};
    case MarkKind::Clamp: return {190, 70, 60};
    case MarkKind::Domain: return {120, 130, 140};
    case MarkKind::Camera: return {217, 130, 43};
  }
  return {};
}

/// A text at a position.
struct Label {
  Vec3d place;
  std::string text;
  Rgb colour;
};

/// Parts of a preview other than the points of the frame.
struct Preview {
  std::vector<Mark> marks;
  std::vector<Label> labels;
  ViewBox content;  ///< m, bodies, bounded obstacles, emitters
};

Vec3d topOf(const ViewBox& box) { return {box.centre().x, box.centre().y, box.max.z}; }

ViewBox boxOf(const Bounds& bounds) {
  ViewBox box;
  if (std::isfinite(length(bounds.max - bounds.min))) box.add(bounds.min), box.add(bounds.max);
  return box;
}

ViewBox boxOf(const Mark& mark) {
  ViewBox box;
  for (const auto& line : mark.lines) box.add(line[0]), box.add(line[1]);
  return box;
}

void addBox(Preview& preview, const ViewBox& box, const std::string& text, Rgb colour) {
  if (box.empty()) return;
  preview.content.add(box.min), preview.content.add(box.max);
  if (!text.empty()) preview.labels.push_back({topOf(box), text, colour});
}

Preview previewOf(const Scene& scene) {
  Preview preview;
  const Rgb ink{40, 44, 52};
  const MeshLoader load = meshLoader();
  for (const Body& body : scene.bodies)
    addBox(preview, boxOf(makeSignedDistance(body.shape, load)->bounds()), body.name, ink);
  for (const Obstacle& obstacle : scene.obstacles)
    addBox(preview, boxOf(makeSignedDistance(obstacle.shape, load)->bounds()), obstacle.name, {90, 98, 108});
  for (Mark& mark : sceneMarks(scene)) {
    if (mark.kind == MarkKind::Emitter) addBox(preview, boxOf(mark), mark.name, colourOf(mark.kind));
    if (mark.kind == MarkKind::Camera)
      preview.labels.push_back({mark.lines[0][0], "camera", colourOf(mark.kind)});
    if (mark.kind == MarkKind::Clamp && !mark.lines.empty())
      preview.labels.push_back({topOf(boxOf(mark)), "clamped", colourOf(mark.kind)});
    preview.marks.push_back(std::move(mark));
  }
  return preview;
}

double diagonal(const ViewBox& box) { return box.empty() ? 0 : length(box.max - box.min); }

/// Returns whether the picture shows the camera. Without it, its lines would cross the picture from outside.
bool showsCamera(const Mark& camera, const View& view, const Image& image) {
  float x = 0, y = 0;
  return !camera.lines.empty() && view.project(single(camera.lines[0][0]), x, y) > 0 && x >= 0 && y >= 0 &&
         x < static_cast<float>(image.width) && y < static_cast<float>(image.height);
}

std::vector<DrawnLine> linesOf(const Preview& preview, const View& view, const Image& image, float unit) {
  std::vector<DrawnLine> lines;
  for (const Mark& mark : preview.marks) {
    if (mark.kind == MarkKind::Camera && !showsCamera(mark, view, image)) continue;
    const float width = (mark.kind == MarkKind::Domain ? 1.0f : 2.0f) * unit;
    for (const auto& line : mark.lines) lines.push_back({line[0], line[1], colourOf(mark.kind), width});
  }
  return lines;
}

void drawLabels(const Preview& preview, const View& view, Image& image) {
  const double height = std::max(9.0, 0.013 * image.height);
  for (const Label& label : preview.labels) {
    float x = 0, y = 0;
    if (view.project(single(label.place), x, y) <= 0) continue;
    drawText(image, x, y - 0.8 * height, label.text, {height, label.colour, Align::Centre});
  }
}

/// Draws marks and names over a picture. points: the points of the picture.
void drawOver(const Preview& preview, const FrameView& points, const RenderStyle& style, Image& image) {
  const View view = viewOf(style.camera, image.width, image.height);
  const float unit = std::max(1.0f, static_cast<float>(image.height) / 960.0f);
  drawLines(linesOf(preview, view, image, unit), view, pointDepths(points, view, image, 0.6f * style.spacing),
            image);
  drawLabels(preview, view, image);
}

/// Returns the box that the picture shows: the domain unless it is much larger than its contents, and the
/// camera unless it is far away.
ViewBox stageOf(const Scene& scene, const Preview& preview) {
  ViewBox domain, box = preview.content;
  domain.add(scene.domain.min), domain.add(scene.domain.max);
  if (box.empty() || diagonal(domain) < 4 * diagonal(box)) box = domain;
  else {
    const Vec3d margin = 0.1 * (box.max - box.min);
    box.add(box.min - margin), box.add(box.max + margin);
  }
  for (const Mark& mark : preview.marks) {
    if (mark.kind != MarkKind::Camera) continue;
    const ViewBox camera = boxOf(mark);
    ViewBox both = box;
    both.add(camera.min), both.add(camera.max);
    if (diagonal(both) < 1.6 * diagonal(box)) box = both;
  }
  return box;
}

/// Returns a camera that shows the box. Its position is mirrored in x if the scene's camera would be in the
/// way.
Camera overviewOf(const Camera& own, const ViewBox& stage, double aspect) {
  Camera camera = fittedCamera(stage, aspect);
  const Vec3d sight = camera.at - camera.from;
  if (!own.fitted && dot(normalized(own.at - own.from), normalized(sight)) > 0.9)
    camera.from.x = 2 * camera.at.x - camera.from.x;
  return camera;
}

/// Returns the frames at the start, of the first type that the scene has.
std::vector<fs::path> firstFrames(const fs::path& run) {
  for (const FrameKind kind :
       {FrameKind::Automatic, FrameKind::Particles, FrameKind::Oriented, FrameKind::Sheet})
    try {
      return findFrames(run, kind);
    } catch (const IoError&) {  // try the next type
    }
  throw IoError(run.string(), "has no frames");
}

/// Removes the values of a uniform field, whose colour bar would be meaningless.
void removeUniform(FrameView& view) {
  float low = std::numeric_limits<float>::max(), high = std::numeric_limits<float>::lowest();
  for (const float v : view.values)
    if (std::isfinite(v)) low = std::min(low, v), high = std::max(high, v);
  if (low < high) return;
  if (view.normals.empty()) view.values.clear();
  else std::fill(view.values.begin(), view.values.end(), std::numeric_limits<float>::quiet_NaN());
}

/// Returns whether a preview shows the colours of the surface, since fields are nearly uniform at the start.
bool ownColours(const Scene& scene) {
  return scene.surface.on && !scene.output.colourMin && !scene.output.colourMax;
}

void drawPicture(const Scene& scene, const fs::path& run, const PreviewOptions& options,
                 const fs::path& file) {
  const Preview preview = previewOf(scene);
  FrameJob job = jobOfScene(scene);
  job.frames = firstFrames(run);
  job.out = run / "pictures";
  if (options.width > 0) job.width = options.width;
  if (options.height > 0) job.height = options.height;
  if (ownColours(scene)) job.field = "surface";
  const ViewBox stage = stageOf(scene, preview);
  if (!options.through)
    job.camera = overviewOf(scene.output.camera, stage, static_cast<double>(job.width) / job.height);
  FrameView points;
  job.over = [&](Image& image, const RenderStyle& style) { drawOver(preview, points, style, image); };
  const auto written = renderFrames(job, [&](const fs::path& frame, const std::string& field) {
    points = readFullView(frame, field, {OrientedLook::Mesh, job.spacing, job.periodic, {}});
    if (!job.min && !job.max) removeUniform(points);
    return points;
  });
  makeFolder(file.parent_path());
  std::error_code error;
  if (!fs::copy_file(written.front(), file, fs::copy_options::overwrite_existing, error) || error)
    throw IoError(file.string(), "cannot be written: " + error.message());
  fmt::print("{}\n", file.string());
}

/// Writes the page. own: with the colours of the surface.
void writePage(const fs::path& run, const fs::path& file, bool own) {
  PageExport page;
  page.run = run;
  page.file = file;
  page.budget = mostBytes;
  page.preview = true;
  if (own) page.look["colour"] = "surface";
  page.say = [](const std::string& line) { fmt::print("{}\n", line); };
  exportPage(page);
}

void preview(const PreviewOptions& options) {
  const TemporaryFolder folder;
  const fs::path run = folder.path / "run";
  RunOptions start;
  start.scene = options.scene;
  start.out = run.string();
  start.overrides = options.overrides;
  const Simulation sim(start);  // writes the first frames
  for (const std::string& warning : sim.warnings()) fmt::print(stderr, "warning: {}\n", warning);
  fs::path picture = options.out;
  if (picture.empty() && options.html.empty())
    picture = fs::path(options.scene).stem().string() + "_preview.png";
  if (!picture.empty()) drawPicture(sim.scene(), run, options, picture);
  if (!options.html.empty()) writePage(run, options.html, ownColours(sim.scene()));
}

}  // namespace

void addPreviewOptions(CLI::App& command, PreviewOptions& o) {
  command.add_option("scene", o.scene, "scene file (TOML)")->required();
  command.add_option("--set", o.overrides, "override a key of the scene: key=value; may be repeated")
      ->allow_extra_args(false);
  command
      .add_option("--out", o.out,
                  "file of the picture (PNG) (default: NAME_preview.png; none with --html alone)")
      ->check(pngName());
  command.add_option("--html", o.html, "write an interactive page for the browser to this file");
  command.add_flag("--through", o.through, "show what the scene's camera sees, not the whole domain");
  command.add_option("--width", o.width, "pixels (default: the scene's)")->check(CLI::Range(16, 16384));
  command.add_option("--height", o.height, "pixels")->check(CLI::Range(16, 16384));
}

int previewCommand(const PreviewOptions& options) {
  int rank = 0, ranks = 1;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  MPI_Comm_size(MPI_COMM_WORLD, &ranks);
  const auto failed = [rank](const std::string& message, int code) {
    if (rank == 0) fmt::print(stderr, "{}\n", message);
    return code;
  };
  if (ranks > 1)
    return failed(commandError("preview", "expected one rank: start it without mpirun"), exitUsage);
  if (!options.html.empty())
    if (const std::string problem = pageProblem(); !problem.empty())
      return failed(commandError("preview", problem), exitUsage);
  try {
    preview(options);
    return exitDone;
  } catch (const std::exception& e) {
    if (const auto refusal = refusalOf(e)) return failed(refusal->message, refusal->code);
    return failed(commandError("preview", options.scene + ": " + e.what()), exitInputOutput);
  }
}

}  // namespace thaw
