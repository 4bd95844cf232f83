// SPDX-License-Identifier: Apache-2.0
// The commented scenes that `thaw new` writes.
#pragma once
#include <span>
#include <string>
#include <vector>

namespace thaw {

struct StartingScene {
  const char *kind, *about;
  const char* text;  ///< TOML without a title; begins with a line break
};

std::span<const StartingScene> startingScenes();

/// Returns the names of all kinds.
std::vector<std::string> startingKinds();

}  // namespace thaw
