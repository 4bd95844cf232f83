// SPDX-License-Identifier: Apache-2.0
// Entries of the restart record that may change at a restart. Changes are reported.
#pragma once
#include "core/scene/scene.hpp"
#include "io/checkpoint/checkpoint.hpp"

namespace thaw {

// Prefixes of keys.
inline constexpr const char* coefficient = "coefficient.";  ///< changes forces and energies
inline constexpr const char* setting = "setting.";  ///< leaves forces and energies of the restart unchanged
inline constexpr const char* initialPrefix = "start.";  ///< sets only how a run begins

void addCoefficients(CheckpointValues& record, const Material& material);
void addCoefficients(CheckpointValues& record, const SheetBody& body);
/// Adds its settings as well: growth, events.
void addCoefficients(CheckpointValues& record, const OrientedBody& body);
void addCoefficients(CheckpointValues& record, const Obstacle& obstacle);
/// Adds the walls at its sides and the ambient temperature.
void addCoefficients(CheckpointValues& record, const Domain& domain);
/// Adds the coefficients of forces, and the settings of solvers and steps.
void addCoefficients(CheckpointValues& record, const Numerics& numerics);

/// Adds the speed from which automatic sound speeds follow. It depends on the start, too.
void addExpectedSpeed(CheckpointValues& record, const Scene& scene);

void addSettings(CheckpointValues& record, const SurfaceSettings& surface);
void addSettings(CheckpointValues& record, const Emitter& emitter);
void addSettings(CheckpointValues& record, const Thermostat& tempering, std::size_t number);

}  // namespace thaw
