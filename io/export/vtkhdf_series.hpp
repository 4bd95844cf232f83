// SPDX-License-Identifier: Apache-2.0
// Scenes of a run as one temporal VTKHDF file (version 2.0), for ParaView 5.12 and newer.
#pragma once
#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "io/export/export_scene.hpp"
#include "io/hdf5/growing_file.hpp"

namespace thaw {

/// Points, cells and fields of one frame.
struct VtkHdfFrame {
  double time = 0;                         ///< s
  std::vector<Vec3f> points;               ///< m
  std::vector<std::int64_t> connectivity;  ///< three points for a triangle, two for a line of a curve, one
                                           ///< for a particle; in this order
  std::int64_t triangles = 0, lines = 0;   ///< numbers of cells; all others are particles
  /// Values of each point, or nothing if all objects lack the field. An object that lacks it has zero normals
  /// and velocities, and NaN for the others.
  std::optional<std::vector<Vec3f>> normals, velocities;
  std::optional<std::vector<float>> temperatures, liquid;
  std::optional<std::vector<std::array<float, 2>>> uvs;
  std::vector<std::uint8_t> colours;  ///< three per point, sRGB
  std::vector<std::int32_t> objects;  ///< index of the mesh; -1 for particles
  std::vector<std::int64_t> labels;   ///< label of the component; -1 for all others
  std::vector<std::int64_t> ids;      ///< ids of particles; -1 for vertices of meshes
};

/// Returns the meshes in their poses, then the particles. Thread-safe.
VtkHdfFrame vtkHdfFrameOf(const ExportScene& scene);

/// Returns the size in bytes of a series of `frames` frames like this one: all chunks of its datasets.
double vtkHdfBytes(const VtkHdfFrame& frame, double frames);

/// File that grows frame by frame: an UnstructuredGrid with the group Steps. All frames have the fields of
/// the first one. Calls need the lock of HDF5. All throw IoError.
class VtkHdfSeries {
 public:
  explicit VtkHdfSeries(const std::filesystem::path& file);
  /// Requires: ascending times.
  void add(const VtkHdfFrame& frame);
  void finish();

 private:
  void addSteps(const VtkHdfFrame& frame, std::int64_t cells);
  GrowingFile file_;
  std::int64_t frames_ = 0, points_ = 0, cells_ = 0, connectivity_ = 0;
  bool normals_ = false, velocities_ = false, temperatures_ = false, liquid_ = false, uvs_ = false;
};

}  // namespace thaw
