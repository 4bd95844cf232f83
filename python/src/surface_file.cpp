// SPDX-License-Identifier: Apache-2.0
#include "python/src/surface_file.hpp"

#include <fmt/format.h>

#include <stdexcept>
#include <thread>
#include <vector>

#include "io/export/export_surface.hpp"
#include "io/image/parallel_for.hpp"
#include "io/render/scene_job.hpp"

namespace thaw::python {
namespace {

/// A frame without a usable scene, as with extensions of another program, has no periodic sides.
PeriodicSides sidesOf(const SurfaceFrame& frame) {
  try {
    return periodicSidesOf(sceneOfText(frame.sceneText, frame.sceneName).domain);
  } catch (const std::exception&) { return {}; }
}

}  // namespace

void writeSurfaceFile(const std::string& path, const std::string& file, double cell) {
  if (!(cell >= 0.2 && cell <= 10))
    throw std::invalid_argument(fmt::format("cell: expected a number from 0.2 to 10, got {:g}", cell));
  const SurfaceFrame frame = readSurfaceFrame(path);
  const PeriodicSides sides = sidesOf(frame);
  const std::vector<ComponentRows> components = rowsByComponent(frame);
  std::vector<ComponentMesh> meshes(components.size());
  const int threads = static_cast<int>(std::thread::hardware_concurrency());
  parallelFor(components.size(), threads, [&](std::size_t c) {
    meshes[c] = meshOfComponent(frame, components[c], frame.colours, sides, cell);
  });
  std::erase_if(meshes, [](const ComponentMesh& m) { return m.mesh.triangles.empty(); });
  writeMeshPly(file, meshes);
}

}  // namespace thaw::python
