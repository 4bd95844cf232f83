// What of a scene may not change between a checkpoint and the run that continues it.
#pragma once
#include <string>
#include <vector>

#include "core/scene/scene.hpp"
#include "io/output/checkpoint.hpp"

namespace thaw {

/// The quantities of a scene (SI) that its particles, frames and ledger rest on, by the key that sets them: spacing, support, domain, gravity,
/// periods, frame interval, seed, and the order of materials, bodies and emitters ("body.bust" = 0). Everything else (end, properties of
/// materials, obstacles, time step factors, fields of frames) may be changed when a run continues. Kept in every checkpoint.
CheckpointValues sceneMarks(const Scene& scene);

/// What differs between a checkpoint's marks and those of a scene, a line each: "spacing was 0.01, and is 0.02 now". Empty: it can continue.
std::vector<std::string> sceneDifferences(const CheckpointValues& stored, const Scene& scene);

/// What may change and is told, since forces and energies jump there: the coefficients of materials, sheets and oriented bodies. A line each, as above.
std::vector<std::string> coefficientChanges(const CheckpointValues& stored, const Scene& scene);

/// What may change and is told, but leaves forces and energies as they are: how surfaces are kept, and how oriented bodies grow. A line each, as above.
std::vector<std::string> settingChanges(const CheckpointValues& stored, const Scene& scene);

/// What has changed and says only how bodies begin, so that it is without effect now. A line each, as above.
std::vector<std::string> changesOfTheStart(const CheckpointValues& stored, const Scene& scene);

}  // namespace thaw
