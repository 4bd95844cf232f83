// SPDX-License-Identifier: Apache-2.0
// Keys of the body forces, sources of heat and pair forces of the library (core/domain/terms.hpp).
#pragma once
#include "io/scene/tables/read_sections.hpp"

namespace thaw {

struct ModelPart;

/// Reads the lists of tables of all terms, such as [[lamp]].
void readTermTables(TableReader& top, SceneReading& reading);
/// Reads their keys in [domain].
void readTermKeys(TableReader& reader, Domain& domain);
/// Reads their keys in [material.NAME].
void readTermKeys(TableReader& reader, Material& material);

/// Returns the tables and keys of a term: "[[lamp]]", "material.NAME.absorptivity".
std::vector<std::string> keysOf(const ModelPart& term);

}  // namespace thaw
