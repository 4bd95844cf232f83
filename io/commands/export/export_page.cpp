// SPDX-License-Identifier: Apache-2.0
#include "io/commands/export/export_page.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <stdexcept>

#include "io/commands/export/export_frames.hpp"
#include "io/commands/export/out_name.hpp"
#include "io/frames/run_folder.hpp"
#include "io/hdf5/io_error.hpp"
#include "io/image/colour_map.hpp"
#include "io/scene/scene_for_all.hpp"
#include "io/view/page/export_page.hpp"
#include "io/view/page/page_file.hpp"

namespace fs = std::filesystem;

namespace thaw {
namespace {

/// Returns the file of the page: `out` itself, or NAME.html in that folder.
fs::path pageFile(const fs::path& out, const fs::path& run) {
  const bool folder = isFolder(out);
  if (out.extension() == ".html" && !folder) return out;
  if (out.has_extension() && !folder) refuseOut(out, ".html");
  return (out.empty() ? exportFolder(run) : out) / (run.filename().string() + ".html");
}

PageExport requestOf(const fs::path& out, const ExportOptions& options) {
  if (!options.what.empty())
    throw std::invalid_argument(
        "--what: not available with --as html, since a page contains all types of frames");
  PageExport request;
  request.budget = bytesOfText(options.size);
  request.run = runFolder(options.input);
  request.file = pageFile(out, request.run);
  if (options.field != "surface") request.look["colour"] = options.field;
  if (options.min) request.look["colour_min"] = *options.min;
  if (options.max) request.look["colour_max"] = *options.max;
  request.settings["map"] = options.map;
  request.say = [](const std::string& line) { fmt::print("{}\n", line), std::fflush(stdout); };
  return request;
}

}  // namespace

std::uint64_t bytesOfText(const std::string& text) {
  char* end = nullptr;
  const double number = std::strtod(text.c_str(), &end);
  std::string unit = end;
  unit.erase(0, unit.find_first_not_of(' '));
  const double factor = unit.empty() || unit == "B" ? 1
                        : unit == "kB"              ? 1e3
                        : unit == "MB"              ? 1e6
                        : unit == "GB"              ? 1e9
                                                    : 0;
  if (end == text.c_str() || factor == 0 || !(number > 0) || !(number * factor < 1e15))
    throw std::invalid_argument("--size: expected a size such as 5MB or 20MB, got " + text);
  return static_cast<std::uint64_t>(std::llround(number * factor));
}

void exportRunPage(const fs::path& out, const ExportOptions& options) {
  const PageExport request = requestOf(out, options);
  if (const std::string problem = pageProblem(); !problem.empty()) throw std::invalid_argument(problem);
  exportPage(request);
}

}  // namespace thaw
