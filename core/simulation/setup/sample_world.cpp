// SPDX-License-Identifier: Apache-2.0
// Initial particles, sampled from the bodies of a scene, and warnings about them.
#include <utility>

#include "core/domain/emit.hpp"
#include "core/domain/outside.hpp"
#include "core/domain/sides.hpp"
#include "core/geometry/basic/shape_error.hpp"
#include "core/rigid/rigidify/deforming.hpp"
#include "core/rigid/surface_elements.hpp"
#include "core/rigid/update_pieces.hpp"
#include "core/sheet/region_overlaps.hpp"
#include "core/simulation/body_types/cell_costs.hpp"
#include "core/simulation/body_types/redistribute_body_types.hpp"
#include "core/simulation/setup/estimates/size_hint.hpp"
#include "core/simulation/setup/relax_packing.hpp"
#include "core/simulation/setup/sample_bodies.hpp"
#include "core/simulation/setup/setup.hpp"
#include "core/simulation/setup/start_fields.hpp"
#include "core/simulation/setup/warnings/falling_liquid.hpp"
#include "core/simulation/setup/warnings/start_warnings.hpp"
#include "core/simulation/setup/warnings/thick_flow.hpp"
#include "core/simulation/setup/warnings/thin_walls.hpp"
#include "core/terms/extensions.hpp"

namespace thaw {
namespace {

/// Adds notes on the meshes of obstacles, and a warning for obstacles with a step at a periodic side.
void addWallWarnings(const Scene& scene, const CellGrid& grid, const Walls& walls,
                     std::vector<SceneWarning>& warnings) {
  for (const Wall& wall : walls.list) {
    if (wall.isImage()) continue;
    const auto add = [&](const std::string& text) {
      warnings.push_back({wall.properties.where, "obstacle '" + wall.properties.name + "'" + text});
    };
    if (const std::string axes = unevenAxes(scene.domain, wall, grid.support); !axes.empty())
      add(" spans the periodic axis " + axes +
          ", but its two ends do not match: particles that cross that side meet a step");
    std::vector<std::string> notes;  // repairs of meshes
    wall.shape->addNotes(notes);
    for (const std::string& note : notes) add(": " + note);
  }
}

/// "file:line".
std::string lineText(const SourcePlace& where) { return where.file + ":" + std::to_string(where.line); }

/// Shapes of bodies, by body.
using BodyShapes = std::vector<std::shared_ptr<const SignedDistance>>;

/// Reports overlapping bodies, bodies outside the domain, and misplaced emitters.
void addMisplaced(const World& w, const std::vector<EmitterPlan>& emitters, const BodyShapes& shapes,
                  const SamplingReport& report, SceneProblems& problems) {
  if (w.scene.numerics.overlap == OverlapRule::Error)
    for (const BodyOverlap& pair : report.overlaps)
      problems.add(w.scene.bodies[pair.second].where,
                   pair.text + "; '" + w.scene.bodies[pair.first].name + "' is at " +
                       lineText(w.scene.bodies[pair.first].where) +
                       "; move them apart, or set `numerics.overlap` to \"keep\", \"remove later\" or "
                       "\"remove earlier\"");
  for (std::size_t b = 0; b < shapes.size(); b++)
    if (const Body& body = w.scene.bodies[b]; report.outside[b].count > 0)
      problems.add(body.where, "body '" + body.name + "': " +
                                   outsideText(report.outside[b], w.scene.domain, report.particles[b],
                                               "particles", "body") +
                                   sizeHint(w.scene, body.shape, shapes[b]->bounds()));
  for (std::size_t e = 0; e < emitters.size(); e++)
    if (const std::string why = misplacedOpening(w.scene, w.walls, w.scene.emitters[e], emitters[e]);
        !why.empty())
      problems.add(w.scene.emitters[e].where, why);
  if (report.inObstacles > 0 && w.scene.numerics.overlap != OverlapRule::Keep)
    problems.add(report.obstacleWhere, std::to_string(report.inObstacles) +
                                           " particles lie inside obstacles (first: " + report.firstObstacle +
                                           "); move them apart, or set `numerics.overlap` to \"keep\"");
}

/// Appends warnings.
void append(std::vector<SceneWarning>&& added, std::vector<SceneWarning>& warnings) {
  for (SceneWarning& warning : added) warnings.push_back(std::move(warning));
}

/// Adds notes on repairs of the meshes of bodies.
void addBodyNotes(const Scene& scene, const BodyShapes& shapes, std::vector<SceneWarning>& warnings) {
  for (std::size_t b = 0; b < shapes.size(); b++) {
    std::vector<std::string> notes;
    shapes[b]->addNotes(notes);
    for (const std::string& note : notes)
      warnings.push_back({scene.bodies[b].where, "body '" + scene.bodies[b].name + "': " + note});
  }
}

/// Sorts the sampled particles and makes the first partition, by the number of particles. Collective.
void partitionSampled(World& w, CellHalo& halo, RedistributionWork& work) {
  Continuum& p = w.particles;
  // By rounding, jitter may move a particle across a periodic side.
  for (std::size_t i = 0; i < p.owned; i++) wrapPlace(w.grid, w.scene.domain, p.position[i]);
  computeCellKeys(w.grid, p);
  Migration all;
  all.arrivals = p.owned;
  sortByCell(p, all, work.sort, w.cells);
  const CellCosts costs = countCells(w);
  halo.rebalance(costs.cells, costs.cost, true);
  work.newPartition = true;
}

}  // namespace

SamplingReport sampleWorld(World& w, Halos halos, StepTools& t, const MeshLoader& load) {
  const BodyShapes shapes = std::exchange(t.sources.shapes, {});
  moveWalls(w.walls, 0);
  SamplingReport report = sampleBodies(w, shapes, halos.all);
  SceneProblems problems;
  addMisplaced(w, t.sources.emitters, shapes, report, problems);
  problems.raise();
  for (std::size_t e = 0; e < t.sources.emitters.size(); e++)
    if (const std::string much = unevenOutflow(w.scene, w.scene.emitters[e], t.sources.emitters[e]);
        !much.empty())
      report.warnings.push_back({w.scene.emitters[e].where, much});
  append(thickFlows(w.scene, w.modules, t.limits.fixed), report.warnings);
  append(thinWalls(w, shapes, report.particles, halos.all), report.warnings);
  append(fallingLiquids(w, shapes, t.sources.emitters, report.particles, halos.all), report.warnings);
  t.oriented.begins = true;
  const std::vector<std::vector<Vec3d>> oriented = sampleBodyTypes(w, halos, t.redistribution.sort, load,
                                                                   report.warnings);
  if (w.modules.bodyTypes())
    append(bodyTypeStartWarnings(w, shapes, oriented, halos.all, problems), report.warnings);
  problems.raise();
  addWallWarnings(w.scene, w.grid, w.walls, report.warnings);
  addBodyNotes(w.scene, shapes, report.warnings);
  append(overlapsOfRegions(w.sheets, w.scene, load), report.warnings);
  partitionSampled(w, halos.cells, t.redistribution);
  relaxPacking(w, halos, t, shapes);
  assignStartFields(w, shapes, halos.all, true);
  Continuum& p = w.particles;
  if (w.modules.rigidify) restAtStart(w.scene, p);
  else if (w.modules.rigid) {
    markRigidParticles(w.scene, p);
    elementsOfShapes(w.scene, shapes, p);
  }
  startFields(p, 0, p.owned);
  return report;
}

}  // namespace thaw
