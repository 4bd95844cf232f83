#include "core/setup/sample_bodies.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "core/domain/emit.hpp"
#include "core/heat/enthalpy.hpp"
#include "core/heat/heat.hpp"
#include "core/math/hash_random.hpp"

namespace thaw {
namespace {

/// The lattice of a body: points at min + (k + 1/2) spacing, so that a box of whole spacings is filled exactly.
struct Lattice {
  Vec3d min{};
  std::int64_t n[3]{};
};

Lattice latticeOf(const Bounds& b, double spacing) {
  Lattice l;
  for (int a = 0; a < 3; a++) {
    const double extent = b.max[a] - b.min[a];
    l.n[a] = std::max<std::int64_t>(1, std::llround(std::ceil(extent / spacing - 1e-6)));
    l.min[a] = 0.5 * (b.min[a] + b.max[a]) - 0.5 * static_cast<double>(l.n[a]) * spacing;
  }
  return l;
}

}  // namespace

SamplingReport sampleBodies(World& w, const std::vector<std::shared_ptr<const SignedDistance>>& shapes, Reducer& all) {
  const Scene& s = w.scene;
  Continuum& p = w.particles;
  const double dx = s.spacing;
  SamplingReport report;
  report.particles.assign(s.bodies.size(), 0);
  // first offender by (body, sample): 0 where there is none; reduced as a maximum of negated numbers
  std::vector<double> first(3, -never);
  const auto note = [&](int which, std::size_t body, std::size_t other) { first[static_cast<std::size_t>(which)] = std::max(first[static_cast<std::size_t>(which)], -static_cast<double>(body * 65536 + other)); };

  for (std::size_t b = 0; b < s.bodies.size(); b++) {
    const Body& body = s.bodies[b];
    const Material& m = s.materials[static_cast<std::size_t>(body.material)];
    const SignedDistance& shape = *shapes[b];
    const Bounds bounds = shape.bounds();
    const Vec3d centre = (bounds.min + bounds.max) * 0.5;
    const Lattice l = latticeOf(bounds, dx);
    std::vector<std::shared_ptr<const SignedDistance>> clamps;
    for (const Shape& c : body.clamp) clamps.push_back(makeSignedDistance(c));
    const std::int64_t rows = l.n[1] * l.n[2], begin = rows * all.rank() / all.size(), end = rows * (all.rank() + 1) / all.size();
    const std::size_t had = p.owned;
    for (std::int64_t row = begin; row < end; row++) {
      const double y = l.min.y + (static_cast<double>(row % l.n[1]) + 0.5) * dx, z = l.min.z + (static_cast<double>(row / l.n[1]) + 0.5) * dx;
      for (std::int64_t k = 0; k < l.n[0];) {
        Vec3d x{l.min.x + (static_cast<double>(k) + 0.5) * dx, y, z};
        // far from the surface the answer holds for several points: no need to ask for each
        const double d = shape.distanceWithin(x, 8 * dx);
        const std::int64_t same = shape.hasGaps() ? 1 : 1 + static_cast<std::int64_t>(std::floor(std::abs(d) * (1 - 1e-9) / dx));
        const std::int64_t until = std::min(l.n[0], k + same);
        if (!(d < 0)) {
          k = until;
          continue;
        }
        for (; k < until; k++) {
          x.x = l.min.x + (static_cast<double>(k) + 0.5) * dx;
          bool keep = true;
          for (std::size_t o = 0; o < shapes.size(); o++) {
            if (o == b) continue;
            const Bounds ob = shapes[o]->bounds();
            if (x.x < ob.min.x || x.x > ob.max.x || x.y < ob.min.y || x.y > ob.max.y || x.z < ob.min.z || x.z > ob.max.z || !shapes[o]->inside(x)) continue;
            report.overlapping++;
            note(0, std::min(b, o), std::max(b, o));
            if ((s.numerics.overlap == OverlapRule::RemoveLater && o < b) || (s.numerics.overlap == OverlapRule::RemoveEarlier && o > b)) keep = false;
          }
          if (!keep) {
            report.removed++;
            continue;
          }
          for (int a = 0; a < 3; a++)
            if (x[a] < s.domain.min[a] || x[a] >= s.domain.max[a]) {
              report.outside++;
              note(2, b, 0);
              break;
            }
          for (std::size_t o = 0; o < w.walls.list.size(); o++) {
            const Wall& wall = w.walls.list[o];
            if (!wall.present) continue;
            const Vec3d rest = transpose(wall.turn) * (x - wall.move);
            if (wall.shape->distanceWithin(rest, dx) < -0.25 * dx) {
              report.inObstacles++;
              note(1, b, o);
            }
          }
          const std::size_t i = p.owned;
          p.resize(i + 1, 0);
          p.id[i] = particleId(b, static_cast<std::uint64_t>(row * l.n[0] + k));
          p.position[i] = x;
          if (body.packing == Packing::Relaxed)
            for (int a = 0; a < 3; a++) p.position[i][a] += 0.2 * dx * (2 * randomUniform(s.seed, Purpose::Jitter, p.id[i], static_cast<std::uint64_t>(a)) - 1);
          p.velocity[i] = body.velocity + cross(body.spin, x - centre);
          p.mass[i] = m.density * dx * dx * dx;
          p.material[i] = static_cast<std::uint16_t>(body.material);
          p.body[i] = static_cast<std::uint16_t>(b);
          const double T = body.temperature + dot(body.temperatureGradient, x - centre);
          if (p.temperature.active) p.temperature[i] = T;
          if (p.enthalpy.active) p.enthalpy[i] = enthalpyOf(m, T);
          if (p.slot.active) p.slot[i] = noSlot;
          for (const auto& c : clamps)
            if (c->inside(x)) {
              p.clamped[i] = 1;
              p.velocity[i] = {};
            }
        }
      }
    }
    report.particles[b] = static_cast<std::int64_t>(p.owned - had);
  }
  settlePhase(s, w.modules, p, 0, p.owned);

  std::vector<std::int64_t> counts = report.particles;
  for (std::int64_t c : {report.overlapping, report.removed, report.inObstacles, report.outside}) counts.push_back(c);
  all.sum(counts);
  all.maximum(first);
  std::copy_n(counts.begin(), s.bodies.size(), report.particles.begin());
  const std::size_t n = s.bodies.size();
  for (std::size_t b = 0; b < n; b++)
    if (report.particles[b] == 0 && counts[n + 1] == 0)
      throw std::runtime_error("body '" + s.bodies[b].name + "' has no particle: it is too small or too thin for the spacing, or empty");
  report.overlapping = counts[n];
  report.removed = counts[n + 1];
  report.inObstacles = counts[n + 2];
  report.outside = counts[n + 3];
  const auto names = [&](double code, bool obstacle) {
    if (!std::isfinite(code)) return std::string();
    const std::size_t id = static_cast<std::size_t>(-code), a = id / 65536, o = id % 65536;
    return "'" + s.bodies[a].name + "' and '" + (obstacle ? w.walls.list[o].properties.name : s.bodies[o].name) + "'";
  };
  report.firstOverlap = names(first[0], false);
  report.firstObstacle = names(first[1], true);
  if (std::isfinite(first[2])) report.firstOutside = "'" + s.bodies[static_cast<std::size_t>(-first[2]) / 65536].name + "'";
  return report;
}

}  // namespace thaw
