// thaw info FILE|FOLDER [--json]: what is in a frame, a checkpoint, an index of frames or the folder of a
// run.
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

/// One process; prints to standard output, errors to standard error. Returns the exit code: 0, or 3 for what
/// cannot be read.
int infoCommand(const InfoArguments& arguments);

/// What infoCommand prints. IoError for what cannot be read.
nlohmann::ordered_json describePath(const std::string& path);

}  // namespace thaw
