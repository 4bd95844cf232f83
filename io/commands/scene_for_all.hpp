#pragma once
#include <exception>
#include <optional>
#include <string>
#include <vector>

#include "core/geometry/triangle_mesh.hpp"
#include "core/scene/scene.hpp"
#include "parallel/communicator.hpp"

namespace thaw {

/// Exit codes of the program.
inline constexpr int exitDone = 0, exitUsage = 2, exitBlewUp = 4, exitStopped = 75;

/// What is said, and the exit code, where input cannot be used: of a scene, a shape, a file of a run. Nothing
/// for exceptions that do not mean that.
struct Refusal {
  std::string message;
  int code;
};
std::optional<Refusal> refusalOf(const std::exception& e);

/// The first rank reads the scene's files and sends their texts to the others; all parse them. Throws
/// SceneErrors, alike on all ranks.
Scene sceneForAll(const Communicator& comm, const std::string& path,
                  const std::vector<std::string>& overrides);

/// Reads a mesh from a file, for makeSignedDistance.
MeshLoader meshLoader();

}  // namespace thaw
