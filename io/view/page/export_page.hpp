// SPDX-License-Identifier: Apache-2.0
// A run as one page, thinned to a size.
#pragma once
#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>

#include "core/scene/scene.hpp"

namespace thaw {

struct PageExport {
  std::filesystem::path run, file;
  std::uint64_t budget = 20'000'000;                                   ///< bytes of the page
  nlohmann::ordered_json look = nlohmann::ordered_json::object();      ///< replaces members of sceneView
  nlohmann::ordered_json settings = nlohmann::ordered_json::object();  ///< members of the page's Settings
                                                                       ///< (settings.js)
  bool preview = false;                                                ///< a scene that has not run
  std::function<void(const std::string&)> say = [](const std::string&) {};  ///< receives lines
};

/// Writes the page. Says first how long it takes, and what is left out to stay within the budget: tensors,
/// then frames, then points by a hash of their id. Throws IoError, also where the budget is too small.
void exportPage(const PageExport& request);

}  // namespace thaw
