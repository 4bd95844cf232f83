// What a sheet is wrapped round: an obstacle, or a body of any kind (DS section 3.1).
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "core/scene/scene.hpp"

namespace thaw {

enum class WrapKind : std::uint8_t { Normal, Obstacle, Continuum, Oriented, Sheet };

/// index: into the scene's obstacles, its bodies and then emitters, its oriented bodies, its sheets. Normal:
/// the sheet is drawn against its own normals.
struct WrapTarget {
  WrapKind kind = WrapKind::Normal;
  std::uint16_t index = 0;
  bool operator==(const WrapTarget&) const = default;
};

/// All that a name of wrap_to may mean: none, or several of different kinds.
std::vector<WrapTarget> wrapTargets(const Scene& scene, const std::string& name);

/// That of a sheet. Throws ShapeError where its name means nothing, two things, or the sheet itself.
WrapTarget wrapTarget(const Scene& scene, std::size_t sheet);

}  // namespace thaw
