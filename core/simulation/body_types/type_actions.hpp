// SPDX-License-Identifier: Apache-2.0
// Functions that are specific to a body type: set-up, and treatment of rows that leave or migrate.
#pragma once
#include <array>
#include <cstdint>
#include <span>

#include "core/halo/halos.hpp"
#include "core/particles/body_types.hpp"
#include "core/scene/scene_warning.hpp"
#include "core/simulation/world/world.hpp"

namespace thaw {

struct SamplingOfTypes {
  Halos halos;
  const MeshLoader& load;
  std::vector<SceneWarning>& warnings;
  /// m, positions of each oriented body's particles, on all ranks
  std::vector<std::vector<Vec3d>> positions;
};

/// Functions of a body type. Functions of rows are called only in scenes with the type. Null: nothing to do.
struct TypeActions {
  bool (*isOn)(const World&) = nullptr;
  void (*activate)(World&) = nullptr;                  ///< activates the columns
  void (*sample)(World&, SamplingOfTypes&) = nullptr;  ///< appends this rank's rows; collective
  bool leavesAtSides = true;                           ///< false: the type removes its rows itself
  /// Called before rows are removed. dt: s, length of the last step.
  void (*beforeRemoval)(World&, std::span<const std::uint32_t> rows, double dt) = nullptr;
  void (*afterRemoval)(World&, bool removed) = nullptr;
  /// Migrates data of rows outside of their table. Collective.
  void (*migrateMore)(World&, Halos&, const Migration&) = nullptr;
  void (*clear)(World&) = nullptr;  ///< clears data of removed rows outside of their table
};

/// Returns the actions of all types, by their number.
const std::array<TypeActions, bodyTypeCount>& typeActions();

}  // namespace thaw
