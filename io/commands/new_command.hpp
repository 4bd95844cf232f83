// SPDX-License-Identifier: Apache-2.0
// `thaw new NAME`: writes a commented scene to start from.
#pragma once
#include <filesystem>
#include <string>

namespace CLI {
class App;
}

namespace thaw {

struct NewOptions {
  std::filesystem::path name;  ///< file of the scene; ".toml" is added if it is missing
  std::string kind = "melt";
  bool schema = false;  ///< also write scene.schema.json, for editors
};

/// Adds the command. Returns it.
CLI::App* addNewCommand(CLI::App& app, NewOptions& options);

/// Writes the scene. Returns the exit code: 0, or 3 with a message if a file exists or cannot be written.
int newCommand(const NewOptions& options);

}  // namespace thaw
