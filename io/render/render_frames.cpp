// SPDX-License-Identifier: Apache-2.0
#include "io/render/render_frames.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <mutex>
#include <stdexcept>
#include <thread>

#include "io/hdf5/make_folder.hpp"
#include "io/image/annotate.hpp"
#include "io/image/linear_light.hpp"
#include "io/image/parallel_for.hpp"
#include "io/render/light/surface_normals.hpp"
#include "io/render/obstacle_faces.hpp"

namespace thaw {

namespace {

namespace fs = std::filesystem;

/// Properties common to all pictures, from a first pass over the frames.
struct Survey {
  ViewBox box;
  double min = 1e300, max = -1e300;
  std::string unit;
  bool whole = true;  ///< all values are integers
  double lastTime = 0;
  double spacing = 0;  ///< m, estimated; used only if none is given
};

/// Estimates the spacing by the median nearest distance of some particles, for frames without it.
double guessSpacing(const std::vector<Vec3f>& positions, const ViewBox& box) {
  const Vec3d size = box.max - box.min;
  const double edge = std::cbrt(std::max(1e-18, size.x * size.y * size.z) /
                                static_cast<double>(positions.size()));
  const CellBins bins = binParticles(positions, static_cast<float>(1.5 * edge));
  std::vector<float> nearest;
  for (std::size_t i = 0; i < positions.size(); i += 1 + positions.size() / 400) {
    const float d = nearestNeighbour(positions, bins, positions[i]);
    if (std::isfinite(d)) nearest.push_back(d);
  }
  if (nearest.empty()) return edge;
  std::nth_element(nearest.begin(), nearest.begin() + static_cast<std::ptrdiff_t>(nearest.size() / 2),
                   nearest.end());
  return nearest[nearest.size() / 2];
}

Survey survey(const FrameJob& job, const ReadFrame& read) {
  Survey s;
  for (const fs::path& file : job.frames) {
    const FrameView frame = read(file, job.field);
    const ViewBox box = robustBox(frame.positions);
    if (!box.empty()) s.box.add(box.min), s.box.add(box.max);
    for (float v : frame.values)
      if (std::isfinite(v)) s.min = std::min<double>(s.min, v), s.max = std::max<double>(s.max, v);
    if (s.unit.empty()) s.unit = frame.unit;
    s.whole = s.whole && (frame.whole || frame.values.empty());
    s.lastTime = std::max(s.lastTime, frame.time);
    if (s.spacing == 0 && !box.empty() && frame.normals.empty())
      s.spacing = guessSpacing(frame.positions, box);
  }
  return s;
}

/// Returns the plane of a wall, if it is infinite and has the same normal everywhere.
std::optional<FloorHint> planeOf(const Wall& wall) {
  const Bounds box = wall.shape->bounds();
  if (std::isfinite(length(box.max - box.min))) return std::nullopt;
  Vec3d normal, other;
  const double away = wall.shape->distance({}, &normal);
  for (const Vec3d& x : {Vec3d{1e3, 0, 0}, Vec3d{-1e3, 10, 7}, Vec3d{0, -1e3, 1e3}, Vec3d{3, 4, -1e3}}) {
    wall.shape->distance(x, &other);
    if (length(other - normal) > 1e-9) return std::nullopt;
  }
  return FloorHint{wall.pose.move - away * directionFromRest(wall.pose, normal),
                   directionFromRest(wall.pose, normal)};
}

/// Formats the time with enough digits to distinguish frames.
std::string timeLabel(double time, double last) {
  const int digits = last > 0 ? std::clamp(2 - static_cast<int>(std::floor(std::log10(last))), 1, 9) : 3;
  return fmt::format("{:.{}f} s", time, digits);
}

/// Returns the frames on the sheet: the first, the last, and evenly between.
std::vector<std::size_t> sheetFrames(std::size_t count, int cells) {
  std::vector<std::size_t> chosen;
  const std::size_t n = std::min(count, static_cast<std::size_t>(std::max(1, cells)));
  for (std::size_t k = 0; k < n; k++)
    chosen.push_back(n == 1 ? count - 1 : (k * (count - 1) + (n - 1) / 2) / (n - 1));
  return chosen;
}

/// Returns the sheet with the common colour bar at the right.
Image sheetWithBar(std::span<const Image> cells, std::span<const std::string> labels, int columns,
                   const ColourScale* colours) {
  Image sheet = contactSheet(cells, columns, labels);
  if (!colours) return sheet;
  const Rgb ground = sheet.at(0, 0);
  const int tall = std::min(sheet.height, 760), wide = colourBarWidth(*colours, tall);
  Image bar(wide, tall, ground), all(sheet.width + wide, sheet.height, ground);
  drawColourBar(bar, *colours);
  paste(all, sheet, 0, 0);
  paste(all, bar, sheet.width, 0);
  return all;
}

Image pictureOf(const FrameView& frame, const FrameJob& job, const RenderStyle& style, int threads) {
  if (!frame.normals.empty()) {
    SurfelStyle surfels{frame.paint, job.radius > 0 ? job.radius : SurfelStyle{}.discs, threads};
    return renderSurfels(
        {frame.positions, frame.normals, frame.radii, frame.values, frame.colours, frame.components,
         frame.faces, frame.solids, frame.solidFaces, frame.cutAxes, frame.sides},
        style, surfels);
  }
  std::vector<float> radii = frame.sizes.empty() ? std::vector<float>{1} : frame.sizes;
  for (float& r : radii) r *= (job.radius > 0 ? job.radius : 0.7f) * style.spacing;
  return render({frame.positions, frame.values, radii}, style);
}

}  // namespace

/// Returns the linear colour of glass: clear unless the scene gives one.
Vec3f glassColour(std::uint32_t colour) {
  return colour == Obstacle{}.colour ? Vec3f{1, 1, 1} : toLinear(rgbOf(colour));
}

void addWalls(const Walls& walls, double time, RenderStyle& style) {
  Walls now = walls;
  moveWalls(now, time);
  for (const Wall& wall : now.list) {
    if (!wall.present) continue;
    if (const auto plane = planeOf(wall); plane && plane->normal.z > 0.34) style.floors.push_back(*plane);
    const Bounds box = wall.shape->bounds();
    if (std::isfinite(length(box.max - box.min)) && wall.properties.look == ObstacleLook::Glass)
      style.glasses.push_back(
          {wall.shape, wall.pose.rotation, wall.pose.move, glassColour(wall.properties.colour)});
  }
}

ViewBox robustBox(const std::vector<Vec3f>& positions) {
  ViewBox box;
  std::vector<float> sorted;
  sorted.reserve(positions.size());
  for (int axis = 0; axis < 3; axis++) {
    sorted.clear();
    for (const Vec3f& p : positions)
      if (std::isfinite(p[axis])) sorted.push_back(p[axis]);
    if (sorted.empty()) return {};
    const std::size_t cut = sorted.size() / 1000;
    std::nth_element(sorted.begin(), sorted.begin() + static_cast<std::ptrdiff_t>(cut), sorted.end());
    box.min[axis] = sorted[cut];
    std::nth_element(sorted.begin(), sorted.end() - 1 - static_cast<std::ptrdiff_t>(cut), sorted.end());
    box.max[axis] = sorted[sorted.size() - 1 - cut];
  }
  return box;
}

std::vector<fs::path> renderFrames(const FrameJob& job, const ReadFrame& read) {
  if (job.frames.empty()) throw std::runtime_error("expected at least one frame to make pictures of");
  const Survey common = survey(job, read);
  RenderStyle style;
  style.width = job.width;
  style.height = job.height;
  style.samples = job.samples;
  style.lighting = job.lighting;
  style.stage = common.box;
  const std::vector<DrawnObstacle> solids = solidObstacles(job.walls);
  addGlassToBox(job.walls, style.stage);
  addToBox(solids, style.stage);  // floors fade away from all that casts shadows
  style.camera = job.camera ? *job.camera
                            : fittedCamera(common.box, static_cast<double>(job.width) / job.height);
  style.spacing = job.spacing > 0 ? job.spacing : static_cast<float>(common.spacing);
  const bool coloured = common.min <= common.max;
  style.colours = {job.min.value_or(coloured ? common.min : 0),
                   job.max.value_or(coloured ? common.max : 1),
                   job.map,
                   job.field == "glow" ? "temperature" : job.field,
                   common.unit,
                   common.whole};

  makeFolder(job.out);
  const int threads = job.threads > 0 ? job.threads
                                      : static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
  const std::vector<std::size_t> chosen = job.sheet.empty() ? std::vector<std::size_t>{}
                                                            : sheetFrames(job.frames.size(), job.cells);
  std::vector<fs::path> written(job.frames.size());
  std::vector<Image> cells(chosen.size());
  std::vector<std::string> labels(chosen.size());
  std::mutex reading;
  parallelFor(job.frames.size(), threads, [&](std::size_t f) {
    FrameView frame;
    {
      const std::lock_guard lock(reading);
      frame = read(job.frames[f], job.field);
    }
    if (!solids.empty()) addObstacles(solids, 0.6f * style.spacing, frame);
    RenderStyle now = style;
    addWalls(job.walls, frame.time, now);
    Image picture = pictureOf(frame, job, now, job.frames.size() == 1 ? threads : 1);
    if (job.over) job.over(picture, now);
    const std::string label = timeLabel(frame.time, common.lastTime);
    for (std::size_t k = 0; k < chosen.size(); k++)
      if (chosen[k] == f) {
        cells[k] = scaledDown(picture, 480, std::max(1, 480 * job.height / job.width));
        labels[k] = label;
      }
    if (coloured) drawColourBar(picture, style.colours);
    drawCaption(picture, job.title, label);
    written[f] = job.out / job.frames[f].filename().replace_extension(".png");
    writePng(picture, written[f]);
  });
  if (!job.sheet.empty()) {
    makeFolder(job.sheet.parent_path());
    writePng(sheetWithBar(cells, labels, job.columns, coloured ? &style.colours : nullptr), job.sheet);
    written.push_back(job.sheet);
  }
  return written;
}

}  // namespace thaw
