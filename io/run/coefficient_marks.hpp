// Marks of what may change between a checkpoint and the run that continues it, and is told then.
#pragma once
#include "core/scene/scene.hpp"
#include "io/output/checkpoint.hpp"

namespace thaw {

// beginnings of their keys
inline constexpr const char* coefficient = "coefficient.";  ///< forces and energies follow from it
inline constexpr const char* setting = "setting.";          ///< they do not, at once
inline constexpr const char* ofStart = "start.";            ///< says only how a run begins

void addCoefficients(CheckpointValues& marks, const Material& material);
void addCoefficients(CheckpointValues& marks, const SheetBody& body);
/// With its settings: growth, events.
void addCoefficients(CheckpointValues& marks, const OrientedBody& body);
void addCoefficients(CheckpointValues& marks, const Obstacle& obstacle);
/// Walls at its sides, and what is around.
void addCoefficients(CheckpointValues& marks, const Domain& domain);
/// Those of which forces are made, and with them the settings of its solvers and steps.
void addCoefficients(CheckpointValues& marks, const Numerics& numerics);

/// The speed that automatic sound speeds follow from: it depends on the start, too.
void addExpectedSpeed(CheckpointValues& marks, const Scene& scene);

void addSettings(CheckpointValues& marks, const SurfaceSettings& surface);
void addSettings(CheckpointValues& marks, const Emitter& emitter);
void addSettings(CheckpointValues& marks, const Tempering& tempering, std::size_t number);

}  // namespace thaw
