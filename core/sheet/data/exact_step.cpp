// SPDX-License-Identifier: Apache-2.0
#include "core/sheet/data/exact_step.hpp"

#include <cmath>
#include <limits>
#include <stdexcept>

namespace thaw {
namespace {

using Real = long double;

/// (e^x - 1) / x
Real meanExponential(Real x) { return x == 0 ? 1 : std::expm1(x) / x; }

/// Power series in t of the three responses, for a = c t / 2m and w2 = K t^2 / m both below 1. h_n are the
/// complete symmetric polynomials of the two roots, so the double root is no special case.
ExactStep byseries(const SpringLaw& law, Real t, Real a, Real w2) {
  Real before = 0, h = 1, factorial = 1, qv = 0, qr = 0;
  for (int n = 0; n < 30; n++) {
    factorial *= n + 1;  // (n + 1)!
    qv += h / factorial;
    qr += h / (factorial * (n + 2));
    const Real next = -2 * a * h - w2 * before;
    before = h;
    h = next;
  }
  const Real m = law.mass;
  return {static_cast<double>(t * qv), static_cast<double>(1 - 2 * a * qv - w2 * qr),
          static_cast<double>(qr * t * t / m), static_cast<double>(t * qv / m)};
}

/// Two real roots, including a double root; m may be 0. e^slow and e^fast are the decay factors of the two
/// solutions over the step.
ExactStep overdamped(const SpringLaw& law, Real t) {
  const Real m = law.mass, c = law.damping, k = law.stiffness;
  // difference of the roots over their sum
  const Real gap = std::sqrt(std::fmax(Real(0), 1 - 4 * m / c * (k / c)));
  const Real slow = -2 * k * t / (c * (1 + gap));
  const Real apart = m > 0 ? c * t / m * gap : std::numeric_limits<Real>::infinity();
  const Real ratio = std::exp(-apart), decay = std::exp(slow);
  const Real vr = apart < 1 ? decay * t / m * meanExponential(-apart) : decay * (1 - ratio) / (c * gap);
  const Real qv = vr * m;
  const Real vv = decay * ratio + slow * qv / t;
  const Real qr = (meanExponential(slow) - qv / t) * 2 * t / (c * (1 + gap));
  return {static_cast<double>(qv), static_cast<double>(vv), static_cast<double>(qr), static_cast<double>(vr)};
}

ExactStep underdamped(const SpringLaw& law, Real t, Real a, Real w2) {
  const Real m = law.mass, s2 = w2 - a * a, s = std::sqrt(s2), decay = std::exp(-a);
  const Real sinc = s > 0 ? std::sin(s) / s : 1;
  const Real qv = decay * sinc, vv = decay * (std::cos(s) - a * sinc);
  Real qr = (1 - vv - 2 * a * qv) / w2;
  if (a == 0) {  // 1 - cos without cancellation
    const Real half = std::sin(s / 2);
    qr = 2 * half * half / w2;
  }
  return {static_cast<double>(t * qv), static_cast<double>(vv), static_cast<double>(qr * t * t / m),
          static_cast<double>(t * qv / m)};
}

}  // namespace

ExactStep exactStep(const SpringLaw& law, double dt) {
  if (!(law.mass >= 0 && law.damping >= 0 && law.stiffness >= 0 && dt >= 0))
    throw std::invalid_argument("mass, damping, stiffness and step must be 0 or positive");
  const Real m = law.mass, c = law.damping, k = law.stiffness, t = dt;
  if (m == 0 && c == 0) {
    if (k == 0)
      throw std::invalid_argument(
          "a sheet's mass, damping and stiffness are all 0; expected at least one above 0");
    return {0, 0, dt > 0 ? 1 / law.stiffness : 0, 0};
  }
  if (dt == 0) return m > 0 ? ExactStep{0, 1, 0, 0} : ExactStep{0, 0, 0, 1 / law.damping};
  if (m > 0) {
    const Real a = c * t / (2 * m), w2 = k * t / m * t;
    if (a < 1 && w2 < 1) return byseries(law, t, a, w2);
    if (a * a < w2) return underdamped(law, t, a, w2);
  }
  return overdamped(law, t);
}

SplitForce splitForce(const SpringLaw& law, const ExactStep& x, double dt) {
  if (!(law.mass > 0) || !(dt > 0)) return {x.vr, 0};
  // (pi/2)^2
  const double a = law.damping * dt / (2 * law.mass), w2 = law.stiffness * dt * dt / law.mass,
               quarter = 2.4674011002723395;
  if (w2 - a * a < quarter && x.qv > 0) {
    const double before = x.vv * (x.qr / x.qv);
    return {before, x.vr - before};
  }
  // Weights of a force that grows linearly; beyond a quarter of an oscillation stableSlope is 0.
  return {x.vr - x.qr / dt, x.qr / dt};
}

double stableSlope(const SpringLaw& law, double dt) {
  constexpr double infinite = std::numeric_limits<double>::infinity(), quarter = 2.4674011002723395;
  if (!(dt > 0)) return infinite;
  const ExactStep x = exactStep(law, dt);
  if (law.mass > 0 &&
      law.stiffness * dt * dt / law.mass - std::pow(law.damping * dt / (2 * law.mass), 2) >= quarter)
    return 0;
  const SplitForce split = splitForce(law, x, dt);
  const double free = 1 - x.qr * law.stiffness, det = free * x.vv + x.qv * x.vr * law.stiffness;
  const double reach = x.qr + split.after * x.qv;
  return reach > 0 ? (1 + det + free + x.vv) / reach : infinite;
}

double stableStep(const SpringLaw& law, double kappa) {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  if (!(kappa > 0)) return infinite;
  // doubles a stable step until it is unstable, then bisects 50 times, which is far more accurate than kappa
  double low = law.mass > 0      ? std::sqrt(law.mass / (kappa + law.stiffness))
               : law.damping > 0 ? law.damping / (kappa + law.stiffness)
                                 : 0;
  if (law.mass == 0 && law.damping == 0) return kappa <= law.stiffness ? infinite : 0;
  double high = low;
  for (int k = 0; k < 200 && stableSlope(law, high) >= kappa; k++) high *= 2;
  if (stableSlope(law, high) >= kappa) return infinite;
  for (int k = 0; k < 50; k++) {
    const double middle = 0.5 * (low + high);
    (stableSlope(law, middle) >= kappa ? low : high) = middle;
  }
  return low;
}

}  // namespace thaw
