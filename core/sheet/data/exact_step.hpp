// SPDX-License-Identifier: Apache-2.0
// Exact solution of m q'' + c q' + K (q - q0) = f over a step of constant f (DS section 2). It is one linear
// map for all vertices of a material. It is also accurate at the double root, for c = 0 or K = 0, and for m
// towards 0.
#pragma once

namespace thaw {

/// Coefficients of a vertex per area of sheet, independent of the mesh. They must not all be 0.
struct SpringLaw {
  double mass = 1;       ///< kg/m^2
  double damping = 0;    ///< kg/(m^2 s)
  double stiffness = 0;  ///< N/m^3
};

/// Linear map q <- q + qv v + qr r, v <- vv v + vr r. r = f - K (q - q0) is the force per area at the
/// start of the step (N/m^2). With r in place of the rest position, K = 0 is no special case. Cancellation
/// occurs only where the motion reverses.
struct ExactStep {
  double qv = 0;  ///< s, impulse response of the free vertex
  double vv = 1;  ///< 1, derivative of qv
  double qr = 0;  ///< m^3/N, response to a constant force per area
  double vr = 0;  ///< m^3/(N s), derivative of qr = qv / m
};

/// Returns the map for a step of dt >= 0 (s). Each coefficient is accurate to 1e-13 of its scale. It is also
/// accurate to 1e-13 of its own value unless it crosses 0 in an oscillation. With long double, phases are
/// exact up to about 1e5 oscillations per step. Throws std::invalid_argument if a coefficient is negative or
/// all are 0.
ExactStep exactStep(const SpringLaw& law, double dt);

/// Weights of a position-dependent force before and after the step. The velocity gets before * f(before) +
/// after * f(after), and the position uses f(before). before + after = vr, so constant forces remain exact.
/// The map keeps its determinant, so it is stable up to a limit. For c = K = 0, it is leap-frog with its
/// limit (both weights are dt / 2m).
struct SplitForce {
  double before = 0, after = 0;
};
SplitForce splitForce(const SpringLaw& law, const ExactStep& step, double dt);

/// Returns the largest slope kappa (N/m^3) of forces f = -kappa z per area for which a step of dt is stable.
/// It follows from the eigenvalues of the map.
double stableSlope(const SpringLaw& law, double dt);

/// Returns the longest stable step (s) for neighbour forces of slope kappa (N/m^3), rounded down slightly. It
/// is infinite without such forces.
double stableStep(const SpringLaw& law, double kappa);

}  // namespace thaw
