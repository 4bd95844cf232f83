// SPDX-License-Identifier: Apache-2.0
// The page as one file without a server: its scripts and data are within it.
#pragma once
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <utility>
#include <vector>

namespace thaw {

struct PageData {
  /// By name: "run" (state, frames, scene, logs; JSON), "obstacles" and "marks" (packets), and
  /// "NUMBER-TYPE" (frame_block.hpp). All are compressed.
  std::vector<std::pair<std::string, std::string>> blocks;
  void add(const std::string& name, std::string stream) { blocks.emplace_back(name, std::move(stream)); }
  void addJson(const std::string& name, const nlohmann::ordered_json& json);
};

/// Bytes that a block takes in the page.
std::uint64_t bytesInPage(const std::string& stream);

/// Returns why this program cannot make pages and how to get it, or "".
std::string pageProblem();

/// Returns the page. Requires: pageProblem() is empty.
std::string pageText(const std::string& title, const PageData& data);

}  // namespace thaw
