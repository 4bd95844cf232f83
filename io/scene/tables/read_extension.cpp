// SPDX-License-Identifier: Apache-2.0
#include "io/scene/tables/read_extension.hpp"

#include "core/domain/extensions.hpp"
#include "io/frames/frame_fields.hpp"

namespace thaw {
namespace {

std::string joined(const std::vector<std::string>& names) {
  std::string all;
  for (const std::string& name : names) all += (all.empty() ? "" : ", ") + name;
  return all;
}

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
    const std::string known = joined(extensionNames());
    r.fail(r.place(), r.path() + ": unknown extension; this program has " + (known.empty() ? "none" : known));
    r.ignoreKeys();
  }
  if (!e) return;
  r.restart(Restart::Coefficient);
  readKeys(r, *e, settings);
  if (!r.reading()) return;
  if (!e->usesTable()) r.fail(r.place(), r.path() + ": it has no force, source or field" + otherUses(*e));
}

void readLaw(TableReader& r, Material& m) {
  std::vector<std::string> words{"green", "neo-hookean", "corotated", "rigid"};  // as in ElasticLaw
  const std::size_t builtIn = words.size();
  for (const std::string& name : extensionNames([](const Extension& e) { return e.hasLaw(); }))
    words.push_back(name);
  int law = static_cast<int>(m.law);
  if (m.law == ElasticLaw::Extension)
    for (std::size_t k = builtIn; k < words.size(); k++)
      if (words[k] == m.extensionLaw.name) law = static_cast<int>(k);
  // Pieces are part of the state, so a run cannot change to or from them.
  r.as(m.isRigid() ? Restart::State : Restart::Coefficient)
      .choice("law", law, words,
              "elastic energy. \"green\": Green strain with Hooke's law, as in Mueller et al. 2004. "
              "\"neo-hookean\", \"corotated\": laws of these names. \"rigid\": connected particles move as "
              "one rigid body until they melt; `poisson`, `volume_stiffness`, `hourglass` and `damping` are "
              "then not "
              "used, and young only with strength");
  if (law < static_cast<int>(builtIn)) {
    m.law = static_cast<ElasticLaw>(law);
    return;
  }
  m.law = ElasticLaw::Extension;
  const Extension& e = *findExtension(words[static_cast<std::size_t>(law)]);
  m.extensionLaw.name = e.name;
  const auto read = [&](TableReader& keys) { readKeys(keys, e, m.extensionLaw); };
  if (e.keys.empty()) return;
  if (r.reading() && !r.has(e.name))  // all defaults
    for (const ExtensionKey& key : e.keys) m.extensionLaw.values[key.name] = key.standard;
  r.table(e.name.c_str(), e.about.c_str(), read);
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
