// SPDX-License-Identifier: Apache-2.0
#include "core/simulation/setup/expected_motion.hpp"

#include <algorithm>
#include <cmath>

#include "core/scene/buoyancy.hpp"
#include "core/simulation/setup/start_fields.hpp"

namespace thaw {
namespace {

bool turnsOrStrains(const Body& b) { return b.velocityField.given() || !(b.spin == Vec3d{}); }

/// Returns `count` evenly spaced numbers from 0 to points - 1, both ends included.
std::vector<std::int64_t> evenly(std::int64_t points, std::int64_t count) {
  std::vector<std::int64_t> chosen;
  const std::int64_t n = std::min(points, count);
  for (std::int64_t k = 0; k < n; k++) chosen.push_back(n > 1 ? k * (points - 1) / (n - 1) : points / 2);
  return chosen;
}

/// Calls `see` with some lattice points of a body, or with its box's corners if no point is inside.
template<class See>
void forSomePoints(const SignedDistance& shape, const SampleLattice& l, std::int64_t perAxis, See see) {
  bool any = false;
  for (const std::int64_t k : evenly(l.count[2], perAxis))
    for (const std::int64_t j : evenly(l.count[1], perAxis))
      for (const std::int64_t i : evenly(l.count[0], perAxis))
        if (const Vec3d x = l.at(i, j, k); shape.inside(x)) any = true, see(x);
  if (any) return;
  const Bounds o = shape.bounds();
  for (int c = 0; c < 8; c++)
    see({c & 1 ? o.max.x : o.min.x, c & 2 ? o.max.y : o.min.y, c & 4 ? o.max.z : o.min.z});
}

/// Largest speed (m/s) of some points of a body.
double fastestPoint(const Body& b, const SignedDistance& shape, const SampleLattice& l,
                    std::int64_t perAxis) {
  const Vec3d centre = middleOf(shape);
  double fastest = 0;
  forSomePoints(shape, l, perAxis, [&](const Vec3d& x) {
    const double v = length(startVelocity(b, centre, x));
    if (std::isfinite(v)) fastest = std::max(fastest, v);
  });
  return fastest;
}

/// Finds the range of temperatures for buoyancy.
void addTemperatures(const Scene& s, const Shapes& shapes, std::span<const SampleLattice> lattices,
                     ExpectedMotion& m) {
  constexpr std::int64_t perAxis = 33;
  if (!hasBuoyancy(s)) return;
  for (std::size_t b = 0; b < s.bodies.size(); b++) {
    const Body& body = s.bodies[b];
    const Vec3d centre = middleOf(*shapes[b]);
    const bool uniform = !body.temperatureField && length(body.temperatureGradient) == 0;
    forSomePoints(*shapes[b], lattices[b], uniform ? 1 : perAxis, [&](const Vec3d& x) {
      const double T = startTemperature(body, centre, x);
      if (std::isfinite(T)) m.coldest = std::min(m.coldest, T), m.hottest = std::max(m.hottest, T);
    });
  }
}

void addBodies(const Scene& s, const Shapes& shapes, ExpectedMotion& m) {
  const std::vector<SampleLattice> lattices = bodyLattices(s, shapes);
  constexpr double mostPoints = 1e6;  // over all bodies; tens of milliseconds for simple shapes
  const auto bodies = std::count_if(s.bodies.begin(), s.bodies.end(), turnsOrStrains);
  const double each = std::cbrt(mostPoints / static_cast<double>(std::max<std::ptrdiff_t>(1, bodies)));
  const auto perAxis = static_cast<std::int64_t>(std::clamp(each, 3.0, 33.0));
  for (std::size_t b = 0; b < s.bodies.size(); b++) {
    const Body& body = s.bodies[b];
    const double v = turnsOrStrains(body) ? fastestPoint(body, *shapes[b], lattices[b], perAxis)
                                          : length(body.velocity);
    if (v > m.start) m.start = v, m.startBy = "body '" + body.name + "'";
  }
  addTemperatures(s, shapes, lattices, m);
  const auto whole = [&](const auto& bodies2, const char* kind) {
    for (const auto& b : bodies2)
      if (length(b.velocity) > m.start)
        m.start = length(b.velocity), m.startBy = kind + (" '" + b.name + "'");
  };
  whole(s.oriented, "oriented body");
  whole(s.sheets, "sheet");
}

/// Height (m) of the domain along `up`, and coordinate of its lowest corner.
struct Heights {
  double size = 0, low = 0;
};
Heights heightsOf(const Domain& d, const Vec3d& up) {
  Heights h;
  for (int a = 0; a < 3; a++) {
    h.size += std::abs(up[a]) * (d.max[a] - d.min[a]);
    h.low += std::min(up[a] * d.min[a], up[a] * d.max[a]);
  }
  return h;
}

/// Adds the motion of emitters. An emitter that does not point down can fill a vessel from below, up to the
/// top of the domain.
void addEmitters(const Scene& s, const Vec3d& up, const std::vector<EmitterPlan>& plans, ExpectedMotion& m) {
  const Heights domain = heightsOf(s.domain, up);
  for (std::size_t e = 0; e < s.emitters.size(); e++) {
    const Emitter& emitter = s.emitters[e];
    double v = emitter.speed;
    for (const Vec3d& u : plans[e].velocity) v = std::max(v, length(u));
    if (v > m.emitted) m.emitted = v, m.emittedBy = "emitter '" + emitter.name + "'";
    if (dot(up, emitter.direction) < 0) continue;
    const double filled = emitter.end < never ? emitter.speed * (emitter.end - emitter.start) : never;
    m.column = std::max(m.column, std::min(domain.size, dot(up, emitter.centre) - domain.low + filled));
  }
}

Vec3d withinDomain(const Domain& d, Vec3d x) {
  for (int a = 0; a < 3; a++) x[a] = std::clamp(x[a], d.min[a], d.max[a]);
  return x;
}

/// Returns the corners of the obstacle's box at rest. Along infinite axes, the bounds of the domain are used.
std::vector<Vec3d> cornersOf(const Bounds& b, const Domain& d) {
  std::vector<Vec3d> corners;
  for (int c = 0; c < 8; c++) {
    Vec3d x;
    for (int a = 0; a < 3; a++) {
      const bool high = c >> a & 1;
      x[a] = high ? b.max[a] : b.min[a];
      if (!std::isfinite(x[a])) x[a] = high ? d.max[a] : d.min[a];
    }
    corners.push_back(x);
  }
  return corners;
}

void addObstacle(const Wall& wall, const Domain& d, const Vec3d& up, ExpectedMotion& m) {
  constexpr double angle = 0.2;  // rad, between sampled poses
  constexpr int mostPoses = 200;
  const std::vector<Keyframe>& motion = wall.properties.motion;
  const std::vector<Vec3d> corners = cornersOf(wall.bounds, d);
  const Pose first = poseAt(motion, 0);
  const auto rise = [&](const Pose& pose) {
    for (const Vec3d& c : corners)
      m.lift = std::max(m.lift,
                        dot(up, withinDomain(d, fromRest(pose, c)) - withinDomain(d, fromRest(first, c))));
  };
  for (std::size_t k = 1; k < motion.size(); k++) {
    const double begin = motion[k - 1].time, span = motion[k].time - begin,
                 turn = length(motion[k].rotate - motion[k - 1].rotate);
    if (begin >= wall.properties.until) break;
    const int poses = static_cast<int>(
        std::clamp(std::ceil(turn / angle), 1.0, static_cast<double>(mostPoses)));
    for (int n = 0; n < poses; n++) {
      const Pose pose = poseAt(motion, begin + span * n / poses);
      rise(pose);
      for (const Vec3d& c : corners) {
        const double v = length(velocityAt(pose, withinDomain(d, fromRest(pose, c))));
        if (v > m.driven) m.driven = v, m.drivenBy = "obstacle '" + wall.properties.name + "'";
      }
    }
    rise(poseOf(motion[k].move, motion[k].rotate));
  }
}

}  // namespace

ExpectedMotion expectedMotion(const Scene& s,
                              const std::vector<std::shared_ptr<const SignedDistance>>& shapes,
                              const Walls& walls, const std::vector<EmitterPlan>& emitters) {
  ExpectedMotion m;
  const double g = length(s.domain.gravity);
  const Vec3d up = g > 0 ? s.domain.gravity * (-1 / g) : Vec3d{};
  addBodies(s, shapes, m);
  addEmitters(s, up, emitters, m);
  for (const Wall& wall : walls.list)
    if (wall.properties.motion.size() > 1) addObstacle(wall, s.domain, up, m);
  return m;
}

}  // namespace thaw
