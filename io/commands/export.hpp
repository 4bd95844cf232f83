// SPDX-License-Identifier: Apache-2.0
// `thaw export`: frames of a surface as files for Blender, POV-Ray, ParaView, and as closed meshes.
#pragma once
#include <filesystem>
#include <optional>
#include <string>

namespace CLI {
class App;
}

namespace thaw {

struct ExportOptions {
  std::filesystem::path input;  ///< frame, series index, or run folder
  std::filesystem::path out;  ///< file for one frame, folder for several; empty: export/ in the run's folder
  std::string what;  ///< kind of frames in a folder: surface, oriented, sheet; empty: the first of these that
                     ///< it has
  std::string as;    ///< ply-discs, pov, vtp, ply, obj
  std::string field = "surface";  ///< source of the colours: the surface's own, or a field
  std::string map = "ember";
  std::optional<double> min, max;  ///< range of the colours, SI; empty: the range of the frame
  double cell = 1;                 ///< cell edge of the mesh grid, over the surfels' mean radius
  int threads = 0;                 ///< 0: one per core
};

void addExportOptions(CLI::App& command, ExportOptions& options);

/// Returns the exit code: 0, 2 for invalid options, 3 for files that cannot be read or written. Prints a
/// message with 2 and 3.
int exportCommand(const ExportOptions& options);

}  // namespace thaw
