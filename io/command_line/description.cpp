// SPDX-License-Identifier: Apache-2.0
#include "io/command_line/description.hpp"

#include <CLI/CLI.hpp>

namespace thaw {
namespace {

/// Splits a type of CLI11: "TEXT:{mesh,wire}" has choices, "FLOAT:FLOAT in [1 - 170]" a range.
void setValue(OptionDescription& to, const CLI::Option& option) {
  if (option.get_expected_min() == 0) return;  // a flag
  const std::string type = option.get_type_name();
  const std::size_t colon = type.find(':');
  to.value = type.substr(0, colon);
  if (option.get_expected_min() > 1) to.value += " x " + std::to_string(option.get_expected_min());
  const std::size_t open = type.find('{'), close = type.rfind('}');
  if (open == std::string::npos || close == std::string::npos) return;
  to.choices = CLI::detail::split(type.substr(open + 1, close - open - 1), ',');
}

OptionDescription describeOption(const CLI::Option& option) {
  OptionDescription to;
  to.positional = option.get_positional();
  for (const std::string& name : option.get_snames()) to.names.push_back("-" + name);
  for (const std::string& name : option.get_lnames()) to.names.push_back("--" + name);
  if (to.positional) to.names = {option.get_name(true)};
  setValue(to, option);
  to.fallback = option.get_default_str();
  to.description = option.get_description();
  return to;
}

CommandDescription describeCommand(const CLI::App& app) {
  CommandDescription to{app.get_name(), app.get_description(), app.get_footer(), {}};
  for (const CLI::Option* option : app.get_options()) to.options.push_back(describeOption(*option));
  return to;
}

}  // namespace

ProgramDescription describe(const CLI::App& app) {
  ProgramDescription to{describeCommand(app), {}};
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; }))
    to.commands.push_back(describeCommand(*command));
  return to;
}

}  // namespace thaw
