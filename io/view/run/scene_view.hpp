// SPDX-License-Identifier: Apache-2.0
// The scene of a run, for the page: camera, colours, domain and obstacles.
#pragma once
#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "core/scene/scene.hpp"
#include "io/view/frames/packet.hpp"

namespace thaw {

/// Reads the scene that a run stores in its frames, without their rows. Throws IoError for the file and
/// SceneErrors for the text.
Scene sceneOfFrame(const std::filesystem::path& frame);

/// Returns title, spacing, end, domain, camera (null if fitted), colour field and range.
nlohmann::ordered_json sceneView(const Scene& scene);

/// Returns the obstacles at rest: look, colour, and triangles, or point and normal of a plane. One that
/// cannot be shown has a `problem`, such as a missing mesh.
Packet obstacleMeshes(const Scene& scene);

/// Returns the lines of emitters, clamps and the camera: `position`, two rows for each line. The header has
/// kind, name, first line and number of lines of each mark.
Packet markLines(const Scene& scene);

/// Returns whether each obstacle is present at a time (s), and its pose: x = move + rotation x_rest.
nlohmann::ordered_json obstaclePoses(const Scene& scene, double time);

}  // namespace thaw
