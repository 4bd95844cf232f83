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

/// Bounds of the slope of colour minus level, over the slope of colour. Small slopes occur on stretched
/// streams, and would give large moves. Large slopes occur at the outermost particles of a splash.
constexpr double flattest = 0.25, steepest = 4;
/// Bounds of the tangent of the angle between the two slopes. Small angles are due to the lattice, which
/// affects the colour's slope less. With the lower bound, normals of a ball with R / dx = 16 are accurate to
/// 0.3 degrees, without it to 0.4. For large angles, the difference of colour and level has a small slope of
/// meaningless direction.
constexpr double leastTilt = 0.05, steepestTilt = 1.0;
/// Tolerance along the surface over that across it. Positions along the surface do not affect its shape, and
/// resampling closes holes.
constexpr double evenEnough = 5;
/// Bounds of the fraction of a step by which a surfel moves. The fraction grows while the surfel keeps its
/// direction, which damps long waves sooner, and halves when it overshoots. At a discontinuity of the force,
/// it halves until the surfel stops. An example is the edge of the sparse region of a component that is drawn
/// in. With a lower bound of 0.1, many surfels of a splash would oscillate.
constexpr double mostStepShare = 1.6, leastStepShare = 0.002;
/// Smallest liquid fraction in the stop criterion. blendSurfels keeps only the liquid fraction of the
/// motion of partly solid surfels, so a coarser criterion suffices.
constexpr double leastKept = 0.05;

struct Smooth {
  double height = 0;
  Vec3d normal{};
  bool any = false;
  double sure = 1;
};

/// Smooths to the plane of the surfel and its neighbours (K05). Without a gap between the two smallest
/// eigenvalues there is no plane (stability row 23).
Smooth smoothToPlane(const SurfelSums& s, const Vec3d& normal) {
  // includes the surfel itself, at the origin
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

/// Colour field at a surfel. Its gradient points into the body; sums hold its negative.
struct ColourHere {
  double colour = 0;
  double fullness = 0;   ///< smoothed colour over colour
  double flatLevel = 0;  ///< level of a flat surface of this fullness
  double level = 0;      ///< level including the rise of the component
  Vec3d gradient{};      ///< negative gradient over MoveContext::slope
  double size = 0;       ///< length of `gradient`
  double slope = 0;      ///< 1/m, length of the gradient of colour
};

/// Requires: colour above 0.
ColourHere colourAt(const MoveContext& c, const SurfelSums& s, const LevelRise& rise) {
  ColourHere f;
  f.colour = s.particle(Colour);
  f.gradient = three(s, Gradient, true);
  f.size = length(f.gradient);
  f.slope = c.slope * f.size;
  f.fullness = s.particle(SmoothColour) / f.colour;
  f.flatLevel = c.level->level(f.fullness);
  f.level = raisedLevel(f.flatLevel, s.particle(Near), rise);
  return f;
}

/// Returns the negative slope of colour minus level at the surface, over the slope of colour. The level also
/// varies, on streams and at rims almost as fast as the colour. Normal and distance therefore follow from
/// this slope.
Vec3d slopeToLevel(const MoveContext& c, const SurfelSums& s, const ColourHere& f, const LevelRise& rise) {
  const Vec3d down = f.gradient / f.size;
  const double byFullness = c.isoScale * f.level / f.flatLevel * c.level->slope(f.fullness) / f.colour;
  const double byNear = s.particle(Near) < rise.densityMeasure
                            ? c.isoScale * f.flatLevel * rise.largestRise / rise.densityMeasure *
                                  c.nearSlope / c.slope
                            : 0;
  const Vec3d slopes = f.gradient - byFullness * (three(s, SmoothGradient, true) - f.fullness * f.gradient) +
                       byNear * three(s, NearGradient, true);
  const double steep = std::clamp(dot(slopes, down) / f.size, flattest, steepest);
  const Vec3d off = slopes / f.size - dot(slopes, down) / f.size * down;
  const double tilt = length(off) / steep,
               trusted = tilt * tilt / (tilt * tilt + leastTilt * leastTilt) *
                         std::min(1.0, steepestTilt / std::max(tilt, steepestTilt));
  return steep * down + trusted * off;
}

/// Returns the force toward the depth that the particles' mean has at a surface. It acts only beyond that
/// depth, so the iso-surface is an equilibrium.
Vec3d attraction(const MoveContext& c, const SurfelSums& s, const ColourHere& f) {
  const Vec3d away = (c.unit / f.colour) * three(s, Attraction, true);
  const double depth = length(away);
  if (!(depth > 0)) return {};
  return -((c.weights.attract * std::max(0.0, depth - c.support * c.level->depth(f.fullness)) / depth) *
           away);
}

/// Sets the force on a surfel that keeps the normal of a wall (alignWithWalls).
void setForceAlongWall(const MoveContext& c, const ColourHere& f, const Vec3d& normal, NormalForce& p) {
  p.outward = p.normal = normal;
  p.along = c.weights.implicit *
            std::min((f.colour - c.isoScale * f.level) / std::max(f.slope, 1 / c.support), c.longest);
  p.known = true;
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
  const Surfels& surfels = w.surface.surfels;
  NormalForce p;
  Vec3d normal = surfels.normal[i], force{};
  const double dx = w.scene.spacing;
  const LevelRise rise = levelRiseOf(isoOffset / dx);
  isoOffset = dx * limitedIsoOffset(isoOffset / dx);
  if (s.particle(Colour) > 0) {
    const ColourHere f = colourAt(c, s, rise);
    p.known = f.slope * c.support > 1e-2 * f.colour;
    if (surfels.wallAligned.active && surfels.wallAligned[i] && f.colour > c.isoScale * f.level) {
      setForceAlongWall(c, f, normal, p);
      return p;
    }
    if (p.known) {
      const Vec3d slope = slopeToLevel(c, s, f, rise);
      p.outward = normalized(slope);
      const double out = (f.colour - c.isoScale * f.level) / (f.slope * length(slope));
      // Surfels on a wall stay there when the component is drawn in.
      const bool stopped = isoOffset < 0 && out > 0 &&
                           inWall(w, surfels.position[i] + std::min(out, c.longest) * p.outward);
      const double height = std::clamp(stopped ? out : out + isoOffset, -c.longest, c.longest);
      force += c.weights.implicit * height * p.outward;
      if (c.weights.attract > 0) force += attraction(c, s, f);
      p.least = std::clamp((c.leastScale * f.level - f.colour) / f.slope, 0.0, c.longest);
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

namespace {

/// Returns the move (m) along the surface, at most a quarter of the radius. It is towards the point where
/// static neighbours would not repel the surfel. It is slightly more than half the way, since neighbours move
/// as well.
Vec3d tangentialMove(const SurfaceView& w, const MoveContext& c, const SurfelSums& s, const Vec3d& normal,
                     std::size_t i) {
  const Surfels& f = w.surface.surfels;
  Vec3d move{};
  if (!(c.weights.repel > 0)) return move;
  if (s.surfel(Stiffness) > 0)
    move = (c.spread * std::min(1.0, 2 * c.weights.repel) * c.unit / s.surfel(Stiffness)) *
           three(s, Repulsion, false);
  // Coincident surfels separate in a direction given by their id.
  if (s.surfel(Coincident) > 1) {
    Vec3d d;
    for (int a = 0; a < 3; a++)
      d[a] = randomUniform(w.scene.seed, Purpose::Separate, f.id[i], static_cast<std::uint64_t>(a)) - 0.5;
    move += (c.spread * c.weights.repel * f.radius[i]) * d;
  }
  move -= dot(normal, move) * normal;
  const double far = length(move), farthest = 0.25 * f.radius[i];
  if (far > farthest) move = (farthest / far) * move;
  return move;
}

/// Returns the fraction of the step by which a surfel moves. It damps oscillations, because it halves each
/// time the force changes sign. last: previous fraction, with the sign of its move; 0: none.
double stepShareOf(double wanted, double last) {
  return last == 0           ? 1
         : wanted * last < 0 ? std::max(0.5 * std::abs(last), leastStepShare)
                             : std::min(1.25 * std::abs(last), mostStepShare);
}

/// Returns the position (m) after a move, outside of walls. facing: outward normal. normal: normal of the
/// surfel.
Vec3d movedAlongWalls(const SurfaceView& w, const Vec3d& target, const Vec3d& normalMove, const Vec3d& normal,
                      const Vec3d& facing) {
  Vec3d x = projectedOutOfWalls(w, target, facing);
  const Vec3d back = x - target;
  if (const double pushed = length(back); pushed > 0) {
    // A wall balances the normal force of a surfel on it. At small angles, a component along the wall would
    // let the surfel creep.
    const Vec3d n = back / pushed, creep = normalMove - dot(normalMove, n) * n;
    const double onto = std::clamp(-2 * dot(normal, n) - 0.8, 0.0, 1.0);
    x = projectedOutOfWalls(w, x - onto * creep, facing);
  }
  return x;
}

void turnSurfel(Surfels& f, std::size_t i, const Vec3d& normal) {
  f.normal[i] = normal;
  Vec3d tangent = f.tangent[i] - dot(f.tangent[i], normal) * normal;
  if (!(dot(tangent, tangent) > 1e-6))
    tangent = cross(normal, std::abs(normal.x) < 0.6 ? Vec3d{1, 0, 0} : Vec3d{0, 1, 0});
  f.tangent[i] = normalized(tangent);
}

/// Returns whether a surfel still moves: its move `gone` (m), before the limit by the margin, exceeds the
/// stop criterion.
bool stillMoves(const SurfaceView& w, std::size_t i, const Vec3d& gone, const Vec3d& normal) {
  const Surfels& f = w.surface.surfels;
  const double kept = f.liquid.active && !(f.relaxesOnce.active && f.relaxesOnce[i])
                          ? std::clamp(static_cast<double>(f.liquid[i]), leastKept, 1.0)
                          : 1;
  const double height = dot(gone, normal), stop = w.scene.surface.stop * f.radius[i] / kept;
  return std::abs(height) > stop || length(gone - height * normal) > evenEnough * stop;
}

}  // namespace

void moveSurfel(const SurfaceView& w, const MoveContext& c, const SurfelSums& s, double isoOffset,
                std::size_t i, MoveCounts& counts) {
  Surfels& f = w.surface.surfels;
  const Vec3d before = f.position[i];
  const NormalForce force = normalForceOn(w, c, s, isoOffset, i);
  counts.flipped += force.flipped;
  counts.keptNormals += force.keptNormal;
  const Vec3d normal = force.normal, facing = force.known ? force.outward : normal;
  const Vec3d tangential = tangentialMove(w, c, s, normal, i);
  const double wanted = std::clamp(c.step * force.along, -c.longest, c.longest),
               share = stepShareOf(wanted, static_cast<double>(f.stepShare[i]));
  f.stepShare[i] = static_cast<float>(wanted < 0 ? -share : share);
  const Vec3d normalMove = w.scene.surface.damping * c.ease * share * wanted * normal;
  Vec3d move = normalMove + w.scene.surface.damping * tangential;
  // Surfels below the least level are projected onto it.
  if (force.least > 0) {
    const double inward = -dot(move, force.outward);
    if (inward < force.least) move -= (force.least - inward) * force.outward;
  }
  Vec3d x = movedAlongWalls(w, before + move, normalMove, normal, facing);
  const Vec3d gone = x - before, off = x - c.found[i];
  const bool stopped = dot(off, off) > c.stray * c.stray;
  if (stopped) x = c.found[i] + (c.stray / length(off)) * off;
  f.position[i] = x;
  turnSurfel(f, i, normal);
  f.moving[i] = !stillMoves(w, i, gone, normal) ? 0 : stopped ? stoppedAtMargin : 1;
}

}  // namespace thaw
