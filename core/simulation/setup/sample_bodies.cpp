// SPDX-License-Identifier: Apache-2.0
#include "core/simulation/setup/sample_bodies.hpp"

#include <algorithm>
#include <numeric>
#include <span>

#include "core/domain/emit.hpp"
#include "core/domain/sides.hpp"
#include "core/geometry/basic/shape_error.hpp"
#include "core/geometry/sampling/sampling.hpp"
#include "core/geometry/shapes/overlap.hpp"
#include "core/heat/heat.hpp"
#include "core/materials/enthalpy.hpp"
#include "core/scene/full_box.hpp"
#include "core/simulation/setup/cell_fractions.hpp"
#include "core/simulation/setup/estimates/size_hint.hpp"
#include "core/simulation/setup/initial_fill.hpp"
#include "core/simulation/setup/start_fields.hpp"

namespace thaw {
namespace {

/// Errors of sample positions on this rank. The first offender of each kind (by body) is kept as a number
/// that can be reduced: a maximum of negated numbers, -never without offenders.
struct Offenders {
  explicit Offenders(std::size_t bodies) : outside(bodies) {}
  std::vector<Outside> outside;  // by body
  std::int64_t inObstacles = 0, inItself = 0;
  double firstObstacle = -never, firstItself = -never;
};
constexpr std::size_t codes = 65536;

/// x: position of a sample, wrapped into the domain.
void lookAt(const World& w, std::size_t body, const Vec3d& x, Offenders& o) {
  if (o.outside[body].look(w.scene.domain, x)) return;  // a wall side is an obstacle as well: report it once
  for (std::size_t k = 0; k < w.walls.list.size(); k++) {
    if (!holdsSample(w.walls.list[k], x, w.scene.spacing)) continue;
    o.inObstacles++;
    o.firstObstacle = std::max(o.firstObstacle,
                               -static_cast<double>(body * codes + w.walls.list[k].originalAt(k)));
  }
}

/// Parameters for filling a body: its lattice, its centre, and the largest offset of points along each axis,
/// in spacings.
struct Filling {
  SampleLattice lattice;
  Vec3d centre;
  double jitter;
};

/// Fills the rows from `first` on with these points of body b's lattice. inEach: number of particles in each
/// clamp, incremented.
void fillRows(World& w, std::size_t b, const Filling& filling, std::span<const std::int64_t> points,
              std::size_t first, std::vector<std::int64_t>& inEach) {
  const auto& [l, centre, jitter] = filling;
  const Scene& s = w.scene;
  const Body& body = s.bodies[b];
  const Material& m = s.materials[static_cast<std::size_t>(body.material)];
  Continuum& p = w.particles;
  const double dx = s.spacing;
  std::vector<std::shared_ptr<const SignedDistance>> clamps;
  for (const Shape& c : body.clamp) clamps.push_back(makeSignedDistance(c));
  const auto inClamp = [&](const SignedDistance& c, Vec3d x) {  // at the position in the body, or wrapped
                                                                // into the domain
    return c.inside(x) || (wrapPlace(w.grid, s.domain, x), c.inside(x));
  };
  for (std::size_t i = first; i < first + points.size(); i++) {
    const std::int64_t point = points[i - first], row = point / l.count[0];
    const Vec3d x = l.at(point % l.count[0], row % l.count[1], row / l.count[1]);
    p.id[i] = particleId(b, static_cast<std::uint64_t>(point));
    p.position[i] = jitter > 0 ? jittered(x, jitter, dx, s.seed, p.id[i]) : x;
    p.velocity[i] = body.velocity + cross(body.spin, x - centre);
    p.mass[i] = m.density * dx * dx * dx;
    p.material[i] = static_cast<std::uint16_t>(body.material);
    p.body[i] = static_cast<std::uint16_t>(b);
    const double T = body.temperature + dot(body.temperatureGradient, x - centre);
    if (p.temperature.active) p.temperature[i] = T;
    if (p.enthalpy.active) p.enthalpy[i] = ledgerEnthalpy(w.scene.numerics.heat, m, T);
    if (p.slot.active) p.slot[i] = noSlot;
    for (std::size_t k = 0; k < clamps.size(); k++)
      if (inClamp(*clamps[k], x)) {
        p.clamped[i] = held;
        p.velocity[i] = {};
        inEach[k]++;
      }
  }
}

/// Samples this rank's rows of one body's lattice. inEach: see fillRows; filled: incremented by their
/// 64ths of cells (cellFractions). Returns the number of samples that the overlap rule removed.
std::int64_t sampleBody(World& w, std::size_t b, const SignedDistance& shape, const Reducer& all,
                        const OverlapTest& overlap, OverlapCounts& counts, Offenders& offenders,
                        std::int64_t& filled, std::vector<std::int64_t>& inEach) {
  const Scene& s = w.scene;
  Continuum& p = w.particles;
  const SampleLattice l = bodyLattice(s, s.bodies[b], shape);
  // Without a surface the jitter covers the whole cell: relaxation of less leads back to the lattice
  // (benchmark taylor_green).
  const double jitter = s.bodies[b].packing != Packing::Relaxed ? 0 : liquidFillsTheBox(s) ? 0.5 : 0.2;
  const SampleRange range = sampleRange(l, all.rank(), all.size());
  std::int64_t removed = 0;
  constexpr std::int64_t mostAtOnce = 1 << 24;
  std::vector<std::int64_t> points;  // points first, then their rows at once: columns that grow repeatedly
                                     // get new pages each time
  points.reserve(static_cast<std::size_t>(std::min(mostAtOnce, (range.end - range.begin) * l.count[0])));
  KnownSides known;
  for (std::int64_t row = range.begin; row < range.end; row++)
    for (const std::int64_t k : insideOfRow(shape, l, row, known)) {
      const Vec3d x = l.at(k, row % l.count[1], row / l.count[1]);
      if (!overlap.keeps(b, x, s.numerics.overlap, counts)) {
        removed++;
        continue;
      }
      if (overlap.meetsItself(b, x))
        offenders.inItself++,
            offenders.firstItself = std::max(offenders.firstItself, -static_cast<double>(b));
      Vec3d in = x;
      wrapPlace(w.grid, s.domain, in);
      lookAt(w, b, in, offenders);
      points.push_back(row * l.count[0] + k);
    }
  const std::size_t first = p.owned;
  p.resize(first + points.size(), 0);
  fillRows(w, b, {l, middleOf(shape), jitter}, points, first, inEach);
  if (hasInitialFill(s, b)) {
    const std::vector<std::int32_t> shares = cellFractions(shape, l, points);
    std::copy(shares.begin(), shares.end(), p.initialFill.data() + first);
    filled = std::accumulate(shares.begin(), shares.end(), filled);
  }
  return removed;
}

}  // namespace

SamplingReport sampleBodies(World& w, const std::vector<std::shared_ptr<const SignedDistance>>& shapes,
                            Reducer& all) {
  const Scene& s = w.scene;
  Continuum& p = w.particles;
  const std::size_t n = s.bodies.size();
  const auto periodOf = [&](int a) { return w.grid.periodic[a] ? w.grid.period[a] : 0; };
  const OverlapTest overlap(shapes, {periodOf(0), periodOf(1), periodOf(2)});
  OverlapCounts overlaps = overlap.noCounts();
  Offenders offenders(n);
  std::vector<std::int64_t> counts, filled(n, 0);
  std::int64_t removed = 0;
  std::vector<std::vector<std::int64_t>> inEach;  // by body and clamp
  for (std::size_t b = 0; b < n; b++) {
    const std::size_t had = p.owned;
    inEach.emplace_back(s.bodies[b].clamp.size(), 0);
    removed += sampleBody(w, b, *shapes[b], all, overlap, overlaps, offenders, filled[b], inEach.back());
    counts.push_back(static_cast<std::int64_t>(p.owned - had));
  }
  setPhase(s, w.modules, p, 0, p.owned);
  assignStartFields(w, shapes, all, false);

  counts.insert(counts.end(), {removed, offenders.inObstacles, offenders.inItself});
  all.sum(counts);
  all.sum(overlaps.count);
  addUp(offenders.outside, all);
  all.sum(filled);
  if (p.initialFill.active) normaliseInitialFill(s, p, filled, counts);
  std::vector<std::int64_t> clamped(n, 0);
  if (p.clamped.active)
    for (std::size_t i = 0; i < p.owned; i++) clamped[p.body[i]] += p.clamped[i] == held;
  all.sum(clamped);
  double first[2] = {offenders.firstObstacle, offenders.firstItself};
  all.maximum(first);
  SamplingReport report;
  report.particles.assign(counts.begin(), counts.begin() + static_cast<std::ptrdiff_t>(n));
  report.removed = counts[n];
  report.outside = std::move(offenders.outside);
  report.inObstacles = counts[n + 1];
  report.overlaps = describeOverlaps(overlaps, s.bodies);
  SceneProblems problems;
  for (std::size_t b = 0; b < n; b++)
    if (report.particles[b] == 0 && report.removed == 0)
      problems.add(s.bodies[b].where,
                   "body '" + s.bodies[b].name +
                       "' has no particle: it is too small or too thin for the spacing, or empty" +
                       sizeHint(s, s.bodies[b].shape, shapes[b]->bounds()));
  if (const std::int64_t inItself = counts[n + 2]; inItself > 0) {
    const Body& b = s.bodies[static_cast<std::size_t>(-first[1])];
    problems.add(b.where, "body '" + b.name +
                              "' overlaps its own image across a periodic side: " + std::to_string(inItself) +
                              " of its particles lie inside the image; make it "
                              "shorter than the domain along its periodic axes, or the domain longer");
  }
  problems.raise();
  for (std::size_t b = 0; b < n; b++) {
    const std::size_t clamps = inEach[b].size();
    if (clamps > 0) all.sum(inEach[b]);
    for (std::size_t k = 0; k < clamps; k++)
      if (inEach[b][k] == 0)
        report.warnings.push_back(
            {s.bodies[b].where,
             "body '" + s.bodies[b].name + "': its clamp " +
                 (clamps > 1 ? std::to_string(k + 1) + " of " + std::to_string(clamps) + " " : "") +
                 "contains none of its particles" +
                 (clamped[b] == 0 ? ", and the body is not clamped" : "")});
  }
  for (std::size_t b = 0; b < n; b++)
    if (const std::string narrow = narrowAxes(shapes[b]->bounds(), s.spacing); !narrow.empty())
      report.warnings.push_back(
          {s.bodies[b].where,
           "body '" + s.bodies[b].name + "' is narrower than the spacing of " + lengthText(s.spacing) + " (" +
               narrow +
               "): it becomes one layer of particles, one spacing thick, with the mass of that layer" +
               sizeHint(s, s.bodies[b].shape, shapes[b]->bounds())});
  for (std::size_t k = overlaps.count.size(); k-- > 0;)
    if (overlaps.count[k] > 0) report.overlapWhere = s.bodies[overlaps.pair[k].first].where;
  if (report.inObstacles > 0) {
    const std::size_t code = static_cast<std::size_t>(-first[0]);
    report.obstacleWhere = s.bodies[code / codes].where;
    report.firstObstacle = "of body '" + s.bodies[code / codes].name + "' in obstacle '" +
                           w.walls.list[code % codes].properties.name + "'";
  }
  report.clamped = std::move(clamped);
  return report;
}

}  // namespace thaw
