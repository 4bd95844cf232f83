// SPDX-License-Identifier: Apache-2.0
// Scenes of a run as one USD layer with time samples.
#pragma once
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "io/export/export_scene.hpp"
#include "io/export/usd/layer.hpp"

namespace thaw {

/// Attribute of a prim in one frame.
struct UsdSample {
  UsdAttributeType type;
  UsdBytes value;
  bool isConstant = false;  ///< the same in all frames
};

struct UsdPrimSample {
  std::string name, type;
  std::vector<UsdSample> attributes;
};

struct UsdFrame {
  double time = 0;  ///< s
  std::vector<UsdPrimSample> prims;
};

/// Returns a scene as values of a file. Thread-safe.
///
/// Each object is a Mesh with points, normals, velocities and primvars (displayColor in linear light,
/// temperature, liquid, component). Moving obstacles have a transform. Particles are Points with widths, ids
/// and velocities. Lights are those of pictures, and so is the background, an attribute of the camera.
UsdFrame usdFrameOf(const ExportScene& scene, const UsdFile& file);

/// Layer that grows frame by frame.
class UsdSequence {
 public:
  /// name: of the root prim. interval: s between frames, one time code.
  UsdSequence(std::unique_ptr<UsdFile> file, const std::string& name, double interval);
  const UsdFile& file() const { return *file_; }
  /// Requires: ascending times.
  void add(const UsdFrame& frame);
  void finish(const std::string& comment);

 private:
  UsdPrim& primOf(const UsdPrimSample& sample);
  void addVisibility();

  std::unique_ptr<UsdFile> file_;
  UsdLayer layer_;
  std::vector<double> times_;                         // time codes of all frames
  std::map<std::string, std::vector<bool>> present_;  // by prim: whether a frame has it
};

}  // namespace thaw
