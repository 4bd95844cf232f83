// SPDX-License-Identifier: Apache-2.0
// `thaw preview SCENE`: a picture of a scene at its start, including the parts without particles.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace thaw {

struct PreviewOptions {
  std::string scene;
  std::vector<std::string> overrides;  ///< "key=value"
  std::filesystem::path out;           ///< the picture; empty: NAME_preview.png, or none if html is set
  std::filesystem::path html;          ///< the page; empty: none
  bool through = false;                ///< as the scene's camera sees it
  int width = 0, height = 0;           ///< pixels; 0: those of the scene
};

void addPreviewOptions(CLI::App& command, PreviewOptions& options);

/// Returns the exit code: 0, 2 for an unusable scene or option, 3 for files that cannot be written. Requires:
/// MPI has started. Collective.
int previewCommand(const PreviewOptions& options);

}  // namespace thaw
