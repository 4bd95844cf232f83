// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <exception>
#include <optional>
#include <string>
#include <vector>

#include "core/geometry/basic/triangle_mesh.hpp"
#include "core/scene/scene.hpp"
#include "parallel/communicator.hpp"

namespace thaw {

/// Exit codes of the program.
inline constexpr int exitDone = 0, exitUsage = 2, exitBlewUp = 4, exitStopped = 75;

/// Message and exit code for unusable input: a scene, a shape, a file of a run. refusalOf returns nothing for
/// other exceptions.
struct Refusal {
  std::string message;
  int code;
};
std::optional<Refusal> refusalOf(const std::exception& e);

/// Replaces the text by that of rank 0. Collective.
void broadcastText(const Communicator& comm, std::string& text);

/// Reads the files of the scene on rank 0 and sends them to the others; all parse them. Throws SceneErrors,
/// alike on all ranks. Collective.
Scene sceneForAll(const Communicator& comm, const std::string& path,
                  const std::vector<std::string>& overrides);

/// Returns a function that reads a mesh from a file, for makeSignedDistance.
MeshLoader meshLoader();

}  // namespace thaw
