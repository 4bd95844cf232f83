// SPDX-License-Identifier: Apache-2.0
// Types of failure, and the bounds beyond which a step has failed (core/simulation/monitor/monitor.hpp).
#pragma once
#include "core/scene/scene.hpp"

namespace thaw {

/// Types of failure. NotFinite: also for a particle that would move by more than its support radius in a
/// step. Energy: unexplained gain since the last snapshot. Growth: unexplained gain since the run began,
/// however slow.
enum class Failure { None, NotFinite, Speed, Density, Step, Inverted, Energy, Growth };

/// Limits of the scene, constant over the run. `never` or 0: not monitored.
struct MonitorLimits {
  double expected = 0;   ///< m/s, largest speed due to initial motion, gravity, emitters and obstacles, or a
                         ///< tenth of the slowest wave speed
  double speed = never;  ///< m/s
  double relativeDensity = never;  ///< 1, relative density of a liquid
  double step = 0;  ///< s, shortest allowed step: a fraction of the smaller of the materials' limit and the
                    ///< limit of the expected speed
  double inverted = never;  ///< 1, fraction of the solid particles whose law cannot recover
  double energy = never;    ///< 1, relative to the energy scale
};

}  // namespace thaw
