#include "core/surface/surfel_move.hpp"

#include <Eigen/Eigenvalues>

#include "core/math/hash_random.hpp"
#include "core/surface/keep_out.hpp"

namespace thaw {
namespace {

Vec3d three(const SurfelSums& s, int channel, bool particles) {
  return particles ? Vec3d{s.particle(channel), s.particle(channel + 1), s.particle(channel + 2)}
                   : Vec3d{s.surfel(channel), s.surfel(channel + 1), s.surfel(channel + 2)};
}

/// Where smoothing would have the surfel (its height along the normal) and its normal.
/// What the slope of colour less level may be, over that of the colour: flatter ones, on stretched streams,
/// would send surfels far; steeper ones come where the last particles of a splash end.
constexpr double flattest = 0.25, steepest = 4;
/// Tangents of angles between the two slopes. Small ones are the lattice's, whose steps the colour's slope
/// shows less (on a ball of R / dx = 16 normals are then within .3 degrees, within .4 with all of them); and
/// where little is left of the difference its direction says nothing.
constexpr double leastTilt = 0.05, steepestTilt = 1.0;
/// Tolerance along the surface over the one across it: its shape does not depend on where surfels lie in it,
/// and resampling leaves no hole.
constexpr double evenEnough = 5;
/// Share of a step up to which one grows that goes on the same way: waves of many surfels come to rest
/// sooner; where single ones overshoot it halves. Where the force jumps, as where the level of a component
/// that is drawn in ends to follow its particles, it halves with each turn until the surfel stops there; a
/// share that ends at a tenth has thousands of surfels of a splash swing for ever.
constexpr double longestPace = 1.6, leastPace = 0.002;
/// Of what is solid in part the update keeps its liquid share of the way (blendSurfels), at least this much
/// counts: so much coarser is its stop.
constexpr double leastKept = 0.05;

struct Smooth {
  double height = 0;
  Vec3d normal{};
  bool any = false;
  double sure = 1;
};

/// On the plane of the neighbours and the surfel itself (K05). Without a gap between the two smallest
/// eigenvalues there is no plane (B23).
Smooth smoothToPlane(const SurfelSums& s, const Vec3d& normal) {
  const double weight = s.surfel(Weight) + 1;  // the surfel itself, at 0
  if (!(weight > 1.001)) return {};
  const Vec3d mean = -1.0 * three(s, Mean, false) / weight;  // sums hold surfel - neighbour
  Eigen::Matrix3d m;
  m << s.surfel(Moment), s.surfel(Moment + 3), s.surfel(Moment + 5), s.surfel(Moment + 3),
      s.surfel(Moment + 1), s.surfel(Moment + 4), s.surfel(Moment + 5), s.surfel(Moment + 4),
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
  return {-s.surfel(Height) / weight, sum / size, true, std::min(1.0, size / weight)};
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
  c.nearSlope = 6 * s.grid.support / (nearSupport * nearSupport * w.scene.spacing * w.scene.spacing);
  c.isoScale = w.scene.surface.isoLevel / 0.5;
  c.leastScale = w.scene.surface.leastLevel / 0.5;
  c.longest = 0.5 * w.scene.spacing;
  // forces of these weights turn a shift of all into `implicit` of it, and what changes from surfel to surfel
  // into up to the sum of both
  c.step = 1 / std::max(0.5, weights.implicit + 0.5 * weights.smooth);
  c.plane = w.scene.surface.smoothing == SmoothingForm::Plane;
  return c;
}

double raisedOf(const std::vector<RaisedComponent>& raised, std::uint64_t component) {
  const auto at = std::lower_bound(raised.begin(), raised.end(), component,
                                   [](const RaisedComponent& p, std::uint64_t c) { return p.component < c; });
  return at != raised.end() && at->component == component ? at->by : 0;
}

Pull pullOn(const World& w, const MoveContext& c, const SurfelSums& s, double raised, std::size_t i) {
  Pull p;
  Vec3d normal = w.surface.surfels.normal[i], force{};
  // the colour field: out of the body is down its gradient
  const double colour = s.particle(Colour), dx = w.scene.spacing;
  const Tightening tight = tighteningOf(raised / dx);
  raised = dx * offsetOf(raised / dx);
  if (colour > 0) {
    const Vec3d gradient = three(s, Gradient, true);  // of minus the colour field, over c.slope
    const double size = length(gradient), slope = c.slope * size;
    p.known = slope * c.support > 1e-2 * colour;
    const double fullness = s.particle(SmoothColour) / colour, flat = c.level->level(fullness),
                 level = tightened(flat, s.particle(Near), tight);
    if (const Surfels& f = w.surface.surfels;
        f.standing.active && f.standing[i] && colour > c.isoScale * level) {
      p.outward = p.normal = normal;
      p.along = c.weights.implicit *
                std::min((colour - c.isoScale * level) / std::max(slope, 1 / c.support), c.longest);
      p.known = true;
      return p;
    }
    if (p.known) {
      // The surface is where the colour is the level, which changes from place to place, too: on streams and
      // at rims almost as fast as the colour. So its normal is down the slope of their difference, and the
      // distance follows from that slope.
      const Vec3d down = gradient / size;
      const double byFullness = c.isoScale * level / flat * c.level->slope(fullness) / colour;
      const double byNear = s.particle(Near) < tight.full
                                ? c.isoScale * flat * tight.most / tight.full * c.nearSlope / c.slope
                                : 0;
      const Vec3d slopes = gradient - byFullness * (three(s, SmoothGradient, true) - fullness * gradient) +
                           byNear * three(s, NearGradient, true);
      const double steep = std::clamp(dot(slopes, down) / size, flattest, steepest);
      const Vec3d off = slopes / size - dot(slopes, down) / size * down;
      const double tilt = length(off) / steep,
                   trusted = tilt * tilt / (tilt * tilt + leastTilt * leastTilt) *
                             std::min(1.0, steepestTilt / std::max(tilt, steepestTilt));
      const Vec3d whole = steep * down + trusted * off;
      p.outward = normalized(whole);
      const double out = (colour - c.isoScale * level) / (slope * length(whole));
      // what lies on a wall stays there when the component is drawn in
      const bool held = raised < 0 && out > 0 &&
                        inWall(w, w.surface.surfels.position[i] + std::min(out, c.longest) * p.outward);
      const double height = std::clamp(held ? out : out + raised, -c.longest, c.longest);
      force += c.weights.implicit * height * p.outward;
      if (c.weights.attract > 0) {  // beyond what the kernel's mean particle is from any surface, that the
                                    // iso-surface may stay
        const Vec3d away = (c.unit / colour) * three(s, Attraction, true);
        const double depth = length(away);
        if (depth > 0)
          force -= (c.weights.attract * std::max(0.0, depth - c.support * c.level->depth(fullness)) / depth) *
                   away;
      }
      p.least = std::clamp((c.leastScale * level - colour) / slope, 0.0, c.longest);
      p.flipped = dot(normal, p.outward) < 0;
      if (p.flipped) normal = -normal;
    }
  }
  Smooth smooth;
  if (c.weights.smooth > 0) {
    smooth = c.plane ? smoothToPlane(s, normal) : smoothToSphere(s);
    p.keptNormal = !smooth.any;
  }
  Vec3d sum{};
  if (p.known) sum += c.weights.implicit * p.outward;
  if (smooth.any) {
    if (dot(smooth.normal, p.known ? p.outward : normal) < 0) smooth.normal = -smooth.normal;
    sum += c.weights.smooth * smooth.sure * smooth.normal;
  }
  const double size = length(sum);
  if (size > 1e-6) normal = sum / size;
  if (smooth.any) force += (c.weights.smooth * smooth.sure * smooth.height * c.unit) * normal;
  p.normal = normal;
  p.along = dot(normal, force);
  return p;
}

void moveSurfel(World& w, const MoveContext& c, const SurfelSums& s, double raised, std::size_t i,
                MoveCounts& counts) {
  Surfels& f = w.surface.surfels;
  const Vec3d before = f.position[i];
  const Pull pull = pullOn(w, c, s, raised, i);
  counts.flipped += pull.flipped;
  counts.keptNormals += pull.keptNormal;
  const Vec3d normal = pull.normal, facing = pull.known ? pull.outward : normal;
  Vec3d tangential{};
  if (c.weights.repel > 0) {
    // the way to where those around push it no more, as if they stayed: half of it and a bit, since they
    // move, too
    if (s.surfel(Stiffness) > 0)
      tangential = (c.spread * std::min(1.0, 2 * c.weights.repel) * c.unit / s.surfel(Stiffness)) *
                   three(s, Repulsion, false);
    if (s.surfel(Coincident) > 1) {  // at the same place as others: a direction by id
      Vec3d d;
      for (int a = 0; a < 3; a++)
        d[a] = randomUniform(w.scene.seed, Purpose::Separate, f.id[i], static_cast<std::uint64_t>(a)) - 0.5;
      tangential += (c.spread * c.weights.repel * f.radius[i]) * d;
    }
    tangential -= dot(normal, tangential) * normal;
    const double far = length(tangential), farthest = 0.25 * f.radius[i];
    if (far > farthest) tangential = (farthest / far) * tangential;
  }
  // the integration is damped where it goes to and fro: each time that the force turns round the step halves
  const double wanted = std::clamp(c.step * pull.along, -c.longest, c.longest),
               last = static_cast<double>(f.pace[i]);
  const double share = last == 0           ? 1
                       : wanted * last < 0 ? std::max(0.5 * std::abs(last), leastPace)
                                           : std::min(1.25 * std::abs(last), longestPace);
  f.pace[i] = static_cast<float>(wanted < 0 ? -share : share);
  const Vec3d normalMove = w.scene.surface.damping * c.ease * share * wanted * normal;
  Vec3d move = normalMove + w.scene.surface.damping * tangential;
  if (pull.least > 0) {  // below the least level: onto it
    const double inward = -dot(move, pull.outward);
    if (inward < pull.least) move -= (pull.least - inward) * pull.outward;
  }
  Vec3d x = outOfWalls(w, before + move, facing);
  const Vec3d back = x - (before + move);
  if (const double pushed = length(back); pushed > 0) {
    // it lies on a wall, which holds the normal force. Its part along the wall, by a few degrees, would have
    // the surfel creep for ever
    const Vec3d n = back / pushed, creep = normalMove - dot(normalMove, n) * n;
    const double onto = std::clamp(-2 * dot(normal, n) - 0.8, 0.0, 1.0);
    x = outOfWalls(w, x - onto * creep, facing);
  }
  const Vec3d gone = x - before;  // what the margin cuts off included
  const Vec3d off = x - c.found[i];
  const bool held = dot(off, off) > c.stray * c.stray;
  if (held) x = c.found[i] + (c.stray / length(off)) * off;
  f.position[i] = x;
  f.normal[i] = normal;
  Vec3d tangent = f.tangent[i] - dot(f.tangent[i], normal) * normal;
  if (!(dot(tangent, tangent) > 1e-6))
    tangent = cross(normal, std::abs(normal.x) < 0.6 ? Vec3d{1, 0, 0} : Vec3d{0, 1, 0});
  f.tangent[i] = normalized(tangent);
  const double kept = f.liquid.active && !(f.loose.active && f.loose[i])
                          ? std::clamp(static_cast<double>(f.liquid[i]), leastKept, 1.0)
                          : 1;
  const double height = dot(gone, normal), stop = w.scene.surface.stop * f.radius[i] / kept;
  const bool moving = std::abs(height) > stop || length(gone - height * normal) > evenEnough * stop;
  f.moving[i] = !moving ? 0 : held ? heldAtMargin : 1;
}

}  // namespace thaw
