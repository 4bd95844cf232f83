// Pictures of many frames: the same camera and the same range of colours for all of them, several frames at
// once, and a contact sheet.
#pragma once
#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/walls/walls.hpp"
#include "io/export/whole_component.hpp"
#include "io/render/render_surfels.hpp"

namespace thaw {

/// What a picture needs of a frame.
struct FrameView {
  double time = 0;               ///< s
  std::vector<Vec3f> positions;  ///< m
  std::vector<float> values;     ///< of the field asked for (length of a vector, Frobenius norm of a tensor);
                                 ///< empty if there is none
  std::string unit;              ///< of the values
  // of surfels only; else empty
  std::vector<Vec3f> normals;  ///< unit, outward
  std::vector<float> radii;    ///< m
  std::vector<Rgb> colours;    ///< of the surface
  std::vector<std::uint32_t> components;
  std::vector<std::array<std::uint32_t, 3>> faces;  ///< triangles between rows, seen from where these turn
                                                    ///< counterclockwise; such rows are no discs
  SurfelPaint paint = SurfelPaint::Plain;
};

/// Reads a frame's positions and one field; an empty name asks for positions alone. Throws std::runtime_error
/// naming the file and the cause. Only called by one thread at a time: HDF5 is not thread-safe.
using ReadFrame = std::function<FrameView(const std::filesystem::path& file, const std::string& field)>;

struct FrameJob {
  std::vector<std::filesystem::path> frames;  ///< in the order of time
  std::filesystem::path out;       ///< folder of the pictures, is made; a frame `a.hdf` gives `a.png`
  std::filesystem::path sheet;     ///< file of the contact sheet; empty: none
  int columns = 4, cells = 12;     ///< of the sheet: at most so many pictures, evenly spread over the frames
  std::string title;               ///< in each picture before the time
  std::string field;               ///< that colours; empty: all grey
  std::optional<double> min, max;  ///< of the colours; without: the range over all frames
  ColourMap map = ColourMap::Ember;
  std::optional<Camera> camera;  ///< without: fitted to the particles of all frames
  int width = 1280, height = 960, samples = 2;
  float spacing = 0;       ///< m
  PeriodicSides periodic;  ///< of the domain: surfaces that cross them are drawn in one piece
  float radius = 0;  ///< of the spheres, in spacings; of surfels' discs, in their radii; 0: what looks well
  Walls walls;       ///< at their rest poses: planes become floors, other things glass
  int threads = 0;   ///< 0: one a core
};

/// Pictures written, in the order of the frames, the contact sheet last if there is one.
std::vector<std::filesystem::path> renderFrames(const FrameJob& job, const ReadFrame& read);

/// Adds what is there of the walls at a time (s). Planes that lean by more than 70 degrees are left out: they
/// would hide the scene.
void addWalls(const Walls& walls, double time, RenderStyle& style);

/// A camera range that stays: what is outside of the middle 99.8 % of all particles (drops that flew away)
/// does not move the camera.
ViewBox boxOfMost(const std::vector<Vec3f>& positions);

}  // namespace thaw
