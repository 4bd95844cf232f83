// What a scene says that has no effect, or is far from all use: allowed, and told.
#pragma once
#include <string>
#include <vector>

#include "core/scene/scene.hpp"

namespace thaw {

/// A line each, with file and line of the scene: events and fields of oriented bodies after its end, fields
/// of frames that nothing in it has, materials of nothing, temperatures near 0 K, settings of the surface
/// (surface_advice.hpp).
std::vector<std::string> sceneWarnings(const Scene& scene);

/// One line for a sentence about a place in the scene.
std::string warningLine(const SourcePlace& where, const std::string& text);

/// That an event of an oriented body has met nothing.
std::string idleEventLine(const OrientedBody& body, const OrientedEvent& event);

/// That a field of an oriented body begins where no particle is.
std::string idleFieldLine(const OrientedBody& body, const OrientedField& field);

/// That particles of an oriented body have come into a body, by this time (s).
std::string sunkenLine(const OrientedBody& oriented, const Body& body, std::int64_t count, double time);
std::string sunkenLine(const OrientedBody& oriented, const Obstacle& obstacle, std::int64_t count,
                       double time);

}  // namespace thaw
