// SPDX-License-Identifier: Apache-2.0
// Shapes of extensions (core/terms/extensions.hpp), by name.
#pragma once
#include <functional>
#include <memory>
#include <string>

#include "core/geometry/basic/signed_distance.hpp"

namespace thaw {

/// Creates the shape in its own frame from the values of its keys. `place` in the scene then scales, rotates
/// and moves the shape. Errors: ShapeError or std::invalid_argument.
using ShapeMaker = std::function<std::shared_ptr<const SignedDistance>(const ExtensionSettings&)>;

/// Registers a shape under its name.
void addExtensionShape(const std::string& name, ShapeMaker make);
/// Returns the maker with this name, or null.
const ShapeMaker* findExtensionShape(const std::string& name);

}  // namespace thaw
