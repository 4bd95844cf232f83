// SPDX-License-Identifier: Apache-2.0
#include "io/command_line/man_page.hpp"

#include <fmt/ranges.h>

namespace thaw {
namespace {

/// Escapes troff's control characters. "-" would become a typographic hyphen, which no shell accepts.
std::string plain(const std::string& text) {
  std::string to;
  for (const char c : text) {
    if (c == '\\') to += "\\e";
    else if (c == '-') to += "\\-";
    else if ((c == '.' || c == '\'') && (to.empty() || to.back() == '\n')) to += std::string("\\&") + c;
    else to += c;
  }
  return to;
}

std::string optionText(const OptionDescription& option) {
  std::vector<std::string> names;
  for (const std::string& name : option.names)
    names.push_back((option.positional ? "\\fI" : "\\fB") + plain(name) + "\\fR");
  std::string head = fmt::format("{}", fmt::join(names, ", "));
  if (!option.value.empty() && !option.positional) head += " \\fI" + plain(option.value) + "\\fR";
  std::string text = plain(option.description);
  if (!option.choices.empty())
    text += "; one of " + plain(fmt::format("{}", fmt::join(option.choices, ", ")));
  if (!option.fallback.empty()) text += " (default: " + plain(option.fallback) + ")";
  return fmt::format(".TP\n{}\n{}\n", head, text);
}

std::string synopsis(const CommandDescription& command) {
  std::string to = fmt::format(".B thaw {}\n", plain(command.name));
  for (const OptionDescription& option : command.options)
    if (option.positional) to += fmt::format(".I {}\n", plain(option.names.front()));
  return to + "[\\fIoptions\\fR]\n.br\n";
}

std::string commandText(const CommandDescription& command) {
  std::string to = fmt::format(".SS {}\n{}\n", plain(command.name), plain(command.description));
  for (const OptionDescription& option : command.options) to += optionText(option);
  if (!command.footer.empty()) to += ".PP\n" + plain(command.footer) + "\n";
  return to;
}

// docs/reference/exit_codes.md
constexpr const char* after =
    ".SH EXIT STATUS\n"
    ".TP\n0\ndone; also a run that \\-\\-steps has stopped\n"
    ".TP\n1\nthaw compare found differences\n"
    ".TP\n2\nbad scene, or wrong usage\n"
    ".TP\n3\ninput or output failed\n"
    ".TP\n4\nthe simulation failed; the last snapshot is a checkpoint\n"
    ".TP\n75\nstopped early with a checkpoint: \\-\\-time\\-limit, a signal, or the file stop\n"
    ".SH EXAMPLE\n.EX\nmpirun \\-n 4 thaw run scene.toml \\-\\-out out/scene\n"
    "thaw render out/scene \\-\\-sheet scene.png\n.EE\n"
    ".SH SEE ALSO\n.BR mpirun (1)\n.PP\n.B thaw docs\nprints all keys of a scene file.\n";

}  // namespace

std::string manPage(const ProgramDescription& program, const std::string& version) {
  std::string to = fmt::format(
      ".TH THAW 1 \"\" \"thaw {}\" \"User Commands\"\n.SH NAME\n"
      "thaw \\- simulate solids and liquids as particles\n.SH SYNOPSIS\n",
      plain(version));
  for (const CommandDescription& command : program.commands) to += synopsis(command);
  to += fmt::format(".SH DESCRIPTION\n{}\nA scene is a TOML file.\n.SH OPTIONS\n",
                    plain(program.program.description));
  for (const OptionDescription& option : program.program.options) to += optionText(option);
  to += ".SH COMMANDS\n";
  for (const CommandDescription& command : program.commands) to += commandText(command);
  return to + after;
}

}  // namespace thaw
