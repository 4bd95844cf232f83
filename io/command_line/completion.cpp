// SPDX-License-Identifier: Apache-2.0
#include "io/command_line/completion.hpp"

#include <fmt/ranges.h>

namespace thaw {
namespace {

std::string names(const CommandDescription& command) {
  std::string to;
  for (const OptionDescription& option : command.options)
    for (const std::string& name : option.names)
      if (!option.positional) to += (to.empty() ? "" : " ") + name;
  return to;
}

/// Returns the cases "command,option) choices" of the values of a command's options.
std::string valueCases(const CommandDescription& command) {
  std::string to;
  for (const OptionDescription& option : command.options) {
    if (!option.choices.empty() && !option.positional)
      to += fmt::format("    {},{}) words='{}' ;;\n", command.name, option.names.back(),
                        fmt::join(option.choices, " "));
  }
  return to;
}

}  // namespace

std::string bashCompletion(const ProgramDescription& program) {
  std::string commands, cases, options;
  for (const CommandDescription& command : program.commands) {
    commands += (commands.empty() ? "" : " ") + command.name;
    cases += valueCases(command);
    options += fmt::format("      {}) words='{}' ;;\n", command.name, names(command));
  }
  return fmt::format(R"(# Completion of thaw for bash, made by: thaw docs --completion bash
_thaw() {{
  local current=${{COMP_WORDS[COMP_CWORD]}} before=${{COMP_WORDS[COMP_CWORD - 1]}} command= word words=
  for word in "${{COMP_WORDS[@]:1:COMP_CWORD - 1}}"; do
    case $word in -*) ;; *) command=$word; break ;; esac
  done
  case $command,$before in
{}    *) case $command in
      '') words='{} {}' ;;
{}    esac
    [[ -z $command || $current == -* ]] || words= ;;
  esac
  mapfile -t COMPREPLY < <(compgen -W "$words" -- "$current")
}}
complete -o default -F _thaw thaw
)",
                     cases, commands, names(program.program), options);
}

}  // namespace thaw
