// The texts that a scene is made of, apart from their meaning: one rank reads them, the others get them by
// message.
#pragma once
#include <map>
#include <string>

namespace thaw {

/// Texts of the scene file and of what it includes, by path.
struct SceneFiles {
  std::string main;  ///< path of the scene file
  std::string base;  ///< folder that relative paths start from: where the program was called
  std::map<std::string, std::string> texts;
  std::map<std::string, std::string> problems;  ///< path -> why it could not be read
};

/// Reads a scene file and everything that it includes. Never throws for what is in the files or missing.
SceneFiles loadSceneFiles(const std::string& path);

/// A text as if it stood in a file of this name, such as Scene::text of a checkpoint.
SceneFiles sceneFilesOf(const std::string& name, const std::string& text);

/// As one string of bytes, to be sent, and back. unpackSceneFiles throws std::runtime_error for what is no
/// such string.
std::string packSceneFiles(const SceneFiles& files);
SceneFiles unpackSceneFiles(const std::string& bytes);

}  // namespace thaw
