// SPDX-License-Identifier: Apache-2.0
#include "io/scene/tables/read_extension.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "core/terms/extensions.hpp"
#include "io/frames/frame_fields.hpp"

namespace thaw {
namespace {

void readKeys(TableReader& r, const Extension& e, ExtensionSettings& settings) {
  settings.name = e.name;
  settings.heats = e.heats;
  for (const ExtensionKey& key : e.keys) {
    double& value = settings.values.try_emplace(key.name, key.standard).first->second;
    r.number(key.name.c_str(), value, key.unit.c_str(), between(key.least, key.most), key.about.c_str());
  }
}

/// Says where a scene uses the other parts of an extension.
std::string otherUses(const Extension& e) {
  std::string uses;
  if (e.hasLaw()) uses += "; use its elastic law by material.NAME.law = \"" + e.name + "\"";
  if (e.shape) uses += "; use its shape by " + e.name + " = { ... } in a body or an obstacle";
  return uses;
}

}  // namespace

void readExtension(TableReader& r, ExtensionSettings& settings, SceneReading&) {
  const Extension* e = findExtension(settings.name);
  if (!e && r.reading()) {
    const std::vector<std::string> known = extensionNames(
        [](const Extension& other) { return other.usesTable() || !other.builtIn; });
    r.fail(r.place(), r.path() + ": unknown extension; this program has " +
                          (known.empty() ? "none" : fmt::format("{}", fmt::join(known, ", "))));
    r.ignoreKeys();
  }
  if (!e) return;
  r.restart(Restart::Coefficient);
  readKeys(r, *e, settings);
  if (!r.reading()) return;
  if (e->model)
    r.fail(r.place(), r.path() +
                          ": it is a term of the library, with keys in other tables, which `thaw docs` "
                          "lists; remove this table");
  else if (!e->usesTable())
    r.fail(r.place(), r.path() + ": it has no force, source or field" + otherUses(*e));
}

void readLaw(TableReader& r, Material& m) {
  const std::vector<std::string> names = lawNames();
  int law = static_cast<int>(std::find(names.begin(), names.end(), m.law.name) - names.begin());
  if (law == static_cast<int>(names.size()))  // a scene made in code
    throw std::invalid_argument("material '" + m.name + "': unknown elastic law '" + m.law.name +
                                "'; expected one of " + fmt::format("{}", fmt::join(names, ", ")));
  std::string about = "elastic energy";
  for (const std::string& name : names) about += ". \"" + name + "\": " + findExtension(name)->about;
  // Pieces are part of the state, so a run cannot change to or from them.
  r.as(m.isRigid() ? Restart::State : Restart::Coefficient).choice("law", law, names, about.c_str());
  const std::string& chosen = names[static_cast<std::size_t>(law)];
  if (r.reading()) m.law = {.name = chosen, .values = {}};
  for (const std::string& name : names) {
    const Extension& e = *findExtension(name);
    if (e.keys.empty() || !(name == chosen || r.describing())) continue;
    ExtensionSettings described;
    ExtensionSettings& settings = name == chosen ? m.law : described;
    if (r.reading() && !r.has(name))  // all defaults
      for (const ExtensionKey& key : e.keys) settings.values[key.name] = key.standard;
    r.table(name.c_str(), ("law = \"" + name + "\": " + e.about).c_str(),
            [&](TableReader& keys) { readKeys(keys, e, settings); });
  }
}

std::vector<std::string> extensionShapes() {
  return extensionNames([](const Extension& e) { return static_cast<bool>(e.shape); });
}

void readExtensionShape(TableReader& r, Shape& s) {
  for (const std::string& name : extensionShapes()) {
    const Extension& e = *findExtension(name);
    const bool ours = s.kind == ShapeKind::Extension && s.extension.name == name;
    if (r.recording() && ours) r.node(name.c_str(), "", "", "", "true");
    r.table(name.c_str(), e.about.c_str(), ours, [&](TableReader& keys) { readKeys(keys, e, s.extension); });
  }
}

std::vector<std::string> outputFields(const Scene& scene) {
  std::vector<std::string> names = knownFrameFields();
  names.push_back(surfaceVelocityField);
  for (const ExtensionSettings& s : scene.extensions)
    if (const Extension* e = findExtension(s.name))
      for (const ExtensionField& f : e->fields) names.push_back(f.name);
  return names;
}

}  // namespace thaw
