// A scene file as a Scene: TOML with units, includes and overrides; all errors at once.
#pragma once
#include <stdexcept>
#include <string>
#include <vector>

#include "core/scene/scene.hpp"
#include "io/scene/scene_files.hpp"

namespace thaw {

/// What is wrong with a scene: a line each, `file:line:column: error: ...` or `--set key=value: error: ...`.
/// what() has all lines.
struct SceneErrors : std::runtime_error {
  std::vector<std::string> lines;
  explicit SceneErrors(std::vector<std::string> all);
};

/// The scene of texts that were read before (loadSceneFiles), on any rank; touches no file. overrides:
/// "key=value" with a dotted key (applyOverride). Scene::text has includes and overrides resolved and meshes
/// as absolute paths: read again, it is the same scene. Throws SceneErrors.
Scene readScene(const SceneFiles& files, const std::vector<std::string>& overrides = {});

/// The scene of a file. Throws SceneErrors, also for a file that cannot be read.
Scene readScene(const std::string& path, const std::vector<std::string>& overrides = {});

/// The complete small scene of docs/scene.md.
const char* exampleScene();

/// docs/scene.md, from the table of keys.
std::string sceneDocumentation();

}  // namespace thaw
