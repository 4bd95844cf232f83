// The exact solution of m q'' + c q' + K (q - q0) = f over a step in which f is constant (DS section 2): one
// linear map for all vertices of a material, with full accuracy through the double root and for c = 0, K = 0
// and m to 0.
#pragma once

namespace thaw {

/// What a vertex is made of, per area of sheet, so that it does not depend on the mesh. Not all may be 0.
struct SpringLaw {
  double mass = 1;       ///< kg/m^2
  double damping = 0;    ///< kg/(m^2 s)
  double stiffness = 0;  ///< N/m^3
};

/// q <- q + hold v + yield r, v <- keep v + push r with r = f - K (q - q0), the force per area that the
/// vertex feels as the step begins (N/m^2). Written with r and not with the place of rest, so that K = 0 is
/// nothing special. Nothing cancels but where the motion itself turns round.
struct ExactStep {
  double hold = 0;   ///< s, impulse response of the free vertex
  double keep = 1;   ///< 1, its derivative
  double yield = 0;  ///< m^3/N, response to a constant force per area
  double push = 0;   ///< m^3/(N s), its derivative = hold / m
};

/// For a step of dt >= 0 s. Each number to 1e-13 of its scale; of itself, but for the ones that pass through
/// 0 while the vertex swings. Computed in long double: phases are right up to about 1e5 swings a step. Throws
/// std::invalid_argument for negative or no coefficients.
ExactStep exactStep(const SpringLaw& law, double dt);

/// A force that depends on places is not constant: it is taken before the step (for the place, and first for
/// the velocity) and after it. v gets before * f(before) + after * f(after); before + after = push, so that a
/// constant force is still exact; and the map keeps its determinant, so that the step is stable up to a
/// limit, that of leap-frog where c = K = 0 (then both are dt / 2m).
struct SplitPush {
  double before = 0, after = 0;
};
SplitPush splitPush(const SpringLaw& law, const ExactStep& step, double dt);

/// The largest slope kappa (N/m^3) of forces f = -kappa z, per area, with which a step of dt is stable. Of
/// the eigenvalues of the map.
double stableSlope(const SpringLaw& law, double dt);

/// The longest step (s) that is stable with neighbour forces of slope kappa (N/m^3): infinite without any. A
/// little less than exact.
double stableStep(const SpringLaw& law, double kappa);

}  // namespace thaw
