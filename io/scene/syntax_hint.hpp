// What a TOML parser's complaint usually means in a scene.
#pragma once
#include <string>

namespace thaw {

/// "; ..." with what was probably meant where a file of this text does not parse; "" where nothing is known.
/// line: from 1, where the parser stopped; complaint: what it says.
std::string syntaxHint(const std::string& text, int line, const std::string& complaint);

}  // namespace thaw
