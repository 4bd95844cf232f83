#pragma once
#include <map>

#include "io/scene/table_reader.hpp"

namespace thaw {

/// What reading needs beside the scene: names that refer to what is defined elsewhere.
struct SceneReading {
  Scene* scene = nullptr;
  std::string folder;  ///< of the file that is read
  std::vector<std::pair<std::string, SourcePlace>> bodyMaterials, emitterMaterials;  ///< beside Scene::bodies, emitters
};

/// All keys of a scene file.
void readSections(TableReader& top, SceneReading& reading);

/// What no single key can tell: references, combinations, duplicates.
void checkScene(SceneReading& reading, std::vector<SceneError>& errors);

}  // namespace thaw
