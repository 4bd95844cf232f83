// Where in its files a scene says what its marks hold.
#pragma once
#include <string>

#include "core/scene/scene.hpp"

namespace thaw {

/// " (scene.toml:14)": the line of the table, as small as possible, that has the key with which a text begins
/// ("sheet.c.region.0.point.x was ..."); "" where none is known.
std::string placeOfMark(const Scene& scene, const std::string& text);

}  // namespace thaw
