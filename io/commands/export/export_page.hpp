// SPDX-License-Identifier: Apache-2.0
// `thaw export RUN --as html`: a run as one page that needs no server.
#pragma once
#include <cstdint>
#include <filesystem>
#include <string>

#include "io/commands/export/export_options.hpp"

namespace thaw {

/// Returns the bytes of "800kB", "20MB", "1.5 GB" or "123456". Throws std::invalid_argument for other texts.
std::uint64_t bytesOfText(const std::string& text);

/// Writes a run as one page. out: file, folder, or empty for export/ in the run's folder. Throws IoError, and
/// std::invalid_argument for invalid options or a program that is built without the page.
void exportRunPage(const std::filesystem::path& out, const ExportOptions& options);

}  // namespace thaw
