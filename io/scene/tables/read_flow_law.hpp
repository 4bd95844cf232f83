// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "core/scene/scene.hpp"
#include "io/scene/tables/table_reader.hpp"

namespace thaw {

struct TemperatureKey {
  const char *key, *unit;
  Range range;
  const char* about;
};
/// Reads a quantity, or a list of pairs of temperatures and quantities.
void readByTemperature(TableReader& reader, const TemperatureKey& key, TemperatureTable& table);

/// Reads [material.NAME.flow]. Refuses keys that the law does not have. Requires: the other keys of the
/// material.
void readFlowLaw(TableReader& material, Material& m);

}  // namespace thaw
