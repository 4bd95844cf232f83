// SPDX-License-Identifier: Apache-2.0
// Keys of contact conductance, evaporation and mush of a material.
#pragma once
#include "core/scene/scene.hpp"
#include "io/scene/tables/table_reader.hpp"

namespace thaw {

void readHeatExchange(TableReader& reader, Material& material);

/// Refuses meaningless combinations. paper: the scene has the paper's heat model.
void checkHeatExchange(TableReader& reader, const Material& material, bool paper);

}  // namespace thaw
