// SPDX-License-Identifier: Apache-2.0
// `thaw info FILE|FOLDER [--json]`: describes a frame, a checkpoint, an index of frames or a run folder.
#pragma once
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>
#include <string>

namespace thaw {

struct InfoArguments {
  std::string path;
  bool json = false, all = false;
};

CLI::App* addInfoCommand(CLI::App& app, InfoArguments& arguments);

/// One process; prints to standard output, errors to standard error. Returns the exit code: 0, or 3 for
/// unreadable input.
int infoCommand(const InfoArguments& arguments);

/// Returns the details that infoCommand prints. Throws IoError for unreadable input.
nlohmann::ordered_json describePath(const std::string& path);

}  // namespace thaw
