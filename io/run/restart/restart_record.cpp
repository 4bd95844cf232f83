// SPDX-License-Identifier: Apache-2.0
#include "io/run/restart/restart_record.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "io/run/restart/checksum.hpp"
#include "io/run/restart/restart_coefficients.hpp"
#include "io/run/restart/restart_text.hpp"
#include "io/run/restart/restart_values.hpp"

namespace thaw {
namespace {

constexpr const char* axes[3] = {"x", "y", "z"};

template<class List> void addNames(CheckpointValues& record, const char* group, const List& list) {
  for (std::size_t k = 0; k < list.size(); k++)
    record[fmt::format("{}.{}", group, list[k].name)] = static_cast<double>(k);
}

/// Adds an emitter. It numbers its particles by their count since its start, so its schedule is part of the
/// state.
void addEmitter(CheckpointValues& record, const Emitter& e) {
  const std::string at = "emitter." + e.name + ".";
  addNumbers(record, at,
             {{"radius", e.disc ? e.radius : 0},
              {"width", e.disc ? 0 : e.width},
              {"depth", e.disc ? 0 : e.depth},
              {"speed", e.speed},
              {"rate", e.rate},
              {"start", e.start},
              {"material", static_cast<double>(e.material)}});
  addVector(record, at + "centre", e.centre);
  addVector(record, at + "direction", e.direction);
  addField(record, at, e.velocityField);
}

/// Adds clamps. Clamped particles are flagged at the start, and a scene without clamps has no column for the
/// flags.
void addClamps(CheckpointValues& record, const std::string& at, const std::vector<Shape>& clamps) {
  record[at + "clamps"] = static_cast<double>(clamps.size());
  for (std::size_t k = 0; k < clamps.size(); k++)
    addShape(record, fmt::format("{}clamp.{}.", at, k), clamps[k]);
}

/// Adds a sheet. A restart makes its edges, triangles and rest positions again from its mesh.
void addSheet(CheckpointValues& record, const SheetBody& b) {
  const std::string at = "sheet." + b.name + ".";
  // Vertices keep their mass and the index of their law.
  addNumbers(record, at,
             {{"mesh", static_cast<double>(b.mesh)},
              {"width", b.width},
              {"depth", b.depth},
              {"height", b.height},
              {"radius", b.radius},
              {"spacing", b.spacing},
              {"ribs", b.ribs},
              {"rib_height", b.ribHeight},
              {"wrinkles", b.wrinkles},
              {"wrinkle_height", b.wrinkleHeight},
              {"mass", b.mass},
              {"regions", static_cast<double>(b.regions.size())}});
  addVector(record, at + "warp_direction", b.warpDirection);
  addShape(record, at + "place.", b.shape);
  addClamps(record, at, b.clamp);
  for (std::size_t k = 0; k < b.regions.size(); k++) {
    record[fmt::format("{}region.{}.mass", at, k)] = b.regions[k].factor[placeOf(SheetFactor::Mass)];
    addShape(record, fmt::format("{}region.{}.", at, k), b.regions[k].shape);
  }
}

bool hasPrefix(const std::string& key, const std::string& prefix) { return key.rfind(prefix, 0) == 0; }
bool mayChange(const std::string& key) {
  return hasPrefix(key, coefficient) || hasPrefix(key, setting) || hasPrefix(key, initialPrefix);
}

/// Adds an oriented body. The positions of its particles follow from these, and a restart finds anchors and
/// given points by them.
void addOriented(CheckpointValues& record, const OrientedBody& b) {
  const std::string at = "oriented." + b.name + ".";
  // Particles keep mass and inertia, and refer to anchors by index.
  addNumbers(record, at,
             {{"source", static_cast<double>(b.source)},
              {"width", b.width},
              {"depth", b.depth},
              {"radius", b.radius},
              {"bulge", b.bulge},
              {"thin", b.thin},
              {"spacing", b.spacing},
              {"density", b.density},
              {"inertia", b.inertia},
              {"anchors", static_cast<double>(b.anchors.size())}});
  addVector(record, at + "from", b.from);
  addVector(record, at + "to", b.to);
  addShape(record, at + "place.", b.shape);
  for (const auto& [key, list] : {std::pair{"points", &b.points}, std::pair{"normals", &b.normals}}) {
    Checksum sum;
    for (const Vec3d& x : *list) sum.add(x);
    record[at + key] = static_cast<double>(list->size());
    record[at + key + ".checksum"] = sum.asDouble();
  }
  for (std::size_t k = 0; k < b.anchors.size(); k++) {
    const std::string anchor = fmt::format("{}anchor.{}.", at, k);
    addNumbers(record, anchor, {{"position", b.anchors[k].position}, {"normal", b.anchors[k].normal}});
    addShape(record, anchor, b.anchors[k].region);
  }
}

constexpr std::size_t mostRecordedBodies = 100;  // bodies with entries of their own; for more of them the
                                                 // record would be too long

/// Adds the material and shape of a body. The automatic sound speed depends on the shape, too.
void addBody(CheckpointValues& record, const Body& b) {
  const std::string at = "body." + b.name + ".";
  addNumbers(record, at, {{"material", b.material}, {"packing", static_cast<double>(b.packing)}});
  addShape(record, at + "shape.", b.shape);
  if (!b.clamp.empty()) addClamps(record, at, b.clamp);
}

void addStart(CheckpointValues& record, const Body& b) {
  const std::string at = initialPrefix + ("body." + b.name + ".");
  record[at + "temperature"] = b.temperature;
  addVector(record, at + "velocity", b.velocity);
  addVector(record, at + "spin", b.spin);
  addVector(record, at + "temperature_gradient", b.temperatureGradient);
  addField(record, at, b.velocityField);
  addField(record, at + "temperature", b.temperatureField);
}

/// Adds the first bodies one by one, and the others as a checksum.
void addBodies(CheckpointValues& record, const std::vector<Body>& bodies) {
  CheckpointValues made, start;
  for (std::size_t k = 0; k < bodies.size(); k++) {
    addBody(k < mostRecordedBodies ? record : made, bodies[k]);
    addStart(k < mostRecordedBodies ? record : start, bodies[k]);
  }
  if (bodies.size() <= mostRecordedBodies) return;
  record["body.others_checksum"] = checksumOf(made);
  record[std::string(initialPrefix) + "body.others_checksum"] = checksumOf(start);
}

void addStart(CheckpointValues& record, const Scene& s) {
  for (const OrientedBody& b : s.oriented) {
    const std::string at = initialPrefix + ("oriented." + b.name + ".");
    addNumbers(record, at, {{"jitter", b.jitter}, {"relax", static_cast<double>(b.relax)}});
    addVector(record, at + "velocity", b.velocity);
  }
  for (const SheetBody& b : s.sheets) {
    const std::string at = initialPrefix + ("sheet." + b.name + ".");
    record[at + "temperature"] = b.temperature;
    addVector(record, at + "velocity", b.velocity);
  }
}

/// Returns the prefixes of events, as "setting.oriented.net.event.0.", that were before `time` in all records
/// that have them.
std::vector<std::string> pastEvents(const CheckpointValues& stored, const CheckpointValues& now,
                                    double time) {
  const std::string last = "time";
  std::vector<std::string> past;
  for (const CheckpointValues* record : {&stored, &now})
    for (const auto& [key, value] : *record) {
      if (!hasPrefix(key, std::string(setting) + "oriented.") || key.find(".event.") == std::string::npos ||
          !key.ends_with("." + last) || value > time)
        continue;
      const auto other = record == &stored ? now.find(key) : stored.find(key);
      if (other == (record == &stored ? now : stored).end() || other->second <= time)
        past.push_back(key.substr(0, key.size() - last.size()));
    }
  return past;
}

bool hasAnyPrefix(const std::string& key, const std::vector<std::string>& beginnings) {
  return std::any_of(beginnings.begin(), beginnings.end(),
                     [&](const std::string& b) { return hasPrefix(key, b); });
}

/// Returns the entries with only the settings of these prefixes, or without them.
CheckpointValues chosen(const CheckpointValues& record, const std::vector<std::string>& beginnings,
                        bool those) {
  CheckpointValues some;
  for (const auto& [key, value] : record)
    if (!hasPrefix(key, setting) || hasAnyPrefix(key, beginnings) == those) some[key] = value;
  return some;
}

/// Adds a change, unless the texts are equal: then a material or body has another index, which is reported by
/// itself.
void addChange(std::vector<std::string>& changes, const std::string& key, const std::string& was,
               const std::string& is, const std::string& unit) {
  if (was != is) changes.push_back(fmt::format("{} was {}, and is {} now{}", key, was, is, unit));
}

/// Returns the changes of entries with a prefix, without it.
std::vector<std::string> changesOf(const std::string& prefix, const CheckpointValues& stored,
                                   const CheckpointValues& now) {
  const RestartRecordText then(stored), words(now);
  std::vector<std::string> changes;
  for (const auto& [key, value] : stored) {
    if (!hasPrefix(key, prefix)) continue;
    const auto it = now.find(key);
    const std::string name = key.substr(prefix.size());
    if (it == now.end())
      changes.push_back(
          fmt::format("{} was {}, and is not in the scene any more", name, then.text(name, value)));
    else if (it->second != value)
      addChange(changes, name, then.text(name, value), words.text(name, it->second), then.unit(name));
  }
  for (const auto& [key, value] : now)
    if (hasPrefix(key, prefix) && !stored.contains(key))
      changes.push_back(fmt::format("{} was not in the scene then, and is {} now", key.substr(prefix.size()),
                                    words.text(key.substr(prefix.size()), value)));
  return changes;
}

}  // namespace

CheckpointValues restartRecordOf(const Scene& s) {
  CheckpointValues record;
  record["spacing"] = s.spacing;
  record["seed"] = static_cast<double>(s.seed);
  record["numerics.support"] = s.numerics.support;
  record["numerics.bond_support"] = s.numerics.bondSupport;        // existing bonds were made with it
  record["numerics.heat"] = static_cast<double>(s.numerics.heat);  // the paper model does not store enthalpy
  record["output.every"] = s.output.every;  // frame numbers would collide with existing frames
  for (int a = 0; a < 3; a++) {
    const std::string axis = axes[a];
    record["domain.min." + axis] = s.domain.min[a];
    record["domain.max." + axis] = s.domain.max[a];
    record["domain.gravity." + axis] = s.domain.gravity[a];  // the ledger sums potential energy and impulse
                                                             // from the start
    record["domain.periodic." + axis] = s.domain.side[static_cast<std::size_t>(a)][0] == Side::Periodic;
  }
  if (s.surface.on) record["surface"] = 1;  // the surface begins with the bodies
  addNames(record, "material", s.materials);
  addNames(record, "body", s.bodies);
  addNames(record, "emitter", s.emitters);
  addNames(record, "oriented", s.oriented);
  addNames(record, "sheet", s.sheets);
  for (const Emitter& e : s.emitters) addEmitter(record, e), addSettings(record, e);
  for (const SheetBody& b : s.sheets) {
    addSheet(record, b);
    addCoefficients(record, b);
  }
  for (const OrientedBody& b : s.oriented) {
    addOriented(record, b);
    addCoefficients(record, b);
  }
  for (const Material& m : s.materials) addCoefficients(record, m);
  if (s.surface.on) addSettings(record, s.surface);
  for (const Obstacle& o : s.obstacles) addCoefficients(record, o);
  for (std::size_t k = 0; k < s.thermostats.size(); k++) addSettings(record, s.thermostats[k], k);
  addCoefficients(record, s.domain);
  addCoefficients(record, s.numerics);
  addExpectedSpeed(record, s);
  addBodies(record, s.bodies);
  addStart(record, s);
  return record;
}

std::vector<std::string> restartConflicts(const CheckpointValues& stored, const Scene& scene) {
  const CheckpointValues now = restartRecordOf(scene);
  const RestartRecordText then(stored), words(now);
  std::vector<std::string> differences;
  for (const auto& [key, value] : stored) {
    if (mayChange(key)) continue;
    const auto it = now.find(key);
    if (it == now.end()) differences.push_back(fmt::format("{} is not in the scene any more", then.key(key)));
    else if (it->second != value)
      addChange(differences, then.key(key), then.text(key, value), words.text(key, it->second),
                then.unit(key));
  }
  for (const auto& [key, value] : now)
    if (!mayChange(key) && !stored.contains(key))
      differences.push_back(fmt::format("{} was not in the scene then", key));
  return differences;
}

std::vector<std::string> coefficientChanges(const CheckpointValues& stored, const Scene& scene) {
  return changesOf(coefficient, stored, restartRecordOf(scene));
}

std::vector<std::string> settingChanges(const CheckpointValues& stored, const Scene& scene, double time) {
  const CheckpointValues now = restartRecordOf(scene);
  const std::vector<std::string> past = pastEvents(stored, now, time);
  return changesOf(setting, chosen(stored, past, false), chosen(now, past, false));
}

std::vector<std::string> pastEventChanges(const CheckpointValues& stored, const Scene& scene, double time) {
  const CheckpointValues now = restartRecordOf(scene);
  const std::vector<std::string> past = pastEvents(stored, now, time);
  return changesOf(setting, chosen(stored, past, true), chosen(now, past, true));
}

std::vector<std::string> initialStateChanges(const CheckpointValues& stored, const Scene& scene) {
  return changesOf(initialPrefix, stored, restartRecordOf(scene));
}

}  // namespace thaw
