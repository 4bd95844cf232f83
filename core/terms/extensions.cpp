// SPDX-License-Identifier: Apache-2.0
#include "core/terms/extensions.hpp"

#include <algorithm>
#include <cctype>
#include <map>
#include <stdexcept>

#include "core/terms/terms.hpp"

namespace thaw {
namespace {

using Extensions = std::map<std::string, Extension>;

/// Returns a law of core/solid/laws/laws.hpp as an extension.
Extension extensionOf(const BuiltInLaw& row) {
  Extension e{.name = row.name, .about = row.about, .law = row.law};
  for (const LawKey& key : row.keys)
    e.keys.push_back({key.name, key.unit, key.standard, key.least, key.most, key.about});
  return e;
}

/// Returns the extensions of the library itself, available in all programs.
std::vector<Extension> ownExtensions() {
  std::vector<Extension> all = ownTerms();
  for (const BuiltInLaw& row : builtInLaws()) all.push_back(extensionOf(row));
  return all;
}

struct Registry {
  Extensions all;
  std::vector<const Extension*> terms;  // in the order of ownExtensions
};

void enter(Extension e, Registry& registry) {
  std::vector<std::string> keys;
  for (const ExtensionKey& key : e.keys) keys.push_back(key.name);
  if (e.hasLaw() && e.law.builtIn < 0) addElasticLaw(e.name, e.law, keys);
  if (e.shape) addExtensionShape(e.name, e.shape);
  const std::string name = e.name;
  const Extension& entered = registry.all.emplace(name, std::move(e)).first->second;
  if (entered.model) registry.terms.push_back(&entered);
}

Registry& registry() {
  static Registry all = [] {
    Registry own;
    for (Extension& e : ownExtensions()) {
      e.builtIn = true;
      enter(std::move(e), own);
    }
    return own;
  }();
  return all;
}

const Extensions& registered() { return registry().all; }

bool isName(const std::string& s) {
  return !s.empty() && std::all_of(s.begin(), s.end(), [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) || c == '_';
  });
}

constexpr const char* newbornName = "newborn";             // the field of declareNewborn
constexpr const char* tensionForceName = "tension_force";  // the field of declareTensionForce

/// Names of computed fields of frames. Fields of extensions cannot have these names or the names of fields of
/// the model.
constexpr const char* computedFields[] = {newbornName, tensionForceName, "density", "pressure",
                                          "stress",    "strain",         "volume",  "plastic_strain",
                                          "rank",      "neighbours"};

bool isFieldOfModel(const std::string& name) {
  Continuum particles;
  return particles.find(name.c_str()) ||
         std::find(std::begin(computedFields), std::end(computedFields), name) != std::end(computedFields);
}

void checkField(const Extension& e, const ExtensionField& f) {
  const std::string field = "extension '" + e.name + "': field '" + f.name + "' ";
  if (!isName(f.name))
    throw std::invalid_argument(field + "expected a name of letters, digits and underscores");
  if (f.components < 1 || f.components > 9)
    throw std::invalid_argument(field + "has " + std::to_string(f.components) +
                                " components; expected 1 to 9");
  if (isFieldOfModel(f.name)) throw std::invalid_argument(field + "is a field of the model");
  if (const Extension* other = findFieldOwner(f.name))
    throw std::invalid_argument(field + "is a field of extension '" + other->name + "'");
  if (std::count_if(e.fields.begin(), e.fields.end(),
                    [&](const ExtensionField& other) { return other.name == f.name; }) > 1)
    throw std::invalid_argument(field + "is declared twice");
}

/// Keys of shapes of the library where a scene expects a shape (io/scene/tables/read_shape.cpp).
constexpr const char* shapeKeys[] = {"mesh",  "box",   "sphere",     "cylinder",     "torus", "glass",
                                     "plane", "union", "difference", "intersection", "place"};

void checkShapeName(const std::string& name) {
  if (std::find(std::begin(shapeKeys), std::end(shapeKeys), name) != std::end(shapeKeys))
    throw std::invalid_argument("extension '" + name +
                                "': the library has a shape or key of that name: choose another name");
}

void check(const Extension& e) {
  if (!isName(e.name))
    throw std::invalid_argument("extension '" + e.name +
                                "': expected a name of letters, digits and underscores");
  if (const Extension* other = findExtension(e.name))
    throw std::invalid_argument("extension '" + e.name + "' is registered already" +
                                (other->builtIn ? ", by the library: choose another name" : ""));
  if (e.model)
    throw std::invalid_argument("extension '" + e.name + "': only terms of the library have a model part");
  if (!e.usesTable() && !e.hasLaw() && !e.shape)
    throw std::invalid_argument("extension '" + e.name +
                                "' has no part: expected a load, fields, a pair force, a law or a shape");
  if (e.shape) checkShapeName(e.name);
  for (const ExtensionKey& key : e.keys)
    if (!isName(key.name) || !(key.least <= key.standard && key.standard <= key.most))
      throw std::invalid_argument("extension '" + e.name + "': key '" + key.name +
                                  "' needs a name, and a default within its range");
  for (const ExtensionField& f : e.fields) checkField(e, f);
}

void declare(const Extension& e, Continuum& p) {
  for (const ExtensionField& f : e.fields)
    if (!p.addedField(f.name))
      p.added.push_back(std::make_unique<AddedColumn>(p, f.name.c_str(), f.unit.c_str(), f.about.c_str(),
                                                      f.components, f.start, f.ghosts));
}

void complete(ExtensionSettings& settings) {
  const Extension* e = findExtension(settings.name);
  if (!e) return;
  for (const ExtensionKey& key : e->keys) settings.values.try_emplace(key.name, key.standard);
  settings.heats = e->heats;
}

/// Calls use(settings) for the extension of a shape and those of its parts.
template<class Use> void eachOfShape(Shape& s, Use&& use) {
  if (s.kind == ShapeKind::Extension) use(s.extension);
  for (Shape& part : s.parts) eachOfShape(part, use);
}

/// Calls use(settings) for each place of the scene that names an extension: tables, laws, shapes.
template<class Use> void eachUse(Scene& scene, Use&& use) {
  for (ExtensionSettings& s : scene.extensions) use(s);
  for (Material& m : scene.materials) use(m.law);
  for (Body& b : scene.bodies) {
    eachOfShape(b.shape, use);
    for (Shape& clamp : b.clamp) eachOfShape(clamp, use);
  }
  for (Obstacle& o : scene.obstacles) eachOfShape(o.shape, use);
  for (OrientedBody& b : scene.oriented) eachOfShape(b.shape, use);
  eachTermElement(scene, [&](const Extension&, const TermTable&, const TermElement& element) {
    if (element.shape) eachOfShape(*element.shape, use);
  });
}

}  // namespace

void registerExtension(Extension e) {
  check(e);
  enter(std::move(e), registry());
}

const Extension* findExtension(const std::string& name) {
  const auto at = registered().find(name);
  return at == registered().end() ? nullptr : &at->second;
}

const Extension* findFieldOwner(const std::string& field) {
  for (const auto& [name, e] : registered())
    for (const ExtensionField& f : e.fields)
      if (f.name == field) return &e;
  return nullptr;
}

std::vector<const Extension*> usedExtensions(Scene& scene) {
  std::vector<const Extension*> used;
  eachUse(scene, [&](const ExtensionSettings& s) {
    const Extension* e = findExtension(s.name);
    if (!e) throw std::invalid_argument("extension '" + s.name + "' is not registered");
    if (!e->builtIn && std::find(used.begin(), used.end(), e) == used.end()) used.push_back(e);
  });
  return used;
}

std::vector<std::string> extensionNames(const std::function<bool(const Extension&)>& has) {
  std::vector<std::string> names;
  for (const auto& [name, extension] : registered())
    if (has(extension)) names.push_back(name);
  return names;
}

std::vector<std::string> lawNames() {
  std::vector<std::string> names;
  for (const BuiltInLaw& row : builtInLaws()) names.push_back(row.name);
  for (const std::string& name :
       extensionNames([](const Extension& e) { return e.hasLaw() && e.law.builtIn < 0; }))
    names.push_back(name);
  return names;
}

const std::vector<const Extension*>& modelTerms() { return registry().terms; }

const char* nameOf(bool Modules::*module) {
  for (const Extension* term : modelTerms())
    for (const TermModule& own : term->model->modules)
      if (own.module == module) return own.name;
  throw std::logic_error("a module of a term has no name");
}

bool isUsed(const Extension& term, const Scene& scene, const Modules& modules) {
  const ModelPart& part = *term.model;
  if (part.uses) return !part.uses(scene, modules).empty();
  return part.earlyUses && !part.earlyUses(scene).empty();
}

void completeExtensions(Scene& scene) { eachUse(scene, complete); }

void declareFields(const Scene& scene, Continuum& particles) {
  for (const ExtensionSettings& s : scene.extensions)
    if (const Extension* e = findExtension(s.name)) declare(*e, particles);
}

void declareAllFields(Continuum& particles) {
  for (const auto& [name, extension] : registered()) declare(extension, particles);
  declareNewborn(particles);
  declareTensionForce(particles);
}

void declareNewborn(Continuum& p) {
  if (!p.addedField(newbornName))
    p.added.push_back(
        std::make_unique<AddedColumn>(p, newbornName, "1", "1: emitted in this step", 1, 0.0, true));
}

AddedColumn* newbornOf(const Continuum& p) {
  AddedColumn* column = p.addedField(newbornName);
  return column && column->active ? column : nullptr;
}

void declareTensionForce(Continuum& p) {
  if (!p.addedField(tensionForceName))
    p.added.push_back(std::make_unique<AddedColumn>(
        p, tensionForceName, "N", "surface tension by curvature in the last evaluation", 3, 0.0, false));
}

AddedColumn* tensionForceOf(const Continuum& p) { return p.addedField(tensionForceName); }

void startFields(Continuum& p, std::size_t begin, std::size_t end) {
  for (const auto& c : p.added)
    if (c->active) std::fill(c->row(begin), c->row(end), c->start);
}

}  // namespace thaw
