// SPDX-License-Identifier: Apache-2.0
// Registry of the parts of the model that scenes select by name, with declared keys. These are forces, heat
// sources, fields, forces between particles, elastic laws and shapes, of the library and of programs.
#pragma once
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/fluid/pair_sums/extension_pair_force.hpp"
#include "core/geometry/basic/extension_shape.hpp"
#include "core/scene/scene.hpp"
#include "core/solid/laws/elastic_law.hpp"
#include "core/terms/field_update.hpp"
#include "core/terms/model_part.hpp"
#include "core/terms/outside_forces.hpp"

namespace thaw {

/// A key of an extension's table: a number with a unit.
struct ExtensionKey {
  std::string name, unit;               ///< unit in SI, "" for none
  double standard = 0;                  ///< value in SI if the scene does not set the key
  double least = -never, most = never;  ///< range in SI; values outside are refused with their place
  std::string about = {};               ///< one line
};

/// A field of particles, of doubles. It is sorted, migrated, in checkpoints, and in frames if output.fields
/// lists it.
struct ExtensionField {
  std::string name = {}, unit = {}, about = {};  ///< unit in SI, "1" for none
  int components = 1;
  double start = 0;     ///< value of all components in particles of bodies and emitters
  bool ghosts = false;  ///< forces between particles read it
};

/// A named extension with keys. Scenes that name it are refused by programs that have not registered it, also
/// at a restart. A scene names it by
/// - [extension.NAME]: its load, fields, pair force;
/// - material.LABEL.law = "NAME": its law, whose keys are in [material.LABEL.NAME];
/// - NAME = { keys } where a shape is expected: its shape.
/// A term of the library has a model part instead, with keys in the scene's own tables. An extension may have
/// several of these parts, and its keys apply to all of them.
struct Extension {
  std::string name = {};   ///< letters, digits, _
  std::string about = {};  ///< one line
  std::vector<ExtensionKey> keys = {};
  /// Creates the force (N) or heat source (W) from the scene's values (OutsideLoad).
  std::function<OutsideSource(const ExtensionSettings&)> load = {};
  /// Longest stable step (s) for these values. Empty: no limit. Kick-drift-kick leap-frog (SP05) is stable
  /// below 2 / omega for the highest frequency omega (1/s); a tenth of it is accurate.
  std::function<double(const ExtensionSettings&)> stepLimit = {};
  std::vector<ExtensionField> fields = {};
  /// Creates the function that updates the fields. Empty: only loads and hooks change them.
  std::function<FieldUpdate(const ExtensionSettings&)> update = {};
  PairForce pairForce = {};  ///< with kernels; a function on lanes gives N/m, J, W (PairResult)
  ElasticLaw law = {};       ///< with kernels or response; energy density and first Piola stress, Pa (C88)
  ShapeMaker shape = {};     ///< makes a signed distance, m
  bool heats = false;        ///< its load adds heat: a scene that names it has heat
  bool builtIn = false;      ///< in the library: all programs have it
  std::optional<ModelPart> model = {};  ///< with keys in the scene's own tables; for the library alone

  /// Returns true if it has a part that [extension.NAME] turns on.
  bool usesTable() const { return !model && (load || !fields.empty() || update || pairForce.kernels.sum); }
  bool hasLaw() const { return law.kernels.lanes || law.response; }
};

/// Makes an extension known to all scenes that are read afterwards. Throws std::invalid_argument for a
/// name that is taken or malformed, and for an extension without parts. Also throws it for a shape with the
/// name of a shape of the library.
void registerExtension(Extension extension);

/// Returns the extension of that name, or null.
const Extension* findExtension(const std::string& name);
/// Returns the extension with a field of that name, or null.
const Extension* findFieldOwner(const std::string& field);
/// Returns the extensions of programs that a scene names, each once. Throws std::invalid_argument for one
/// that is not registered.
std::vector<const Extension*> usedExtensions(Scene& scene);
/// Returns the names of the extensions for which `has` is true, in order.
std::vector<std::string> extensionNames(const std::function<bool(const Extension&)>& has);
/// Returns the names of all elastic laws: those of the library in the order of their table, then others.
std::vector<std::string> lawNames();
/// Returns the extensions of the library with a model part, in the order of their list.
const std::vector<const Extension*>& modelTerms();
/// Returns the name of a module that belongs to a term. Throws std::logic_error for others.
const char* nameOf(bool Modules::*module);
/// Returns true if a scene with these modules uses the term.
bool isUsed(const Extension& term, const Scene& scene, const Modules& modules);
/// Calls use(term, table, element) for each element of the tables of terms, such as each lamp.
template<class Use> void eachTermElement(Scene& scene, Use&& use) {
  for (const Extension* term : modelTerms())
    for (const TermTable& table : term->model->tables)
      for (std::size_t k = 0; k < table.size(scene); k++) use(*term, table, table.at(scene, k));
}

/// Adds the defaults of keys that a scene built in code leaves out, and sets which extensions heat.
void completeExtensions(Scene& scene);

/// Declares the fields of the scene's extensions in the particles, inactive.
void declareFields(const Scene& scene, Continuum& particles);
/// Declares the fields of all registered extensions.
void declareAllFields(Continuum& particles);
/// Declares the field that marks particles emitted in this step. In scenes with emitters, pair forces need it
/// to record the energy that emitted particles bring.
void declareNewborn(Continuum& particles);
/// Returns the field of declareNewborn if it is active, else null.
AddedColumn* newbornOf(const Continuum& particles);
/// Declares the field that stores the force of surface tension by curvature, so that its work can be recorded
/// (core/flow/curvature/curvature_force.hpp).
void declareTensionForce(Continuum& particles);
/// Returns the field of declareTensionForce, or null if it is not declared.
AddedColumn* tensionForceOf(const Continuum& particles);
/// Sets the active fields of extensions in new rows [begin, end) to their start values.
void startFields(Continuum& particles, std::size_t begin, std::size_t end);

}  // namespace thaw
