// What happens where a vertex of a sheet, or an oriented particle, touches something: a spring with dashpot
// (Cundall & Strack 1979), a barrier, and Coulomb friction; of sheets per area.
#pragma once
#include <algorithm>
#include <cmath>

#include "core/contact/dashpot.hpp"
#include "core/math/vec3.hpp"

namespace thaw {

struct TouchLaw {
  double rate;         ///< 1/s, of the spring: its stiffness is mass * rate^2
  double mass;         ///< kg/m^2, or kg where forces are N
  double restitution;  ///< 1
  double friction;     ///< 1, Coulomb
  double span;         ///< s, of a step: friction does not stop what slides earlier
  double barrier = 0;  ///< N/m (or N/m^3), beside the spring a force 2 barrier depth^3 / reach^2: at full
                       ///< depth it has stored barrier reach^2 / 2, and what lies on it lightly does not feel
                       ///< it
  double reach = 1;    ///< m, depth at which all is lost
};

struct Touch {
  Vec3d force{};      ///< N/m^2 (or N) on the vertex
  double energy = 0;  ///< J/m^2 (or J), stored
  Vec3d resisting{};  ///< its part that takes energy away; the loss is - resisting * velocity, that after the
                      ///< push of all forces
  double slope = 0;   ///< N/m^3 (or N/m), bounds the step; the dashpot is in it
};

/// Coulomb friction (N/m^2, or N) of what is pressed together by `normal` and slides.
inline Vec3d frictionOf(const TouchLaw& law, double normal, const Vec3d& slide) {
  const double speed = length(slide);
  if (!(speed > 0) || !(law.friction > 0)) return {};
  return slide * -std::min(law.friction * normal / speed, 0.5 * law.mass / law.span);
}

/// N/m^3 (or N/m), slope of the force at the depth (m; below 0: not yet touching) that is come to within the
/// next step, at a speed of separation of vn (m/s).
inline double slopeAhead(const TouchLaw& law, double depth, double vn) {
  const double ratio = dashpotRatio(law.restitution), k = law.mass * law.rate * law.rate,
               steep = 2 * law.barrier / (law.reach * law.reach);
  const double stiffer = 1 + ratio * (2.2 + 1.1 * ratio);  // of steps that know the dashpot's velocity by the
                                                           // force before: a fit to the eigenvalues, within 3
                                                           // %
  const double deeper = std::min(law.reach, depth + std::max(0.0, -vn) * 1.1 * law.span);
  if (!(deeper > 0)) return 0;
  const double root = std::sqrt(k + 3 * steep * deeper * deeper) + std::sqrt(k) * (stiffer - 1);
  return root * root;
}

/// depth > 0 (m): how far within the thickness; n: out of what is touched; v: relative velocity (m/s).
inline Touch touchOf(const TouchLaw& law, double depth, const Vec3d& n, const Vec3d& v) {
  Touch t;
  const double ratio = dashpotRatio(law.restitution), k = law.mass * law.rate * law.rate,
               steep = 2 * law.barrier / (law.reach * law.reach),
               spring = (k + steep * depth * depth) * depth, vn = dot(v, n);
  const double dash = std::max(-2 * ratio * law.mass * law.rate * vn, -spring);  // a contact never pulls
  t.force = n * (spring + dash);
  t.energy = (0.5 * k + 0.25 * steep * depth * depth) * depth * depth;
  t.resisting = n * dash;
  t.slope = slopeAhead(law, depth, vn);
  const Vec3d rub = frictionOf(law, spring + dash, v - n * vn);
  t.force += rub;
  t.resisting += rub;
  return t;
}

/// Steps: who may be in contact at the end of the next one, which is longer by a tenth at most.
inline constexpr double comesNear = 1.5;

/// 1/s, over which a step is to follow a blow. What comes into contact within a step, or out of it, has its
/// energy off by (rate step)^2 / 6 of itself: so steps are short for what comes fast, and rest as stability
/// says. The speed (m/s) is that of approach or leaving; an eighth of the one that contact is made for (rate
/// * reach / 2) has steps of a quarter of a radian.
inline double blowRate(double rate, double reach, double speed) {
  return 4 * rate * speed / (0.0625 * rate * reach);
}

/// A rate (1/s) of approach as its average over a step (s): never beyond what it approaches.
inline double averaged(double rate, double span) {
  return rate * span > 0 ? -std::expm1(-rate * span) / span : 0;
}

}  // namespace thaw
