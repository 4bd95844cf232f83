// SPDX-License-Identifier: Apache-2.0
// The restart record: quantities of a scene, compared between a checkpoint and the run that continues it.
#pragma once
#include <string>
#include <vector>

#include "core/scene/scene.hpp"
#include "io/checkpoint/checkpoint.hpp"

namespace thaw {

/// Returns the quantities of a scene (SI) by the key that sets them; every checkpoint has them. Particles,
/// frames and ledger depend on most of them, which must not change: spacing, support, domain, gravity,
/// periods, frame interval, seed, the order of materials, bodies and emitters ("body.bust" = 0), and the
/// geometry of bodies, sheets and oriented bodies. The others may change (restart_coefficients.hpp).
/// Quantities without an entry (end, fields of frames, the stability monitor) may change without a report.
/// Requires: fingerprintMeshes.
CheckpointValues restartRecordOf(const Scene& scene);

/// Returns a line for each difference that prevents a restart: "spacing was 0.01, and is 0.02 now".
std::vector<std::string> restartConflicts(const CheckpointValues& stored, const Scene& scene);

/// Returns a line for each change at which forces and energies jump: coefficients of materials, sheets,
/// oriented bodies, obstacles and walls, and choices of numerics.
std::vector<std::string> coefficientChanges(const CheckpointValues& stored, const Scene& scene);

/// Returns a line for each change that leaves forces and energies as they are: settings of the surface,
/// growth of oriented bodies, future events, steps and solvers.
std::vector<std::string> settingChanges(const CheckpointValues& stored, const Scene& scene, double time);

/// Returns a line for each change of an event that was before `time` (s) in both scenes. It has no effect.
std::vector<std::string> pastEventChanges(const CheckpointValues& stored, const Scene& scene, double time);

/// Returns a line for each change of the start of bodies. It has no effect.
std::vector<std::string> initialStateChanges(const CheckpointValues& stored, const Scene& scene);

}  // namespace thaw
