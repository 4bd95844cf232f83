// A scene file as a Scene: TOML with units, includes and overrides; all errors of a file at once.
#pragma once
#include <functional>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

#include "core/scene/scene.hpp"
#include "io/scene/table_reader.hpp"

namespace thaw {

/// What is wrong with a scene: a line each, `file:line:column: error: ...`.
struct SceneErrors : std::runtime_error {
  std::vector<std::string> lines;
  explicit SceneErrors(std::vector<std::string> all);
};

/// Texts of the scene file and of what it includes, by path. One rank reads them and the others get them by message.
struct SceneFiles {
  std::string main;                          ///< path of the scene file
  std::map<std::string, std::string> texts;
  std::map<std::string, std::string> problems;  ///< path -> why it could not be read
};

/// Reads a scene file and everything that it includes. Never throws for what is in the files.
SceneFiles loadSceneFiles(const std::string& path);

/// overrides: "key=value" with a dotted key: `spacing=1 mm`, `material.wax.young=1 MPa`, `body.bust.mesh=x.ply`, `body.0.velocity=[0,0,1]`.
/// Throws SceneErrors.
Scene readScene(const SceneFiles& files, const std::vector<std::string>& overrides);

/// docs/scene.md, from the table of keys.
std::string sceneDocumentation();

}  // namespace thaw
