// What of oriented bodies and sheets may be meant, but seldom is, at the start of a scene.
#pragma once
#include <memory>
#include <string>
#include <vector>

#include "core/geometry/signed_distance.hpp"
#include "core/halo/halo.hpp"
#include "core/world.hpp"

namespace thaw {

/// A sentence about something that the scene says, with its place.
struct SceneWarning {
  SourcePlace where;
  std::string text;
};

/// Of sampled bodies, before the first step: sheets that are clamped as a whole, or far thicker than their
/// vertices are apart; vertices and particles that begin inside a liquid body (`shapes`: those of
/// Scene::bodies; inside a solid one is a problem unless numerics.overlap is "keep"), deep in an obstacle's
/// contact, sheets within their contact with anything (start_contacts.hpp), or in the contact with another
/// sheet or oriented body (`oriented`: the places of all their particles). Walls as at time 0. The same on
/// any number of ranks. Collective.
std::vector<SceneWarning> kindStartWarnings(const World& world,
                                            const std::vector<std::shared_ptr<const SignedDistance>>& shapes,
                                            const std::vector<std::vector<Vec3d>>& oriented, Reducer& all,
                                            SceneProblems& problems);

}  // namespace thaw
