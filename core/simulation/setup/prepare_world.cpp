// SPDX-License-Identifier: Apache-2.0
// prepareWorld (core/simulation/setup/setup.hpp).
#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include "core/domain/body_lattices.hpp"
#include "core/domain/emit.hpp"
#include "core/fluid/pair_sums/pair_kernels.hpp"
#include "core/geometry/basic/signed_distance.hpp"
#include "core/kernels/lattice.hpp"
#include "core/kernels/sum_scales.hpp"
#include "core/kernels/viscous_weight.hpp"
#include "core/materials/liquid_materials.hpp"
#include "core/oriented/prepare_oriented.hpp"
#include "core/sheet/contact/face_contact.hpp"
#include "core/sheet/contact/mesh_contact.hpp"
#include "core/sheet/prepare_sheets.hpp"
#include "core/simulation/modules/step_modules.hpp"
#include "core/simulation/monitor/monitor.hpp"
#include "core/simulation/setup/activate_fields.hpp"
#include "core/simulation/setup/add_extensions.hpp"
#include "core/simulation/setup/expected_motion.hpp"
#include "core/simulation/setup/make_grid.hpp"
#include "core/simulation/setup/prepare_surface.hpp"
#include "core/simulation/setup/setup.hpp"
#include "core/simulation/time/limits.hpp"
#include "core/terms/extensions.hpp"
#include "core/terms/find_modules.hpp"
#include "core/walls/tables.hpp"
#include "core/walls/walls.hpp"

namespace thaw {
namespace {

/// Largest height of fall (m), from the highest point of bodies and emitters to the bottom of the domain.
double fallHeightOf(const Scene& s, const std::vector<std::shared_ptr<const SignedDistance>>& shapes) {
  const double g = length(s.domain.gravity);
  if (g == 0) return 0;
  const Vec3d up = s.domain.gravity * (-1 / g);
  double top = -never, low = 0;
  for (int a = 0; a < 3; a++) low += std::min(up[a] * s.domain.min[a], up[a] * s.domain.max[a]);
  for (const auto& shape : shapes) {
    const Bounds b = shape->bounds();
    double height = 0;
    for (int a = 0; a < 3; a++) height += std::max(up[a] * b.min[a], up[a] * b.max[a]);
    top = std::max(top, height);
  }
  for (const Emitter& e : s.emitters) top = std::max(top, dot(up, e.centre));
  return std::max(0.0, top - low);
}

/// Largest distance (m) at which something interacts with an obstacle.
double reachOfWalls(const Scene& scene, const CellGrid& grid, const SheetBodies& sheets) {
  double reach = std::max({grid.edge.x, grid.edge.y, grid.edge.z});
  for (const SheetPlan& plan : sheets.plans) reach = std::max(reach, 2 * plan.thickness);
  for (const OrientedBody& b : scene.oriented) reach = std::max(reach, 2 * b.thickness * spacingOf(scene, b));
  return reach;
}

/// Adds the walls of obstacles and of the domain, and the shapes of bodies and terms. The thrown error lists
/// all unreadable meshes and their locations in the scene.
void makeShapes(World& w, ParticleSources& sources, TermWork& terms, const MeshLoader& load) {
  SceneProblems problems;
  for (const Obstacle& o : w.scene.obstacles) {
    Wall wall;
    wall.shape = makeSignedDistance(o.shape, load, "obstacle '" + o.name + "'", problems);
    if (!wall.shape) continue;
    wall.bounds = wall.shape->bounds();
    wall.properties = o;
    w.walls.list.push_back(std::move(wall));
  }
  addDomainWalls(w.scene.domain, w.walls);
  std::vector<std::shared_ptr<const SignedDistance>> shapes;
  for (const Body& b : w.scene.bodies)
    shapes.push_back(makeSignedDistance(b.shape, load, "body '" + b.name + "'", problems));
  startTerms(w.scene, w.modules, terms, load, problems);
  problems.raise();
  sources.shapes = std::move(shapes);
}

/// Returns true if the particles of all bodies and emitters have one mass. Requires: one material.
bool equalMasses(const Scene& s, const ParticleSources& sources) {
  const double density = s.materials[0].density;
  std::vector<double> masses;
  for (const SampleLattice& l : bodyLattices(s, sources.shapes)) {
    if (!l.equalCells()) return false;
    masses.push_back(l.mass(0, density));
  }
  for (const EmitterPlan& e : sources.emitters) masses.push_back(e.particleMass);
  return std::ranges::adjacent_find(masses, std::ranges::not_equal_to{}) == masses.end();
}

/// Returns the constants of pair sums. support: m.
SumScales sumScales(const Scene& s, const Modules& modules, double support) {
  const Numerics& n = s.numerics;
  SumScales scales;
  if (modules.fluid) scales.viscousWeight = viscousWeight(n);
  scales.conductionScale = conductionScale(n);
  const bool plain = n.density == DensityForm::Plain || n.pressure == PairForm::Printed;
  scales.inverseLatticeSum = 1 / (plain ? latticeSum(n) : latticeGradient(n));
  const double cellsInSupport = std::pow(support / s.spacing, 3);
  scales.selfExcess = (latticeSum(n) * scales.inverseLatticeSum - 1) * cellsInSupport;
  scales.relativeDensityScale = scales.inverseLatticeSum / (support * support * support);
  return scales;
}

/// Sets the constants of sums over pairs, walls and free surfaces.
void setScales(const World& w, StepTools& t) {
  const Numerics& n = w.scene.numerics;
  const Modules& m = w.modules;
  t.sums.scales = sumScales(w.scene, m, w.grid.support);
  t.walls.tables = makeWallTables(n);
  if (m.fluid) t.limits.stableViscousStep = stableViscousStep(n);
  if (m.uniform && m.artificialViscosity) t.sums.artificialViscosity = t.liquids[0].artificial;
}

}  // namespace

void prepareWorld(World& w, StepTools& t, const MeshLoader& load) {
  completeExtensions(w.scene);
  w.modules = modulesOf(w.scene);
  w.grid = makeGrid(w.scene);
  if (w.modules.surface) prepareSurface(w);
  w.clock.end = w.scene.end;
  w.clock.every = w.scene.output.every;
  makeShapes(w, t.sources, t.terms, load);
  if (w.modules.sheet) prepareSheets(w.sheets, w.scene, load);
  if (const double reach = std::max(faceContactReach(w.sheets.plans),
                                    meshContactReach(w.scene, w.sheets.plans));
      reach > w.grid.edge.x)
    w.grid = makeGrid(w.scene, reach);
  addWallImages(w.scene.domain, reachOfWalls(w.scene, w.grid, w.sheets), w.walls);
  w.scene.fallHeight = fallHeightOf(w.scene, t.sources.shapes);
  t.sources.emitters = planEmitters(w.scene);
  w.modules.uniform = w.modules.uniform && equalMasses(w.scene, t.sources);
  w.scene.expected = expectedMotion(w.scene, t.sources.shapes, w.walls, t.sources.emitters);

  if (w.modules.oriented) prepareOriented(w.scene, t.oriented, load);
  t.sums.kernels = pairKernels();
  t.liquids = liquidMaterials(w.scene);
  t.limits.fixed = materialLimits(w.scene, w.modules, t.liquids);
  addExtensions(w, t.terms, t.limits.fixed);
  setScales(w, t);
  activateFields(w, t.terms, t.solid.elastic);
  prepareModules(w, t);
  t.limits.monitor = monitorLimits(w.scene, w.modules, t.liquids, t.limits.fixed);
  t.phases = phasesOf(w, t.terms);
}

}  // namespace thaw
