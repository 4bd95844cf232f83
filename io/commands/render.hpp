// SPDX-License-Identifier: Apache-2.0
// `thaw render`: pictures of a frame or of all frames of a run.
#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace thaw {

struct RenderOptions {
  std::filesystem::path input;  ///< frame, series index, or run folder
  std::filesystem::path out;    ///< folder of the pictures; empty: pictures/ in the run folder, or beside the
                                ///< frame
  std::filesystem::path sheet;  ///< file of the contact sheet; empty: none
  std::string field;            ///< field of the colours; empty: the scene's choice; "none": grey
  std::optional<double> min, max;  ///< range of the colours, SI
  std::string map = "ember";
  std::vector<double> from, at;  ///< m, three numbers each; empty: the scene's camera or fitted
  double fieldOfView = 0;        ///< degrees, vertical; 0: the scene's
  bool latest = false;           ///< only the newest frame
  bool fit = false;              ///< fit the camera to the particles, not to the scene's choice
  bool obstacles = true;
  int width = 0, height = 0;    ///< pixels; 0: the scene's
  int columns = 4, cells = 12;  ///< contact sheet: columns, largest number of pictures
  double radius = 0;  ///< radius of the spheres, in particle spacings, or of the discs of surfels, in their
                      ///< radii. 0: default, 0.7 and 1.25
  std::string look = "mesh";
  std::string spray;               ///< look of drops of one and two particles (Spray); empty: the scene's
  std::string what = "automatic";  ///< "surface", "particles", or the surface if there is one
  bool movie = false;              ///< a movie of the pictures as well
  double rate = 25;                ///< pictures per second of the movie
  int threads = 0;                 ///< 0: one per core
};

/// Adds the options of `thaw render` to its subcommand. `options` must outlive the parsing.
void addRenderOptions(CLI::App& command, RenderOptions& options);

/// Makes the pictures and prints their names. Returns the exit code: 0, 2 for invalid options, 3 for files
/// that cannot be read or written. Prints a message to stderr with 2 and 3.
int renderCommand(const RenderOptions& options);

}  // namespace thaw
