// SPDX-License-Identifier: Apache-2.0
// The restart record: values of the keys of a scene, compared between a checkpoint and the run that continues
// it. The reader of the scene declares which keys it has (io/scene/tables/table_reader.hpp).
#pragma once
#include <string>
#include <vector>

#include "core/scene/scene.hpp"
#include "io/checkpoint/checkpoint.hpp"

namespace thaw {

/// Returns the record of a scene; every checkpoint has it. Keys: the effect of a change (Restart) and the
/// path in the scene, as "coefficient.material.wax.density". Values: text as in a scene file (SI). Long texts
/// and meshes are checksums, as are the elements of a list beyond its first hundred.
/// Requires: fingerprintMeshes.
CheckpointValues restartRecordOf(const Scene& scene);

/// Returns a line for each difference that prevents a restart: "spacing: 0.01 -> 0.02 m".
std::vector<std::string> restartConflicts(const CheckpointValues& stored, const Scene& scene);

/// Returns a line for each change at which forces and energies jump: coefficients of materials, sheets,
/// oriented bodies, obstacles and walls, and choices of numerics.
std::vector<std::string> coefficientChanges(const CheckpointValues& stored, const Scene& scene);

/// Returns a line for each change that does not affect present forces and energies. Such changes are
/// settings of the surface, growth of oriented bodies, future events, steps and solvers.
std::vector<std::string> settingChanges(const CheckpointValues& stored, const Scene& scene, double time);

/// Returns a line for each change of an event that was before `time` (s) in both scenes. Such changes have no
/// effect.
std::vector<std::string> pastEventChanges(const CheckpointValues& stored, const Scene& scene, double time);

/// Returns a line for each change of the initial state of bodies. Such changes have no effect.
std::vector<std::string> initialStateChanges(const CheckpointValues& stored, const Scene& scene);

/// Returns " (scene.toml:14)": the line of the smallest table whose key begins the text
/// ("sheet.c.region.0.plane.point: ..."). Returns "" if none is known.
std::string placeOfRecordKey(const Scene& scene, const std::string& text);

}  // namespace thaw
