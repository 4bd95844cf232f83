// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>
#include <utility>
#include <vector>

#include <toml++/toml.h>

#include "io/scene/scene_files.hpp"
#include "io/scene/tables/table_reader.hpp"

namespace thaw {

inline constexpr int deepestInclude = 16;

/// Returns the paths that a parsed file includes, with their places. Adds errors for other values, if
/// `errors` is not nullptr.
std::vector<std::pair<std::string, SourcePlace>> includesOf(const toml::table& file, const std::string& path,
                                                            std::vector<SceneError>* errors);

/// Returns one table of the scene: includes merged, overrides applied, paths of meshes absolute. Keys of the
/// including file take precedence; lists of bodies, emitters and obstacles are joined, the included ones
/// first. Nodes keep their place in their file; those of overrides have the file "--set key=value". Adds to
/// errors; the table has everything that could be read.
toml::table resolveScene(const SceneFiles& files, const std::vector<std::string>& overrides,
                         std::vector<SceneError>& errors);

/// Sets the dotted key of "key=value" to the value and makes missing tables. Examples: `spacing=1 mm`,
/// `material.wax.young=1 MPa`, `body.bust.mesh=x.ply`, `body.0.velocity=[0, 0, 1]`. An entry of a list has
/// its name or number. A value that is not TOML is a text.
void applyOverride(toml::table& top, const std::string& setting, std::vector<SceneError>& errors);

}  // namespace thaw
