// SPDX-License-Identifier: Apache-2.0
// The keys of a scene file: one function per kind of table, used for reading, describing and recording.
#pragma once
#include "io/scene/tables/full_box.hpp"
#include "io/scene/tables/table_reader.hpp"

namespace thaw {

struct ModelPart;
struct TermTable;

/// Name of the material of a body or emitter. reported: an error was already added for the name.
struct MaterialName {
  std::string name;
  SourcePlace where;
  bool reported = false;
};

/// The same for an element of a term's list of tables. An empty name stands for all materials.
struct TermMaterial {
  MaterialName name;
  const TermTable* table;
  std::size_t index;
};

/// State of the reader besides the scene. It holds names that refer to other tables, which checkScene
/// resolves.
struct SceneReading {
  Scene* scene = nullptr;
  SourcePlace start;  ///< start of the file, for errors without a place
  SourcePlace domain, spacing;
  std::map<std::string, SourcePlace> numerics;  ///< keys of [numerics] in the scene
  bool materials = true;  ///< all materials are tables, so an unknown name is an error of its own
  OpenChoices open;       ///< choices of [numerics] that the scene leaves open
  /// one per element of Scene::bodies, emitters
  std::vector<MaterialName> bodyMaterials, emitterMaterials;
  std::vector<TermMaterial> termMaterials;
};

/// Reads all keys of a scene file.
void readSections(TableReader& top, SceneReading& reading);
/// Returns the descriptions of all keys.
std::vector<KeyDescription> sceneKeys();
/// Returns the values (SI) of a scene that a restart compares. Requires: the defaults of the scene are
/// chosen.
std::vector<KeyDescription> sceneValues(Scene scene);

/// Returns an error for each value outside of the ranges of scene files, for a scene that a program has
/// built.
std::vector<SceneError> valueErrors(Scene scene);

void readDomain(TableReader& reader, Domain& domain);
void readNumerics(TableReader& reader, Numerics& numerics);
void readSurface(TableReader& reader, SurfaceSettings& surface);
/// Reads Scene::output. Requires: the extensions are read, since frames may have their fields.
void readOutput(TableReader& reader, Scene& scene);
/// Reads the keys of Output for pictures.
void readPicture(TableReader& reader, Output& output);
void readMaterial(TableReader& reader, Material& material, SceneReading& reading);
/// Reads a list of pairs of a time and a factor.
void readInTime(TableReader& reader, const char* key, FactorInTime& factor, const char* about,
                const Range& range = notNegative());
/// Reads the keyframes of a motion, with rotations if it turns.
void readMotion(TableReader& reader, const char* about, std::vector<Keyframe>& motion, bool turns = true);
/// Converts "#rrggbb" to red | green << 8 | blue << 16. Returns false for other texts.
bool readColour(const std::string& text, std::uint32_t& colour);

/// Reads the key "colour", which no restart compares.
void readColourKey(TableReader& r, std::uint32_t& colour, const char* about);
void readBody(TableReader& reader, Body& body, SceneReading& reading);
void readOriented(TableReader& reader, OrientedBody& body, SceneReading& reading);
void readSheet(TableReader& reader, SheetBody& body, SceneReading& reading);
void readEmitter(TableReader& reader, Emitter& emitter, SceneReading& reading);
/// Reads the name of a material into `names`. checkScene finds its place in the list, from which it is
/// recorded.
void readMaterialName(TableReader& reader, const SceneReading& reading, int place,
                      std::vector<MaterialName>& names, const char* about);
/// Reads the lists of tables of all terms of the model (core/terms/terms.hpp), such as [[lamp]].
void readTermTables(TableReader& top, SceneReading& reading);
/// Reads the keys of all terms in [domain].
void readTermKeys(TableReader& reader, Domain& domain);
/// Reads the keys of all terms in [numerics].
void readTermKeys(TableReader& reader, Numerics& numerics);
/// Refuses meaningless combinations of the keys of a material. Requires: all of its keys are read.
void checkTermKeys(TableReader& reader, const Material& material, const Numerics& numerics);
/// Reads the keys in [material.NAME] of terms of heat if `heat`, else those of all other terms.
void readTermKeys(TableReader& reader, Material& material, bool heat);
/// Returns the tables and keys of a term: "[[lamp]]", "material.NAME.absorptivity".
std::vector<std::string> keysOf(const ModelPart& term);
void readObstacle(TableReader& reader, Obstacle& obstacle, SceneReading& reading);

/// Checks references, duplicates and sizes, which concern several tables. Adds to errors.
void checkScene(SceneReading& reading, std::vector<SceneError>& errors);
/// Refuses numerics.buoyancy = "boussinesq" where the weight must act.
void checkBuoyancy(const SceneReading& reading, std::vector<SceneError>& errors);
/// Refuses tables of surface tension and contact angles where the form of tension has none.
void checkTension(const Scene& scene, std::vector<SceneError>& errors);
/// Checks tension by curvature against the numerics, after their defaults are chosen. where: the place of
/// these keys.
void checkCurvature(const Scene& scene, const SourcePlace& where, std::vector<SceneError>& errors);
/// Chooses numerics.buoyancy where it is automatic. Where the hydrostatic part is subtracted, gravity becomes
/// Domain::buoyantGravity.
void chooseBuoyancy(Scene& scene);
/// Refuses settings that do not work with rigid materials.
void checkRigid(const SceneReading& reading, std::vector<SceneError>& errors);
/// Checks sheets against the rest of the scene.
void checkSheets(const Scene& scene, std::vector<SceneError>& errors);
/// Checks events of oriented bodies and finds the other bodies of welds. Refuses events of bodies that an
/// earlier weld has merged into another body.
void checkOrientedEvents(SceneReading& reading, std::vector<SceneError>& errors);
/// Refuses a spacing too fine for any machine, or a domain too large for its cells. Adds one message, with
/// the number of particles if these are too many.
void checkSizes(const SceneReading& reading, std::vector<SceneError>& errors);

}  // namespace thaw
