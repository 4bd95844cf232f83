// SPDX-License-Identifier: Apache-2.0
// Hints for common causes of TOML syntax errors in scenes.
#pragma once
#include <string>

namespace thaw {

/// Returns "; ..." with the probable intention of text that does not parse, or "". line: from 1, where the
/// parser stopped; complaint: its message.
std::string syntaxHint(const std::string& text, int line, const std::string& complaint);

}  // namespace thaw
