// SPDX-License-Identifier: Apache-2.0
// The command line as data, for its man page and its completion.
#pragma once
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace thaw {

/// An option, a flag or a positional argument of a command.
struct OptionDescription {
  std::vector<std::string> names;    ///< "--set", "-h"; the plain name of a positional argument
  std::string value;                 ///< "TEXT", "FLOAT x 3"; empty for a flag
  std::vector<std::string> choices;  ///< the only values that are allowed; empty: any
  std::string fallback;              ///< the default as text, or empty
  std::string description;
  bool positional = false;
};

struct CommandDescription {
  std::string name, description, footer;
  std::vector<OptionDescription> options;
};

/// The program: options without a command, and the commands in the order of --help.
struct ProgramDescription {
  CommandDescription program;
  std::vector<CommandDescription> commands;
};

ProgramDescription describe(const CLI::App& app);

}  // namespace thaw
