#pragma once
#include <string>
#include <utility>
#include <vector>

#include <toml++/toml.h>

#include "io/scene/scene_files.hpp"
#include "io/scene/table_reader.hpp"

namespace thaw {

inline constexpr int deepestInclude = 16;

/// Paths that a parsed file includes, with their places; what is no path is an error (if there is a list for
/// errors).
std::vector<std::pair<std::string, SourcePlace>> includesOf(const toml::table& file, const std::string& path,
                                                            std::vector<SceneError>* errors);

/// One table of the scene: includes merged (what the including file says wins; lists of bodies, emitters and
/// obstacles are joined, the included ones first), overrides applied, paths of meshes made absolute. Nodes
/// keep their place in their file; those of overrides have the file "--set key=value". Problems go to errors;
/// what could be read is in the table.
toml::table resolveScene(const SceneFiles& files, const std::vector<std::string>& overrides,
                         std::vector<SceneError>& errors);

/// Puts the value of "key=value" where the dotted key says, making tables on the way: `spacing=1 mm`,
/// `material.wax.young=1 MPa`, `body.bust.mesh=x.ply` or `body.0.velocity=[0, 0, 1]` (a list's table by its
/// name or number). A value that is not TOML is a text.
void applyOverride(toml::table& top, const std::string& setting, std::vector<SceneError>& errors);

}  // namespace thaw
