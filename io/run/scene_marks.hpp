// What of a scene may not change between a checkpoint and the run that continues it.
#pragma once
#include <string>
#include <vector>

#include "core/scene/scene.hpp"
#include "io/output/checkpoint.hpp"

namespace thaw {

/// The quantities of a scene (SI) by the key that sets them. Those that its particles, frames and ledger rest
/// on: spacing, support, domain, gravity, periods, frame interval, seed, the order of materials, bodies and
/// emitters ("body.bust" = 0), and all that bodies, sheets and oriented bodies are made of; meshes by their
/// contents (markMeshes comes first). And those that may change (coefficient_marks.hpp). What is not among
/// them (end, fields of frames, the watch) may change without a word. Kept in every checkpoint.
CheckpointValues sceneMarks(const Scene& scene);

/// What differs between a checkpoint's marks and those of a scene, a line each: "spacing was 0.01, and is
/// 0.02 now". Empty: it can continue.
std::vector<std::string> sceneDifferences(const CheckpointValues& stored, const Scene& scene);

/// What may change and is told, since forces and energies jump there: the coefficients of materials, sheets,
/// oriented bodies, obstacles, walls, and choices of numerics. A line each, as above.
std::vector<std::string> coefficientChanges(const CheckpointValues& stored, const Scene& scene);

/// What may change and is told, but leaves forces and energies as they are: how surfaces are kept, how
/// oriented bodies grow, events to come, steps and solvers. A line each, as above.
std::vector<std::string> settingChanges(const CheckpointValues& stored, const Scene& scene, double time);

/// Of events that were before this time, then and now: they have no effect any more. A line each, as above.
std::vector<std::string> changesOfPastEvents(const CheckpointValues& stored, const Scene& scene, double time);

/// What has changed and says only how bodies begin, so that it is without effect now. A line each, as above.
std::vector<std::string> changesOfTheStart(const CheckpointValues& stored, const Scene& scene);

}  // namespace thaw
