#include "io/scene/scene_warnings.hpp"

#include <fmt/format.h>

#include "io/scene/surface_advice.hpp"

namespace thaw {
namespace {

std::string at(const SourcePlace& where) {
  return where.line > 0 && where.file.rfind("--set", 0) != 0 ? fmt::format("{}:{}:{}", where.file, where.line, where.column) : where.file;
}

}  // namespace

std::string warningLine(const SourcePlace& where, const std::string& text) { return at(where) + ": " + text; }

std::string idleEventLine(const OrientedBody& b, const OrientedEvent& e) {
  const char* what = e.kind == OrientedEventKind::Weld     ? "weld has met nothing: no particles of the two are near each other"
                     : e.kind == OrientedEventKind::Cut    ? "cut has met nothing: all particles that it reaches are on one side of it"
                     : e.kind == OrientedEventKind::Crease ? "crease has met nothing: no particle is near its line"
                                                           : "smoothing has met nothing: no particle in it is creased";
  return warningLine(e.where, fmt::format("oriented body '{}': this {}", b.name, what));
}

std::vector<std::string> sceneWarnings(const Scene& s) {
  std::vector<std::string> lines;
  for (const OrientedBody& b : s.oriented)
    for (const OrientedEvent& e : b.events)
      if (e.time > s.end) lines.push_back(fmt::format("{}: oriented body '{}': this event is at {:g} s and the scene ends at {:g} s: it does not happen", at(e.where), b.name, e.time, s.end));
  if (s.output.fieldsWhere.line > 0 && !hasContinuum(s)) {
    std::string names;
    for (const std::string& name : s.output.fields) names += (names.empty() ? "" : ", ") + name;
    lines.push_back(fmt::format("{}: output.fields ({}) are of bodies and emitters, and the scene has none; frames of oriented bodies and sheets have all their fields", at(s.output.fieldsWhere), names));
  }
  for (const std::string& line : surfaceAdvice(s)) lines.push_back(line);
  return lines;
}

}  // namespace thaw
