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
  std::function<void(const std::string&)> say = [](const std::string&) {};  ///< receives messages
};

/// Writes the page. First reports the expected size and time. To stay within the budget, it leaves out
/// tensors, frames, particles beside a surface, and points by a hash of their id (thinning.hpp). Warns if a
/// mesh keeps less than a quarter of its points. Throws IoError, also if the budget is too small.
void exportPage(const PageExport& request);

}  // namespace thaw
