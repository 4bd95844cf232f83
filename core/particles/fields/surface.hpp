// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>

#include "core/fields/field_group.hpp"

namespace thaw {

/// Fields of the surface (core/surface/).
struct SurfaceFields : FieldGroup {
  using FieldGroup::FieldGroup;
  // clang-format off
  Column<Vec3d> surfacePosition{table, "surfacePosition", "m", Keep::State,
      "position at the last update of the surface"};
  Column<Vec3d> surfaceStartPosition{table, "surfaceStartPosition", "m", Keep::State,
      "position when the surface was created; only in scenes with solids"};
  Column<std::uint64_t> component{table, "component", "1", Keep::State,
      "label: 1 + smallest particle id of its component; 0: created after the last update"};
  Column<double> surfaceVolumeRatio{table, "surfaceVolumeRatio", "1", Keep::State,
      "volume that the surface encloses for it, over its own volume: from the mesh or shape of its body at "
      "the start; 0: its own volume"};
  Column<float> initialFill{table, "initialFill", "1", Keep::State,
      "fraction of its cell that its body filled at the start, over the mean (cell_fractions.hpp); 0: the "
      "mean"};
  // clang-format on
};

}  // namespace thaw
