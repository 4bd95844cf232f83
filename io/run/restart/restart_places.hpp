// SPDX-License-Identifier: Apache-2.0
// Source lines of the entries of the restart record.
#pragma once
#include <string>

#include "core/scene/scene.hpp"

namespace thaw {

/// Returns " (scene.toml:14)": the line of the smallest table whose key begins the text
/// ("sheet.c.region.0.point.x was ..."). Returns "" if none is known.
std::string placeOfRecordKey(const Scene& scene, const std::string& text);

}  // namespace thaw
