// Entries of the restart record that may change at a restart. Changes are reported.
#pragma once
#include "core/scene/scene.hpp"
#include "io/output/checkpoint.hpp"

namespace thaw {

// Prefixes of keys.
inline constexpr const char* coefficient = "coefficient.";  ///< changes forces and energies
inline constexpr const char* setting = "setting.";  ///< leaves forces and energies of the restart unchanged
inline constexpr const char* ofStart = "start.";    ///< sets only how a run begins

void addCoefficients(CheckpointValues& marks, const Material& material);
void addCoefficients(CheckpointValues& marks, const SheetBody& body);
/// Adds its settings as well: growth, events.
void addCoefficients(CheckpointValues& marks, const OrientedBody& body);
void addCoefficients(CheckpointValues& marks, const Obstacle& obstacle);
/// Adds the walls at its sides and the ambient temperature.
void addCoefficients(CheckpointValues& marks, const Domain& domain);
/// Adds the coefficients of forces, and the settings of solvers and steps.
void addCoefficients(CheckpointValues& marks, const Numerics& numerics);

/// Adds the speed from which automatic sound speeds follow. It depends on the start, too.
void addExpectedSpeed(CheckpointValues& marks, const Scene& scene);

void addSettings(CheckpointValues& marks, const SurfaceSettings& surface);
void addSettings(CheckpointValues& marks, const Emitter& emitter);
void addSettings(CheckpointValues& marks, const Tempering& tempering, std::size_t number);

}  // namespace thaw
