// SPDX-License-Identifier: Apache-2.0
// Contents of an exported frame: meshes, particles and camera, read from the frames of one time.
#pragma once
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "io/commands/export/frame_group.hpp"
#include "io/commands/export/surface_uv.hpp"
#include "io/export/export_scene.hpp"
#include "io/render/render_frames.hpp"

namespace thaw {

/// A scene that frames store, and the data that these frames share.
struct RunScene {
  Scene scene;
  std::vector<std::string> sheetNames, orientedNames;  ///< one per body, unique
  std::vector<std::string> sourceNames;                ///< one per body and emitter, unique
  FrameJob picture;                                    ///< camera, size, walls
  std::vector<ExportObject> obstacles;  ///< at rest, one per obstacle of the scene; without parts if it
                                        ///< cannot be shown
};

/// Scenes of a run, each built once and kept. Thread-safe.
class RunScenes {
 public:
  /// Returns the scene that a frame stores, or nothing. Warns once if its text cannot be read.
  std::shared_ptr<const RunScene> of(const std::filesystem::path& frame, std::vector<std::string>& warnings);
  std::mutex hdf5;  ///< HDF5 is not thread-safe

 private:
  std::mutex making_;
  std::map<std::string, std::shared_ptr<const RunScene>> byText_;
};

/// Returns a scene's obstacles, and a warning for each that cannot be shown.
std::vector<ExportObject> obstaclesOf(const Scene& scene, std::vector<std::string>& warnings);

/// Shared by the threads that gather frames.
struct GatherJob {
  const ExportOptions* options = nullptr;
  const ExportFormat* format = nullptr;
  unsigned contents = 0;
  double interval = 0;  ///< s between frames
  int threads = 1;      ///< for the meshes of one frame
  RunScenes* scenes = nullptr;
  const SurfaceUv* uv = nullptr;  ///< texture coordinates of surfels, or none
};

/// Lines for the user about one frame.
struct GatherNotes {
  std::string summary;                ///< "3 components, 1200 triangles"
  std::vector<std::string> notes;     ///< for standard output, before the summary
  std::vector<std::string> warnings;  ///< for standard error
};

/// Throws IoError and std::invalid_argument.
ExportScene gatherScene(const FrameGroup& group, const GatherJob& job, GatherNotes& notes);

/// Parts of gatherScene.
void gatherSurface(const FrameGroup& group, const GatherJob& job, ExportScene& scene, GatherNotes& notes);
void gatherOriented(const FrameGroup& group, const GatherJob& job, ExportScene& scene, GatherNotes& notes);
void gatherSheets(const FrameGroup& group, const GatherJob& job, ExportScene& scene, GatherNotes& notes);
void gatherParticles(const FrameGroup& group, const GatherJob& job, ExportScene& scene, GatherNotes& notes);
void gatherObstacles(const RunScene& stored, ExportScene& scene, GatherNotes& notes);

/// Reads a frame while no other thread reads one.
FrameData readShared(const std::filesystem::path& frame, const GatherJob& job);

/// Returns a colour per row of a frame's column, on the scale of the options.
std::vector<Rgb> coloursOfColumn(const FrameColumn& column, std::size_t rows, const ExportOptions& options);

/// Returns a vector field of a column with three components, or nothing without one.
std::vector<Vec3f> vectorsOf(const FrameColumn* column, std::size_t rows);
/// Returns a scalar field, or nothing without one.
std::vector<float> numbersOf(const FrameColumn* column, std::size_t rows);

}  // namespace thaw
