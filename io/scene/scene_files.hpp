// SPDX-License-Identifier: Apache-2.0
// Texts of a scene, before they are parsed. One rank reads them and sends them to the others.
#pragma once
#include <map>
#include <string>

namespace thaw {

/// Texts of the scene file and of its includes, by path.
struct SceneFiles {
  std::string main;  ///< path of the scene file
  std::string base;  ///< folder of relative paths: the working folder of the program
  std::map<std::string, std::string> texts;
  std::map<std::string, std::string> problems;  ///< path -> reason why it could not be read
};

/// Reads a scene file and everything that it includes. Never throws for missing files or their content.
SceneFiles loadSceneFiles(const std::string& path);

/// Returns a text as if it were in a file of this name, such as Scene::text of a checkpoint.
SceneFiles sceneFilesOf(const std::string& name, const std::string& text);

/// Converts to one string of bytes, to be sent, and back. unpackSceneFiles throws std::runtime_error for
/// other strings.
std::string packSceneFiles(const SceneFiles& files);
SceneFiles unpackSceneFiles(const std::string& bytes);

}  // namespace thaw
