// SPDX-License-Identifier: Apache-2.0
// The man page thaw.1.
#pragma once
#include <string>

#include "io/command_line/description.hpp"

namespace thaw {

/// Returns the page in the man macros of troff. version: "0.2.0", for the footer of the page.
std::string manPage(const ProgramDescription& program, const std::string& version);

}  // namespace thaw
