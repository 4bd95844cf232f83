// SPDX-License-Identifier: Apache-2.0
// Completion of the command line in bash.
#pragma once
#include <string>

#include "io/command_line/description.hpp"

namespace thaw {

/// Returns a script for bash: commands, options, and values of options that have a list of choices. File
/// names complete all other arguments.
std::string bashCompletion(const ProgramDescription& program);

}  // namespace thaw
