// SPDX-License-Identifier: Apache-2.0
// Lines for the parts of a scene without particles: emitters, clamps, the domain, the camera.
#pragma once
#include <array>
#include <string>
#include <vector>

#include "core/scene/scene.hpp"

namespace thaw {

enum class MarkKind { Emitter, Clamp, Domain, Camera };
inline constexpr std::array<const char*, 4> markNames{"emitters", "clamps", "domain", "camera"};

struct Mark {
  MarkKind kind = MarkKind::Domain;
  std::string name;                         ///< name of the emitter or the body; else empty
  std::vector<std::array<Vec3d, 2>> lines;  ///< m, ends
};

/// Returns the opening of each emitter with an arrow along its flow, and the box around each clamp within its
/// body. Also the box of the domain, and the scene's camera with its line of sight. Throws like
/// makeSignedDistance for invalid shapes.
std::vector<Mark> sceneMarks(const Scene& scene);

}  // namespace thaw
