// SPDX-License-Identifier: Apache-2.0
// Warnings of valid settings that have no effect or unusual values.
#pragma once
#include <string>
#include <vector>

#include "core/scene/scene.hpp"

namespace thaw {

/// Returns a line for each warning, with file and line of the scene. Topics are events and fields of oriented
/// bodies after its end, fields of frames without use, and unused materials. Others are temperatures near
/// 0 K, and settings of the surface (surface_advice.hpp).
std::vector<std::string> sceneWarnings(const Scene& scene);

/// Returns a line with a place in the scene and a sentence.
std::string warningLine(const SourcePlace& where, const std::string& text);

/// Returns the warning of an event of an oriented body that affects no particle.
std::string unusedEventLine(const OrientedBody& body, const OrientedEvent& event);

/// Returns the warning of a field of an oriented body that begins without particles.
std::string unusedFieldLine(const OrientedBody& body, const OrientedField& field);

/// Returns the warning of particles of an oriented body inside another body, at this time (s).
std::string interpenetrationLine(const OrientedBody& oriented, const Body& body, std::int64_t count,
                                 double time);
std::string interpenetrationLine(const OrientedBody& oriented, const Obstacle& obstacle, std::int64_t count,
                                 double time);

}  // namespace thaw
