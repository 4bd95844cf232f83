// SPDX-License-Identifier: Apache-2.0
#include "core/simulation/setup/sample_bodies.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>

#include "core/domain/emit.hpp"
#include "core/domain/sides.hpp"
#include "core/geometry/basic/shape_error.hpp"
#include "core/geometry/sampling/sampling.hpp"
#include "core/heat/heat.hpp"
#include "core/materials/enthalpy.hpp"
#include "core/scene/full_box.hpp"
#include "core/simulation/setup/cell_fractions.hpp"
#include "core/simulation/setup/estimates/size_hint.hpp"
#include "core/simulation/setup/initial_fill.hpp"
#include "core/simulation/setup/start_fields.hpp"

namespace thaw {
namespace {

/// Misplaced samples on this rank. The first sample of each type is stored as a number that can be reduced
/// over ranks, by a maximum of negated numbers. -never: none.
struct MisplacedSamples {
  explicit MisplacedSamples(std::size_t bodies) : outside(bodies) {}
  std::vector<Outside> outside;  // by body
  std::int64_t inObstacles = 0, inItself = 0;
  double firstObstacle = -never, firstItself = -never;
};
constexpr std::size_t codes = 65536;

/// x: position of a sample, wrapped into the domain.
void checkSample(const Scene& scene, const Walls& walls, std::size_t body, const Vec3d& x,
                 MisplacedSamples& o) {
  if (o.outside[body].look(scene.domain, x))
    return;  // a wall side is also an obstacle, so it is reported
             // only once
  for (std::size_t k = 0; k < walls.list.size(); k++) {
    if (!holdsSample(walls.list[k], x, scene.spacing)) continue;
    o.inObstacles++;
    o.firstObstacle = std::max(o.firstObstacle,
                               -static_cast<double>(body * codes + walls.list[k].originalAt(k)));
  }
}

/// Lattice of a body's particles, the body's centre, and the largest offset of points along each axis, in
/// spacings.
struct BodyLattice {
  SampleLattice lattice;
  Vec3d centre;
  double jitter;
};

/// Fills the rows from `first` on with these points of body b's lattice. inEach: number of particles in each
/// clamp, incremented.
void fillRows(World& w, std::size_t b, const BodyLattice& lattice, std::span<const std::int64_t> points,
              std::size_t first, std::vector<std::int64_t>& inEach) {
  const auto& [l, centre, jitter] = lattice;
  const Scene& s = w.scene;
  const Body& body = s.bodies[b];
  const Material& m = s.materials[static_cast<std::size_t>(body.material)];
  Continuum& p = w.particles;
  const double dx = s.spacing;
  const bool liquid = !solidAtStart(s, body);
  std::vector<std::shared_ptr<const SignedDistance>> clamps;
  for (const Shape& c : body.clamp) clamps.push_back(makeSignedDistance(c));
  const auto inClamp = [&](const SignedDistance& c, Vec3d x) {  // tests the position in the body, and the
                                                                // position wrapped into the domain
    return c.inside(x) || (wrapPlace(w.grid, s.domain, x), c.inside(x));
  };
  for (std::size_t i = first; i < first + points.size(); i++) {
    const std::int64_t point = points[i - first];
    const Vec3d x = l.at(point);
    p.id[i] = particleId(b, static_cast<std::uint64_t>(point));
    const Vec3d start = jitter > 0 ? jittered(x, jitter, dx, s.seed, p.id[i]) : x;
    p.position[i] = liquid ? clearOfWalls(w.walls, springOfLiquid * dx, start) : start;
    p.velocity[i] = body.velocity + cross(body.spin, x - centre);
    p.mass[i] = l.mass(point, m.density);
    p.material[i] = static_cast<std::uint16_t>(body.material);
    p.body[i] = static_cast<std::uint16_t>(b);
    const double T = body.temperature + dot(body.temperatureGradient, x - centre);
    if (p.temperature.active) p.temperature[i] = T;
    if (p.enthalpy.active) p.enthalpy[i] = ledgerEnthalpy(w.scene.numerics.heat, m, T);
    if (p.solidIndex.active) p.solidIndex[i] = noSolid;
    for (std::size_t k = 0; k < clamps.size(); k++)
      if (inClamp(*clamps[k], x)) {
        p.clamped[i] = fixedInPlace;
        p.velocity[i] = {};
        inEach[k]++;
      }
  }
}

constexpr double perCube = 1 << 20;

/// Counts of the samples by body, for this rank. After reduceCounts they are for all ranks.
struct SampleCounts {
  std::vector<std::int64_t> particles, clamped;
  std::vector<std::int64_t> filled;                ///< 64ths of cells (cellFractions)
  std::vector<std::int64_t> volume;                ///< sum of cells; perCube: one cubic spacing
  std::vector<std::vector<std::int64_t>> inClamp;  ///< by body and clamp
  std::int64_t removed = 0;                        ///< by the overlap rule
};

/// Results of sampling on this rank.
struct Sampling {
  Sampling(const Scene& s, const Shapes& ofBodies, const OverlapTest& test)
      : shapes(ofBodies),
        lattices(bodyLattices(s, ofBodies)),
        overlap(test),
        overlaps(test.noCounts()),
        misplaced(s.bodies.size()) {
    counts.particles.assign(s.bodies.size(), 0);
    counts.clamped.assign(s.bodies.size(), 0);
    counts.filled.assign(s.bodies.size(), 0);
    counts.volume.assign(s.bodies.size(), 0);
    for (const Body& b : s.bodies) counts.inClamp.emplace_back(b.clamp.size(), 0);
  }
  const Shapes& shapes;
  std::vector<SampleLattice> lattices;
  const OverlapTest& overlap;
  OverlapCounts overlaps;
  MisplacedSamples misplaced;
  SampleCounts counts;
};

/// Returns this rank's points of a body's lattice that remain under the overlap rule.
std::vector<std::int64_t> pointsInside(const World& w, std::size_t b, const SampleLattice& l,
                                       const SampleRange& range, Sampling& found) {
  const Scene& s = w.scene;
  constexpr std::int64_t mostAtOnce = 1 << 24;
  std::vector<std::int64_t> points;
  points.reserve(static_cast<std::size_t>(std::min(mostAtOnce, (range.end - range.begin) * l.count[0])));
  KnownSides known;
  for (std::int64_t row = range.begin; row < range.end; row++)
    for (const std::int64_t k : insideOfRow(*found.shapes[b], l, row, known)) {
      const Vec3d x = l.at(k, row % l.count[1], row / l.count[1]);
      if (!found.overlap.keeps(b, x, s.numerics.overlap, found.overlaps)) {
        found.counts.removed++;
        continue;
      }
      MisplacedSamples& o = found.misplaced;
      if (found.overlap.meetsItself(b, x))
        o.inItself++, o.firstItself = std::max(o.firstItself, -static_cast<double>(b));
      Vec3d in = x;
      wrapPlace(w.grid, s.domain, in);
      checkSample(s, w.walls, b, in, o);
      points.push_back(row * l.count[0] + k);
    }
  return points;
}

/// Sets Continuum::contactDepth of these points. A particle on the surface counts as slightly below it.
void findDepths(const SignedDistance& shape, const SampleLattice& l, std::span<const std::int64_t> points,
                double spacing, float* depths) {
  constexpr double least = 0.05;
  for (std::size_t k = 0; k < points.size(); k++) {
    const double depth = -shape.distanceWithin(l.at(points[k]), 0.5 * spacing) / spacing;
    depths[k] = static_cast<float>(std::clamp(depth, least, 0.5));
  }
}

/// Samples this rank's rows of one body's lattice.
void sampleBody(World& w, std::size_t b, const Reducer& all, Sampling& found) {
  const SignedDistance& shape = *found.shapes[b];
  const SampleLattice& l = found.lattices[b];
  const Scene& s = w.scene;
  Continuum& p = w.particles;
  // Without a surface, the jitter covers the whole cell. From a smaller jitter, relaxation leads back to the
  // lattice (benchmark taylor_green).
  const double jitter = s.bodies[b].packing != Packing::Relaxed ? 0 : liquidFillsTheBox(s) ? 0.5 : 0.2;
  // Points are found first, and all their rows are added at once. Columns that grow repeatedly would get new
  // pages each time.
  const std::vector<std::int64_t> points = pointsInside(w, b, l, sampleRange(l, all.rank(), all.size()),
                                                        found);
  const std::size_t first = p.owned;
  p.resize(first + points.size(), 0);
  found.counts.particles[b] = static_cast<std::int64_t>(points.size());
  for (const std::int64_t point : points)
    found.counts.volume[b] += std::llround(l.mass(point, 1) * perCube / std::pow(s.spacing, 3));
  fillRows(w, b, {l, middleOf(shape), jitter}, points, first, found.counts.inClamp[b]);
  if (p.contactDepth.active) findDepths(shape, l, points, s.spacing, p.contactDepth.data() + first);
  if (hasInitialFill(s, b)) {
    const std::vector<std::int32_t> fractions = cellFractions(shape, l, points);
    std::copy(fractions.begin(), fractions.end(), p.initialFill.data() + first);
    found.counts.filled[b] = std::accumulate(fractions.begin(), fractions.end(), std::int64_t(0));
  }
}

/// Adds up all counts over ranks, and normalises initial fills. Collective.
void reduceCounts(const Scene& scene, Continuum& p, Sampling& found, Reducer& all) {
  SampleCounts& c = found.counts;
  MisplacedSamples& o = found.misplaced;
  const std::size_t n = c.particles.size();
  std::vector<std::int64_t> together = c.particles;
  together.insert(together.end(), {c.removed, o.inObstacles, o.inItself});
  all.sum(together);
  c.particles.assign(together.begin(), together.begin() + static_cast<std::ptrdiff_t>(n));
  c.removed = together[n], o.inObstacles = together[n + 1], o.inItself = together[n + 2];
  all.sum(found.overlaps.count);
  addUp(o.outside, all);
  all.sum(c.filled);
  all.sum(c.volume);
  if (p.initialFill.active) normaliseInitialFill(scene, p, c.filled, c.particles);
  if (p.clamped.active)
    for (std::size_t i = 0; i < p.owned; i++) c.clamped[p.body[i]] += p.clamped[i] == fixedInPlace;
  all.sum(c.clamped);
  double first[2] = {o.firstObstacle, o.firstItself};
  all.maximum(first);
  o.firstObstacle = first[0], o.firstItself = first[1];
}

/// Throws SceneErrors for bodies without particles and bodies that overlap their own image.
void refuseUnsampled(const Scene& s, const Sampling& found) {
  SceneProblems problems;
  for (std::size_t b = 0; b < s.bodies.size(); b++)
    if (found.counts.particles[b] == 0 && found.counts.removed == 0)
      problems.add(s.bodies[b].where,
                   "body '" + s.bodies[b].name +
                       "' has no particle: it is too small or too thin for the spacing, or empty" +
                       sizeHint(s, s.bodies[b].shape, found.shapes[b]->bounds()));
  if (const std::int64_t inItself = found.misplaced.inItself; inItself > 0) {
    const Body& b = s.bodies[static_cast<std::size_t>(-found.misplaced.firstItself)];
    problems.add(b.where, "body '" + b.name +
                              "' overlaps its own image across a periodic side: " + std::to_string(inItself) +
                              " of its particles lie inside the image; make it "
                              "shorter than the domain along its periodic axes, or the domain longer");
  }
  problems.raise();
}

/// Collective.
void warnOfEmptyClamps(const Scene& s, SampleCounts& c, Reducer& all, std::vector<SceneWarning>& warnings) {
  for (std::size_t b = 0; b < s.bodies.size(); b++) {
    const std::size_t clamps = c.inClamp[b].size();
    if (clamps > 0) all.sum(c.inClamp[b]);
    for (std::size_t k = 0; k < clamps; k++)
      if (c.inClamp[b][k] == 0)
        warnings.push_back(
            {s.bodies[b].where,
             "body '" + s.bodies[b].name + "': its clamp " +
                 (clamps > 1 ? std::to_string(k + 1) + " of " + std::to_string(clamps) + " " : "") +
                 "contains none of its particles" +
                 (c.clamped[b] == 0 ? ", and the body is not clamped" : "")});
  }
}

void warnOfNarrowBodies(const Scene& s, const Shapes& shapes, std::vector<SceneWarning>& warnings) {
  for (std::size_t b = 0; b < s.bodies.size(); b++)
    if (const std::string narrow = narrowAxes(shapes[b]->bounds(), s.spacing); !narrow.empty())
      warnings.push_back(
          {s.bodies[b].where,
           "body '" + s.bodies[b].name + "' is narrower than the spacing of " + lengthText(s.spacing) + " (" +
               narrow +
               "): it becomes one layer of particles, one spacing thick, with the mass of that layer" +
               sizeHint(s, s.bodies[b].shape, shapes[b]->bounds())});
}

/// Reports the first body that lies in an obstacle.
void reportMisplaced(const std::vector<Body>& bodies, const Walls& walls, const Sampling& found,
                     SamplingReport& report) {
  report.inObstacles = found.misplaced.inObstacles;
  if (report.inObstacles == 0) return;
  const std::size_t code = static_cast<std::size_t>(-found.misplaced.firstObstacle);
  report.obstacleWhere = bodies[code / codes].where;
  report.firstObstacle = "of body '" + bodies[code / codes].name + "' in obstacle '" +
                         walls.list[code % codes].properties.name + "'";
}

}  // namespace

SamplingReport sampleBodies(World& w, const std::vector<std::shared_ptr<const SignedDistance>>& shapes,
                            Reducer& all) {
  const auto periodOf = [&](int a) { return w.grid.periodic[a] ? w.grid.period[a] : 0; };
  const OverlapTest overlap(shapes, {periodOf(0), periodOf(1), periodOf(2)});
  Sampling found(w.scene, shapes, overlap);
  for (std::size_t b = 0; b < w.scene.bodies.size(); b++) sampleBody(w, b, all, found);
  setPhase(w.scene, w.modules, w.particles, 0, w.particles.owned);
  setStartMasses(found.lattices, w.particles);
  assignStartFields(w, shapes, all, false);
  reduceCounts(w.scene, w.particles, found, all);
  refuseUnsampled(w.scene, found);
  SamplingReport report;
  warnOfEmptyClamps(w.scene, found.counts, all, report.warnings);
  warnOfNarrowBodies(w.scene, shapes, report.warnings);
  reportMisplaced(w.scene.bodies, w.walls, found, report);
  report.overlaps = describeOverlaps(found.overlaps, w.scene.bodies);
  report.particles = std::move(found.counts.particles);
  report.clamped = std::move(found.counts.clamped);
  report.removed = found.counts.removed;
  for (const std::int64_t v : found.counts.volume)
    report.volume.push_back(static_cast<double>(v) / perCube * std::pow(w.scene.spacing, 3));
  report.outside = std::move(found.misplaced.outside);
  return report;
}

}  // namespace thaw
