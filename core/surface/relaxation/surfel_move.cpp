// SPDX-License-Identifier: Apache-2.0
#include "core/surface/relaxation/surfel_move.hpp"

#include <Eigen/Eigenvalues>

#include "core/math/hash_random.hpp"
#include "core/surface/relaxation/wall_projection.hpp"

namespace thaw {
namespace {

Vec3d three(const SurfelSums& s, int channel, bool particles) {
  return particles ? Vec3d{s.particle(channel), s.particle(channel + 1), s.particle(channel + 2)}
                   : Vec3d{s.surfel(channel), s.surfel(channel + 1), s.surfel(channel + 2)};
}

/// Bounds of the slope of colour minus level, over the slope of colour. Small slopes, on stretched streams,
/// would give large moves; large ones occur at the last particles of a splash.
constexpr double flattest = 0.25, steepest = 4;
/// Bounds of the tangent of the angle between the two slopes. Small angles come from the lattice, which
/// affects the colour's slope less: normals of a ball with R / dx = 16 are within 0.3 degrees, or 0.4 without
/// the lower bound. For large angles, the difference is small and its direction meaningless.
constexpr double leastTilt = 0.05, steepestTilt = 1.0;
/// Tolerance along the surface over that across it. Positions along the surface do not affect its shape, and
/// resampling closes holes.
constexpr double evenEnough = 5;
/// Bounds of the share of a step. The share grows while a surfel keeps its direction, which damps long waves
/// sooner, and halves when it overshoots. Where the force is discontinuous, as at the edge of the sparse
/// region of a component that is drawn in, it halves until the surfel stops. A lower bound of 0.1 would let
/// many surfels of a splash oscillate.
constexpr double mostStepShare = 1.6, leastStepShare = 0.002;
/// Least liquid share in the stop criterion. blendSurfels keeps only the liquid share of the motion of partly
/// solid surfels, so that a coarser criterion suffices.
constexpr double leastKept = 0.05;

struct Smooth {
  double height = 0;
  Vec3d normal{};
  bool any = false;
  double sure = 1;
};

/// Smooths to the plane of the surfel and its neighbours (K05). Without a gap between the two smallest
/// eigenvalues there is no plane (B23).
Smooth smoothToPlane(const SurfelSums& s, const Vec3d& normal) {
  // includes the surfel itself at the origin
  const double weight = s.surfel(Weight) + 1;
  if (!(weight > 1.001)) return {};
  // The sums hold surfel minus neighbour.
  const Vec3d mean = -1.0 * three(s, Mean, false) / weight;
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

/// Smooths to the sphere through the neighbours with their normals (co-circularity, ST92).
Smooth smoothToSphere(const SurfelSums& s) {
  const double weight = s.surfel(Weight);
  const Vec3d sum = three(s, Normal, false);
  const double size = length(sum);
  if (!(weight > 0.001) || !(size > 1e-3 * weight)) return {};
  return {-s.surfel(Height) / weight, sum / size, true, std::min(1.0, size / weight)};
}

}  // namespace

MoveContext moveContext(const Scene& scene, const Surface& s, const RelaxTools& tools,
                        const ForceWeights& weights) {
  MoveContext c;
  c.weights = weights;
  c.level = &tools.level;
  c.unit = s.grid.support;
  c.support = s.particleSupport;
  c.slope = 6 * s.grid.support / (s.particleSupport * s.particleSupport);
  c.nearSlope = 6 * s.grid.support / (nearSupport * nearSupport * scene.spacing * scene.spacing);
  c.isoScale = scene.surface.isoLevel / 0.5;
  c.leastScale = scene.surface.leastLevel / 0.5;
  c.longest = 0.5 * scene.spacing;
  // Forces of these weights scale a uniform shift by `implicit`, and short waves by up to the sum of both.
  c.step = 1 / std::max(0.5, weights.implicit + 0.5 * weights.smooth);
  c.plane = scene.surface.smoothing == SmoothingForm::Plane;
  return c;
}

NormalForce normalForceOn(const SurfaceView& w, const MoveContext& c, const SurfelSums& s, double isoOffset,
                          std::size_t i) {
  NormalForce p;
  Vec3d normal = w.surface.surfels.normal[i], force{};
  // Colour field: its gradient points into the body.
  const double colour = s.particle(Colour), dx = w.scene.spacing;
  const LevelRise tight = levelRiseOf(isoOffset / dx);
  isoOffset = dx * limitedIsoOffset(isoOffset / dx);
  if (colour > 0) {
    // negative gradient of the colour field, over c.slope
    const Vec3d gradient = three(s, Gradient, true);
    const double size = length(gradient), slope = c.slope * size;
    p.known = slope * c.support > 1e-2 * colour;
    const double fullness = s.particle(SmoothColour) / colour, flat = c.level->level(fullness),
                 level = raisedLevel(flat, s.particle(Near), tight);
    if (const Surfels& f = w.surface.surfels;
        f.wallAligned.active && f.wallAligned[i] && colour > c.isoScale * level) {
      p.outward = p.normal = normal;
      p.along = c.weights.implicit *
                std::min((colour - c.isoScale * level) / std::max(slope, 1 / c.support), c.longest);
      p.known = true;
      return p;
    }
    if (p.known) {
      // The surface is where colour equals level. The level also varies, on streams and at rims almost as
      // fast as the colour. Normal and distance therefore follow from the slope of their difference.
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
      // Surfels on a wall stay there when the component is drawn in.
      const bool stopped = isoOffset < 0 && out > 0 &&
                           inWall(w, w.surface.surfels.position[i] + std::min(out, c.longest) * p.outward);
      const double height = std::clamp(stopped ? out : out + isoOffset, -c.longest, c.longest);
      force += c.weights.implicit * height * p.outward;
      // Attraction acts only beyond the depth of the mean particle at any surface, so that the iso-surface is
      // an equilibrium.
      if (c.weights.attract > 0) {
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

void moveSurfel(const SurfaceView& w, const MoveContext& c, const SurfelSums& s, double isoOffset,
                std::size_t i, MoveCounts& counts) {
  Surfels& f = w.surface.surfels;
  const Vec3d before = f.position[i];
  const NormalForce normalForce = normalForceOn(w, c, s, isoOffset, i);
  counts.flipped += normalForce.flipped;
  counts.keptNormals += normalForce.keptNormal;
  const Vec3d normal = normalForce.normal, facing = normalForce.known ? normalForce.outward : normal;
  Vec3d tangential{};
  if (c.weights.repel > 0) {
    // Moves towards the point where static neighbours would not repel the surfel: slightly more than half the
    // way, since they move as well.
    if (s.surfel(Stiffness) > 0)
      tangential = (c.spread * std::min(1.0, 2 * c.weights.repel) * c.unit / s.surfel(Stiffness)) *
                   three(s, Repulsion, false);
    // Coincident surfels separate in a direction given by their id.
    if (s.surfel(Coincident) > 1) {
      Vec3d d;
      for (int a = 0; a < 3; a++)
        d[a] = randomUniform(w.scene.seed, Purpose::Separate, f.id[i], static_cast<std::uint64_t>(a)) - 0.5;
      tangential += (c.spread * c.weights.repel * f.radius[i]) * d;
    }
    tangential -= dot(normal, tangential) * normal;
    const double far = length(tangential), farthest = 0.25 * f.radius[i];
    if (far > farthest) tangential = (farthest / far) * tangential;
  }
  // Damps oscillations: the step halves each time that the force changes sign.
  const double wanted = std::clamp(c.step * normalForce.along, -c.longest, c.longest),
               last = static_cast<double>(f.stepShare[i]);
  const double share = last == 0           ? 1
                       : wanted * last < 0 ? std::max(0.5 * std::abs(last), leastStepShare)
                                           : std::min(1.25 * std::abs(last), mostStepShare);
  f.stepShare[i] = static_cast<float>(wanted < 0 ? -share : share);
  const Vec3d normalMove = w.scene.surface.damping * c.ease * share * wanted * normal;
  Vec3d move = normalMove + w.scene.surface.damping * tangential;
  // Surfels below the least level are projected onto it.
  if (normalForce.least > 0) {
    const double inward = -dot(move, normalForce.outward);
    if (inward < normalForce.least) move -= (normalForce.least - inward) * normalForce.outward;
  }
  Vec3d x = projectedOutOfWalls(w, before + move, facing);
  const Vec3d back = x - (before + move);
  if (const double pushed = length(back); pushed > 0) {
    // A wall carries the normal force of a surfel on it. A component along the wall, at small angles, would
    // let the surfel creep.
    const Vec3d n = back / pushed, creep = normalMove - dot(normalMove, n) * n;
    const double onto = std::clamp(-2 * dot(normal, n) - 0.8, 0.0, 1.0);
    x = projectedOutOfWalls(w, x - onto * creep, facing);
  }
  // includes the part that the margin cuts off
  const Vec3d gone = x - before;
  const Vec3d off = x - c.found[i];
  const bool stopped = dot(off, off) > c.stray * c.stray;
  if (stopped) x = c.found[i] + (c.stray / length(off)) * off;
  f.position[i] = x;
  f.normal[i] = normal;
  Vec3d tangent = f.tangent[i] - dot(f.tangent[i], normal) * normal;
  if (!(dot(tangent, tangent) > 1e-6))
    tangent = cross(normal, std::abs(normal.x) < 0.6 ? Vec3d{1, 0, 0} : Vec3d{0, 1, 0});
  f.tangent[i] = normalized(tangent);
  const double kept = f.liquid.active && !(f.relaxesOnce.active && f.relaxesOnce[i])
                          ? std::clamp(static_cast<double>(f.liquid[i]), leastKept, 1.0)
                          : 1;
  const double height = dot(gone, normal), stop = w.scene.surface.stop * f.radius[i] / kept;
  const bool moving = std::abs(height) > stop || length(gone - height * normal) > evenEnough * stop;
  f.moving[i] = !moving ? 0 : stopped ? stoppedAtMargin : 1;
}

}  // namespace thaw
