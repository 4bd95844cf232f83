// SPDX-License-Identifier: Apache-2.0
#include "io/commands/export.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <new>
#include <stdexcept>

#include "io/commands/export/export_frames.hpp"
#include "io/hdf5/io_error.hpp"
#include "io/text/command_error.hpp"
#include "io/text/number_options.hpp"

namespace thaw {

namespace {

std::vector<std::string> formatNames() {
  std::vector<std::string> names;
  for (const ExportFormat& f : exportFormats()) names.push_back(f.name);
  return names;
}

std::string formatHelp() {
  std::string text;
  for (const ExportFormat& f : exportFormats())
    text += fmt::format("{}{}: {}", text.empty() ? "" : "; ", f.name, f.help);
  return text;
}

}  // namespace

void addExportOptions(CLI::App& command, ExportOptions& o) {
  command
      .add_option("path", o.input,
                  "frame of a surface, of oriented particles or of sheets (NAME_surface_000120.hdf, "
                  "NAME_oriented_..., NAME_sheet_...), series index, or run folder (all its frames)")
      ->required();
  command.add_option("--as", o.as, formatHelp())->required()->check(CLI::IsMember(formatNames()));
  command.add_option(
      "--what", o.what,
      "contents, separated by commas: surface, sheet, oriented, obstacles, particles, or all "
      "that the format supports (default: for usd, usda and vdb all, but particles only without a "
      "surface; for others the first of surface, oriented and sheet that the run has)");
  command.add_option(
      "--out", o.out,
      "file for one frame or a format of one file, folder for several (default: export/ in the "
      "run's folder)");
  command
      .add_option("--field", o.field,
                  "source of the colours: surface (its own colours) or a field: temperature, liquid, detail")
      ->capture_default_str();
  command.add_option("--map", o.map, "colour map of a field: ember, sea, grey")->capture_default_str();
  command
      .add_option("--min", o.min, "lowest value of the colour scale, SI (default: the lowest of the frame)")
      ->check(finiteNumber());
  command.add_option("--max", o.max, "highest value of the colour scale, SI")->check(finiteNumber());
  command.add_option("--cell", o.cell, "edge of the cubes of the mesh grid, in mean radii of the surfels")
      ->check(finiteNumber())
      ->check(CLI::Range(0.2, 10.0))
      ->capture_default_str();
  command
      .add_option("--threads", o.threads,
                  "frames at a time, or components of one frame (default: one per core)")
      ->check(CLI::Range(0, 4096));
  command.add_flag(
      "--uv", o.uv,
      "texture coordinates of a surface, from the meshes of its bodies; only for ply, obj, vtp, usd, "
      "usda, vtkhdf and bgeo: vdb and html have none");
  command.add_flag("--mesh", o.mesh, "vtp: closed meshes of a surface instead of its surfels");
  command.add_flag("--resume", o.resume,
                   "skip files that are complete: they exist and are newer than their frames");
  command
      .add_option(
          "--size", o.size,
          "html: largest size of the page, at least 1MB, such as 5MB or 20MB; tensors, frames and points "
          "are left out to stay within it")
      ->capture_default_str();
}

int exportCommand(const ExportOptions& options) {
  try {
    const ExportFormat& format = exportFormatNamed(options.as);
    if (options.uv && format.uv == UvPlace::none)
      throw std::invalid_argument(
          "--uv: '" + options.as +
          "' has no texture coordinates: leave out --uv; expected --as ply, obj, vtp, usd, usda, vtkhdf "
          "or bgeo");
    if (options.mesh && options.as != "vtp")
      throw std::invalid_argument("--mesh applies to --as vtp; expected vtp, got " + options.as);
    if (options.min && options.max && !(*options.max > *options.min))
      throw std::invalid_argument("--max must be above --min");
    colourMapNamed(options.map);
    if (format.writeSequence) format.writeSequence(options.out, options);
    else exportFrames(options, format);
    return 0;
  } catch (const std::invalid_argument& error) {
    printCommandError("export", error.what());
    return 2;
  } catch (const std::bad_alloc&) {
    printCommandError("export", options.input.string() + ": not enough memory");
    return exitInputOutput;
  } catch (const std::runtime_error& error) {  // IoError or a file system error
    printCommandError("export", error.what());
    return exitInputOutput;
  }
}

}  // namespace thaw
