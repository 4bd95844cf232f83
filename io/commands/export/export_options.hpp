// SPDX-License-Identifier: Apache-2.0
// Options of `thaw export`.
#pragma once
#include <filesystem>
#include <optional>
#include <string>

namespace thaw {

struct ExportOptions {
  std::filesystem::path input;    ///< frame, series index, or run folder
  std::filesystem::path out;      ///< file for one frame or a sequence, folder for several frames; empty:
                                  ///< export/ in the run's folder
  std::string what;               ///< contents, separated by commas; empty: the default of the format
  std::string as;                 ///< name of a format (formats.hpp)
  std::string field = "surface";  ///< source of the colours: the surface's own, or a field
  std::string map = "ember";
  std::optional<double> min, max;  ///< range of the colours, SI; empty: the range of the frame
  double cell = 1;                 ///< cell edge of the mesh grid, in mean radii of the surfels
  int threads = 0;                 ///< 0: one per core
  bool uv = false;                 ///< with texture coordinates of surfaces
  bool mesh = false;               ///< vtp: closed meshes of surfaces instead of surfels
  bool resume = false;             ///< skips files that are complete
  std::string size = "20MB";       ///< html: largest size of the page
};

}  // namespace thaw
