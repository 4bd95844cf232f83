// The keys of a scene file: one function for each kind of table, used for reading and for describing.
#pragma once
#include "io/scene/full_box.hpp"
#include "io/scene/table_reader.hpp"

namespace thaw {

/// The name of a material that something is made of. told: a message has said that it is no name.
struct MaterialName {
  std::string name;
  SourcePlace where;
  bool told = false;
};

/// What reading needs beside the scene: names that refer to what is defined elsewhere, resolved by
/// checkScene.
struct SceneReading {
  Scene* scene = nullptr;
  SourcePlace start;  ///< of the file, for what has no place of its own
  SourcePlace domain, spacing;
  bool materials = true;  ///< all of them are tables: a name without one is a mistake of its own
  OpenChoices open;       ///< of [numerics], that the scene leaves to us
  /// beside Scene::bodies, emitters, temperings
  std::vector<MaterialName> bodyMaterials, emitterMaterials, temperingMaterials;
};

/// All keys of a scene file.
void readSections(TableReader& top, SceneReading& reading);
/// What they are.
std::vector<KeyDescription> sceneKeys();
/// The keys that say what a sheet's mesh is, by SheetMesh.
const std::vector<std::string>& sheetMeshWords();

void readDomain(TableReader& reader, Domain& domain);
void readNumerics(TableReader& reader, Numerics& numerics);
void readSurface(TableReader& reader, SurfaceSettings& surface);
void readOutput(TableReader& reader, Output& output);
void readMaterial(TableReader& reader, Material& material);
/// A list of pairs of a time and a factor.
void readInTime(TableReader& reader, const char* key, FactorInTime& factor, const char* about,
                const Range& range = notNegative());
/// "#rrggbb" into red | green << 8 | blue << 16; false if it is something else.
bool readColour(const std::string& text, std::uint32_t& colour);
void readBody(TableReader& reader, SceneReading& reading);
void readOriented(TableReader& reader, SceneReading& reading);
void readSheet(TableReader& reader, SceneReading& reading);
void readEmitter(TableReader& reader, SceneReading& reading);
void readTempering(TableReader& reader, SceneReading& reading);
void readObstacle(TableReader& reader, SceneReading& reading);

/// What no single table can tell: references, duplicates, sizes. Adds to errors.
void checkScene(SceneReading& reading, std::vector<SceneError>& errors);
/// The same of sheets.
void checkSheets(const Scene& scene, std::vector<SceneError>& errors);
/// Of events of oriented bodies: the bodies that welds name, which it looks up, and what is left of them by
/// then.
void checkOrientedEvents(SceneReading& reading, std::vector<SceneError>& errors);
/// A spacing far too fine for any machine, or a domain too large for its cells: one message, with the number
/// of particles where it is they that are too many.
void checkSizes(const SceneReading& reading, std::vector<SceneError>& errors);

}  // namespace thaw
