// SPDX-License-Identifier: Apache-2.0
// Reads a scene file: TOML with units, includes and overrides. Reports all errors at once.
#pragma once
#include <stdexcept>
#include <string>
#include <vector>

#include "core/scene/scene.hpp"
#include "io/scene/scene_files.hpp"

namespace thaw {

/// Errors of a scene, a line each: `file:line:column: error: ...` or `--set key=value: error: ...`. what()
/// has all lines.
struct SceneErrors : std::runtime_error {
  std::vector<std::string> lines;
  explicit SceneErrors(std::vector<std::string> all);
};

/// Returns the scene of texts that loadSceneFiles has read. Touches no file, so that any rank can call it.
/// overrides: "key=value" with a dotted key (applyOverride). Scene::text has includes and overrides resolved
/// and absolute paths of meshes; read again, it gives the same scene. Throws SceneErrors.
Scene readScene(const SceneFiles& files, const std::vector<std::string>& overrides = {});

/// Returns the scene of a file. Throws SceneErrors, also for an unreadable file.
Scene readScene(const std::string& path, const std::vector<std::string>& overrides = {});

/// Returns the complete small scene of docs/scene.md.
const char* exampleScene();

/// Returns docs/scene.md, from the table of keys.
std::string sceneDocumentation();

/// Returns the JSON schema (draft 4) of scene files for editors, from the same table.
std::string sceneSchema();

}  // namespace thaw
