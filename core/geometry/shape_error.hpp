// What is wrong with a shape or a mesh, and where the scene said so.
#pragma once
#include <stdexcept>
#include <string>

#include "core/scene/scene.hpp"

namespace thaw {

/// Thrown for shapes and meshes that cannot be used. what() is one sentence that says what was expected, without the place.
struct ShapeError : std::runtime_error {
  explicit ShapeError(const std::string& message, SourcePlace place = {}) : std::runtime_error(message), where(std::move(place)) {}
  SourcePlace where;  ///< of the shape in the scene; empty file: not known
};

}  // namespace thaw
