// SPDX-License-Identifier: Apache-2.0
// Target of a sheet's shrink-wrap: an obstacle, or a body of any type (DS section 3.1).
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "core/scene/scene.hpp"

namespace thaw {

enum class WrapKind : std::uint8_t { Normal, Obstacle, Continuum, Oriented, Sheet };

/// index: into the scene's obstacles, its bodies and then emitters, its oriented bodies, its sheets. Normal:
/// the wrap acts against the sheet's own normals.
struct WrapTarget {
  WrapKind kind = WrapKind::Normal;
  std::uint16_t index = 0;
  bool operator==(const WrapTarget&) const = default;
};

/// Returns all targets that a name of shrink_wrap_to may mean, none or several.
std::vector<WrapTarget> wrapTargets(const Scene& scene, const std::string& name);

/// Returns the target of a sheet. Throws ShapeError if its name is unknown, ambiguous, or the sheet itself.
WrapTarget wrapTarget(const Scene& scene, std::size_t sheet);

}  // namespace thaw
