// SPDX-License-Identifier: Apache-2.0
// `thaw export`: frames as files of other programs.
#pragma once
#include "io/commands/export/export_options.hpp"

namespace CLI {
class App;
}

namespace thaw {

void addExportOptions(CLI::App& command, ExportOptions& options);

/// Returns the exit code: 0, 2 for invalid options, 3 for files that cannot be read or written. Prints a
/// message with 2 and 3.
int exportCommand(const ExportOptions& options);

}  // namespace thaw
