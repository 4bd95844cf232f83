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
  std::filesystem::path input;  ///< frame, series index, or folder of a run
  std::filesystem::path out;  ///< file for one frame, folder for several; empty: export/ in the run's folder
  std::string what;  ///< of a folder: surface, oriented, sheet; empty: the first of these that it has
  std::string as;    ///< ply-discs, pov, vtp, ply, obj
  std::string field = "surface";  ///< that colours: the surface's own colours, or a field
  std::string map = "ember";
  std::optional<double> min, max;  ///< of the colours, SI; empty: the range of the frame
  double cell = 1;                 ///< of the grid that meshes are made on, over the surfels' mean radius
  int threads = 0;                 ///< 0: one a core
};

void addExportOptions(CLI::App& command, ExportOptions& options);

/// Returns the exit code: 0, 2 for options that make no sense, 3 for files that cannot be read or written; a
/// message goes with 2 and 3.
int exportCommand(const ExportOptions& options);

}  // namespace thaw
