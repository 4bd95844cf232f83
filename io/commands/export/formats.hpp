// SPDX-License-Identifier: Apache-2.0
// Table of the formats of `thaw export`.
#pragma once
#include <filesystem>
#include <span>
#include <string>

#include "io/commands/export/export_options.hpp"
#include "io/export/export_scene.hpp"

namespace thaw {

/// Contents of a run, as bits.
enum ExportContent : unsigned {
  surfaceContent = 1,
  sheetContent = 2,
  orientedContent = 4,
  obstacleContent = 8,
  particleContent = 16,
  allContent = 31
};

/// How a format stores texture coordinates.
enum class UvPlace : unsigned char { none, vertices, corners };

/// A format has exactly one of the two functions.
struct ExportFormat {
  const char* name;
  const char* extension;  ///< with the dot
  const char* help;
  unsigned holds;          ///< contents that the format supports
  bool keepsSurfels;       ///< a surface is written as surfels, not as a closed mesh
  bool keepsTables;        ///< sheets or oriented particles alone are written with all their fields
  bool holdsAllByDefault;  ///< default of --what: all contents, with particles only if there is no surface;
                           ///< else the first content of the run
  UvPlace uv;              ///< --uv: texture coordinates of a surface
  /// Writes one frame. Throws IoError.
  void (*writeFrame)(const std::filesystem::path& file, const ExportScene& scene);
  /// Writes a run as one file, and prints a summary. Throws IoError and std::invalid_argument.
  void (*writeSequence)(const std::filesystem::path& file, const ExportOptions& options);
};

std::span<const ExportFormat> exportFormats();

/// Throws std::invalid_argument for an unknown name.
const ExportFormat& exportFormatNamed(const std::string& name);

/// Returns the contents that a comma-separated list names; 0 if it is empty. Throws std::invalid_argument.
unsigned contentsNamed(const std::string& list);

/// Returns the plural name of one content, such as "surfaces".
const char* contentText(unsigned content);

/// Returns the names of the formats that support a content, such as "ply, obj or vtp".
std::string formatsHolding(unsigned content);

}  // namespace thaw
