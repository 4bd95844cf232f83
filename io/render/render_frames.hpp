// SPDX-License-Identifier: Apache-2.0
// Pictures of many frames with one camera and colour range, several frames in parallel, and a contact sheet.
#pragma once
#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/walls/walls.hpp"
#include "io/render/surfels/render_surfels.hpp"
#include "io/surface_mesh/unwrap_component.hpp"

namespace thaw {

/// Data of a frame for its picture.
struct FrameView {
  double time = 0;               ///< s
  std::vector<Vec3f> positions;  ///< m
  std::vector<float> values;     ///< values of the requested field (length of a vector, Frobenius norm of a
                                 ///< tensor); empty if there is none
  std::string unit;              ///< unit of the values
  bool whole = false;            ///< the values are integers
  std::vector<float> sizes;      ///< cube roots of particles' volumes, in spacings; empty: all are 1
  // for surfels only, else empty
  std::vector<Vec3f> normals;  ///< unit, outward
  std::vector<float> radii;    ///< m
  std::vector<Rgb> colours;    ///< surface colours
  std::vector<std::uint32_t> components;
  /// Triangles between rows, counter-clockwise seen from the front; these rows are not drawn as discs.
  std::vector<std::array<std::uint32_t, 3>> faces;
  std::vector<std::uint8_t> cutAxes;  ///< per row: bits of the periodic axes at whose sides the surface
                                      ///< ends; rows beyond the list have none
  PeriodicSides sides;
  SurfelPaint paint = SurfelPaint::Plain;
  std::vector<std::array<Vec3f, 3>> solids;  ///< triangles that cast the shadows of the last `solidFaces`
                                             ///< faces
  std::size_t solidFaces = 0;
};

/// Reads a frame's positions and one field; an empty name selects positions only. Throws std::runtime_error
/// with file and cause. Call from one thread at a time: HDF5 is not thread-safe.
using ReadFrame = std::function<FrameView(const std::filesystem::path& file, const std::string& field)>;

struct FrameJob {
  std::vector<std::filesystem::path> frames;  ///< in order of time
  std::filesystem::path out;    ///< folder of the pictures, created if missing; frame `a.hdf` becomes `a.png`
  std::filesystem::path sheet;  ///< file of the contact sheet; empty: none
  int columns = 4, cells = 12;  ///< for the sheet: largest number of pictures, evenly spread over the frames
  std::string title;            ///< in each picture before the time
  std::string field;            ///< field for colours; empty: all grey
  std::optional<double> min, max;  ///< range of colours; empty: the range over all frames
  ColourMap map = ColourMap::Ember;
  std::optional<Camera> camera;  ///< empty: fitted to the particles of all frames
  int width = 1280, height = 960, samples = 2;
  float spacing = 0;       ///< m
  double interval = 0;     ///< s of simulated time between frames; 0: unknown
  PeriodicSides periodic;  ///< sides of the domain: surfaces across them are unwrapped
  float radius = 0;        ///< radius of spheres in spacings, or surfels' discs in their radii; 0: default
  Walls walls;             ///< at their rest poses: planes are floors, other obstacles glass or solid
  Lighting lighting;
  Spray spray = Spray::Ellipsoids;
  int threads = 0;                                       ///< 0: one per core
  std::function<void(Image&, const RenderStyle&)> over;  ///< draws over each picture; empty: nothing
};

/// Returns the written pictures in frame order, then the contact sheet, if any.
std::vector<std::filesystem::path> renderFrames(const FrameJob& job, const ReadFrame& read);

/// Adds the walls that are present at a time (s). Planes steeper than 70 degrees are skipped, since they
/// would hide the scene.
void addWalls(const Walls& walls, double time, RenderStyle& style);

/// Returns a stable box for the camera: the middle 99.8 % of particles on each axis, without drops that flew
/// away.
ViewBox robustBox(const std::vector<Vec3f>& positions);

}  // namespace thaw
