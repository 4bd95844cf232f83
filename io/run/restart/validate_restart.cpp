// SPDX-License-Identifier: Apache-2.0
#include "io/run/restart/validate_restart.hpp"

#include <fmt/format.h>

#include "core/oriented/adaptive_sampling/events.hpp"
#include "core/oriented/forces/constraints.hpp"

namespace thaw {
namespace {

std::int64_t countUnknownParticles(const Continuum& p, const Scene& scene) {
  const std::size_t sources = scene.bodies.size() + scene.emitters.size();
  std::int64_t n = 0;
  for (std::size_t i = 0; i < p.owned; i++)
    n += p.material[i] >= scene.materials.size() || p.body[i] >= sources;
  return n;
}

std::int64_t countUnknownOriented(const OrientedBodies& oriented, const Scene& scene) {
  const Oriented& o = oriented.rows;
  std::int64_t n = 0;
  for (std::size_t i = 0; i < o.owned; i++)  // Particles born later have no constraint and are free.
    n += o.body[i] >= scene.oriented.size() ||
         ((o.flags[i] & (fixedPosition | fixedOrientation)) && o.constraint[i] != noConstraint &&
          o.constraint[i] >= scene.oriented[o.body[i]].constraints.size());
  return n;
}

std::int64_t countUnknownVertices(const SheetBodies& s) {
  const auto known = [&](std::size_t i) {
    const std::uint64_t sheet = s.rows.id[i] >> 40, vertex = s.rows.id[i] & ((std::uint64_t{1} << 40) - 1);
    return sheet < s.plans.size() && s.rows.body[i] == sheet &&
           vertex < s.plans[sheet].mesh.vertices.size() && s.rows.law[i] < s.laws.size() &&
           s.laws[s.rows.law[i]].sheet == sheet && s.rows.part[i] < s.parts.size() &&
           s.parts[s.rows.part[i]].sheet == sheet;
  };
  std::int64_t n = 0;
  for (std::size_t i = 0; i < s.rows.owned; i++) n += !known(i);
  return n;
}

/// Adds a line for each future cut whose bits of Oriented::cutSides an earlier cut has used.
void addCutNumberConflicts(const OrientedBodies& oriented, const Scene& scene, const Clock& clock,
                           Reducer& all, std::vector<std::string>& lines) {
  double used[32] = {};
  const Oriented& o = oriented.rows;
  for (std::size_t i = 0; i < o.owned; i++)
    for (int k = 0; k < 32; k++)
      if (o.cutSides[i] >> (2 * k) & 3) used[k] = 1;
  all.maximum(used);
  for (std::size_t b = 0; b < scene.oriented.size(); b++)
    for (std::size_t e = 0; e < scene.oriented[b].events.size(); e++) {
      const OrientedEvent& event = scene.oriented[b].events[e];
      if (event.kind != OrientedEventKind::Cut || event.time <= clock.time) continue;
      if (const int number = cutNumber(scene, b, e); used[number] > 0)
        lines.push_back(
            fmt::format("oriented.{}.event.{}: particles store this cut by its number in the scene, {}, "
                        "which a past cut had: add new cuts after those that were in the scene",
                        scene.oriented[b].name, e, number + 1));
    }
}

}  // namespace

std::vector<std::string> checkpointMismatches(const World& w, Reducer& all) {
  std::int64_t strange[3] = {w.particles.id.active ? countUnknownParticles(w.particles, w.scene) : 0,
                             w.modules.oriented ? countUnknownOriented(w.oriented, w.scene) : 0,
                             w.modules.sheet ? countUnknownVertices(w.sheets) : 0};
  all.sum(strange);
  constexpr const char* rows[3] = {"particles belong to a body, an emitter or a material",
                                   "oriented particles belong to a body or a constraint",
                                   "vertices belong to a sheet, a region or a mesh"};
  std::vector<std::string> lines;
  for (std::size_t k = 0; k < 3; k++)
    if (strange[k] > 0)
      lines.push_back(fmt::format("{} of its {} that the scene does not have", strange[k], rows[k]));
  if (w.modules.oriented && lines.empty()) addCutNumberConflicts(w.oriented, w.scene, w.clock, all, lines);
  return lines;
}

}  // namespace thaw
