// SPDX-License-Identifier: Apache-2.0
// Target of a sheet's shrink-wrap: an obstacle, or a body of any type (DS section 3.1).
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "core/scene/scene.hpp"

namespace thaw {

enum class ShrinkWrapKind : std::uint8_t { Normal, Obstacle, Continuum, Oriented, Sheet };

/// Target of a shrink-wrap. index: into the scene's obstacles, its bodies followed by emitters, its oriented
/// bodies, or its sheets. Normal: the shrink-wrap acts against the sheet's own normals.
struct ShrinkWrapTarget {
  ShrinkWrapKind kind = ShrinkWrapKind::Normal;
  std::uint16_t index = 0;
  bool operator==(const ShrinkWrapTarget&) const = default;
};

/// Returns all targets that match a name in shrink_wrap_to, possibly none or several.
std::vector<ShrinkWrapTarget> shrinkWrapTargets(const Scene& scene, const std::string& name);

/// Returns the target of a sheet. Throws ShapeError if its name is unknown, ambiguous, or the sheet itself.
ShrinkWrapTarget shrinkWrapTarget(const Scene& scene, std::size_t sheet);

}  // namespace thaw
