#include "core/surface/surfel_move.hpp"

#include <Eigen/Eigenvalues>

#include "core/math/hash_random.hpp"

namespace thaw {
namespace {

Vec3d three(const SurfelSums& s, int channel, bool particles) {
  return particles ? Vec3d{s.particle(channel), s.particle(channel + 1), s.particle(channel + 2)} : Vec3d{s.surfel(channel), s.surfel(channel + 1), s.surfel(channel + 2)};
}

/// Where smoothing would have the surfel (its height along the normal) and its normal.
struct Smooth { double height = 0; Vec3d normal{}; bool any = false; };

/// On the plane of the neighbours and the surfel itself (K05). Without a gap between the two smallest eigenvalues there is no plane (B23).
Smooth smoothToPlane(const SurfelSums& s, const Vec3d& normal) {
  const double weight = s.surfel(Weight) + 1;  // the surfel itself, at 0
  if (!(weight > 1.001)) return {};
  const Vec3d mean = -1.0 * three(s, Mean, false) / weight;  // sums hold surfel - neighbour
  Eigen::Matrix3d m;
  m << s.surfel(Moment), s.surfel(Moment + 3), s.surfel(Moment + 5), s.surfel(Moment + 3), s.surfel(Moment + 1), s.surfel(Moment + 4), s.surfel(Moment + 5), s.surfel(Moment + 4),
      s.surfel(Moment + 2);
  const Eigen::Vector3d at(mean.x, mean.y, mean.z);
  m = (m / weight - at * at.transpose()).eval();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(m);
  const auto& e = solver.eigenvalues();
  if (!(e(1) > 2 * std::max(e(0), 0.0)) || !(e(1) > 0.02 * e(2))) return {};
  Smooth out;
  out.any = true;
  out.normal = {solver.eigenvectors()(0, 0), solver.eigenvectors()(1, 0), solver.eigenvectors()(2, 0)};
  if (dot(out.normal, normal) < 0) out.normal = -out.normal;
  out.height = dot(out.normal, mean);
  return out;
}

/// On the sphere that the neighbours and their normals suggest (co-circularity, ST92).
Smooth smoothToSphere(const SurfelSums& s) {
  const double weight = s.surfel(Weight);
  const Vec3d sum = three(s, Normal, false);
  const double size = length(sum);
  if (!(weight > 0.001) || !(size > 1e-3 * weight)) return {};
  return {-s.surfel(Height) / weight, sum / size, true};
}

/// Pushes a place out of walls and obstacles; the surface then lies on them, on the body's side: of thin ones (the bottom of a glass) the nearest
/// way out may be the far side, where the surface would enclose the wall. `outward`: of the body there.
Vec3d outOfWalls(const World& w, Vec3d x, const Vec3d& outward) {
  for (const Wall& wall : w.walls.list) {
    if (!wall.present) continue;
    const Vec3d rest = toRest(wall.pose, x);
    const Bounds& b = wall.bounds;
    bool outside = false;
    for (int a = 0; a < 3; a++) outside = outside || rest[a] < b.min[a] || rest[a] > b.max[a];
    if (outside) continue;
    Vec3d n;
    const double d = wall.shape->distanceWithin(rest, w.grid.support, &n);
    if (!(d < 0)) continue;
    if (n = directionFromRest(wall.pose, n); dot(n, outward) <= 0.5) {
      x -= d * n;
      continue;
    }
    Vec3d back = x;  // into the body, until it is out of the wall
    double inside = d, gone = 0;
    for (const double longest = 2 * w.scene.spacing; inside < 0 && gone < longest;) {
      const double step = 1e-3 * w.scene.spacing - inside;
      gone += step;
      back -= step * outward;
      inside = wall.shape->distanceWithin(toRest(wall.pose, back), w.grid.support, nullptr);
    }
    x = inside < 0 ? x - d * n : back;
  }
  return x;
}

}  // namespace

MoveContext moveContext(const World& w, const RelaxTools& tools, const ForceWeights& weights) {
  const Surface& s = w.surface;
  MoveContext c;
  c.weights = weights;
  c.level = &tools.level;
  c.unit = s.grid.support;
  c.support = s.particleSupport;
  c.slope = 6 * s.grid.support / (s.particleSupport * s.particleSupport);
  c.isoScale = w.scene.surface.isoLevel / 0.5;
  c.leastScale = w.scene.surface.leastLevel / 0.5;
  c.longest = 0.5 * w.scene.spacing;
  c.plane = w.scene.surface.smoothing == SmoothingForm::Plane;
  return c;
}

double pushOf(const std::vector<ComponentPush>& pushes, std::uint64_t component) {
  const auto at = std::lower_bound(pushes.begin(), pushes.end(), component, [](const ComponentPush& p, std::uint64_t c) { return p.component < c; });
  return at != pushes.end() && at->component == component ? at->distance : 0;
}

double moveSurfel(World& w, const MoveContext& c, const SurfelSums& s, double push, std::size_t i, MoveCounts& counts) {
  Surfels& f = w.surface.surfels;
  const Vec3d before = f.position[i];
  Vec3d normal = f.normal[i], force{};
  // the colour field: out of the body is down its gradient
  const double colour = s.particle(Colour);
  Vec3d outward{};
  double least = 0;  // how far into the body at least
  bool known = false;
  if (colour > 0) {
    const Vec3d gradient = three(s, Gradient, true);  // of minus the colour field, over c.slope
    const double size = length(gradient), slope = c.slope * size;
    known = slope * c.support > 1e-2 * colour;
    if (known) {
      outward = gradient / size;
      const double fullness = s.particle(SmoothColour) / colour, level = tightened(c.level->level(fullness), s.particle(Near));
      const double height = std::clamp((colour - c.isoScale * level) / slope, -c.longest, c.longest);
      force += c.weights.implicit * height * outward;
      if (c.weights.attract > 0) {  // beyond what the kernel's mean particle is from any surface, that the iso-surface may stay
        const Vec3d away = (c.unit / colour) * three(s, Attraction, true);
        const double depth = length(away);
        if (depth > 0) force -= (c.weights.attract * (depth - c.support * c.level->depth(fullness)) / depth) * away;
      }
      least = std::clamp((c.leastScale * level - colour) / slope, 0.0, c.longest);
      if (dot(normal, outward) < 0) {
        counts.flipped++;
        normal = -normal;
      }
    }
  }
  Smooth smooth;
  if (c.weights.smooth > 0) {
    smooth = c.plane ? smoothToPlane(s, normal) : smoothToSphere(s);
    if (!smooth.any) counts.keptNormals++;
  }
  Vec3d sum{};
  if (known) sum += c.weights.implicit * outward;
  if (smooth.any) {
    if (dot(smooth.normal, known ? outward : normal) < 0) smooth.normal = -smooth.normal;
    sum += c.weights.smooth * smooth.normal;
  }
  const double size = length(sum);
  if (size > 1e-6) normal = sum / size;
  if (smooth.any) force += (c.weights.smooth * smooth.height * c.unit) * normal;
  force += push * normal;

  Vec3d tangential{};
  if (c.weights.repel > 0) {
    tangential = (c.spread * c.weights.repel * c.unit * std::min(1.0, 6 / std::max(1.0, s.surfel(Crowd)))) * three(s, Repulsion, false);
    if (s.surfel(Coincident) > 1) {  // at the same place as others: a direction by id
      Vec3d d;
      for (int a = 0; a < 3; a++) d[a] = randomUniform(w.scene.seed, Purpose::Separate, f.id[i], static_cast<std::uint64_t>(a)) - 0.5;
      tangential += (c.spread * c.weights.repel * f.radius[i]) * d;
    }
    tangential -= dot(normal, tangential) * normal;
    const double far = length(tangential), farthest = 0.25 * f.radius[i];
    if (far > farthest) tangential = (farthest / far) * tangential;
  }
  const double along = std::clamp(dot(normal, force), -c.longest, c.longest);
  Vec3d move = w.scene.surface.damping * (along * normal + tangential);
  if (least > 0) {  // below the least level: onto it
    const double inward = -dot(move, outward);
    if (inward < least) move -= (least - inward) * outward;
  }
  const Vec3d x = outOfWalls(w, before + move, known ? outward : normal);
  f.position[i] = x;
  f.normal[i] = normal;
  Vec3d tangent = f.tangent[i] - dot(f.tangent[i], normal) * normal;
  if (!(dot(tangent, tangent) > 1e-6)) tangent = cross(normal, std::abs(normal.x) < 0.6 ? Vec3d{1, 0, 0} : Vec3d{0, 1, 0});
  f.tangent[i] = normalized(tangent);
  return length(x - before);
}

}  // namespace thaw
