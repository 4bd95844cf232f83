// SPDX-License-Identifier: Apache-2.0
#include "core/sheet/data/exact_step.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace thaw {
namespace {

__extension__ typedef __float128 Quad;

Quad size(Quad x) { return x < 0 ? -x : x; }

/// exp of the 3x3 matrix of (y, y', force) by its scaled and squared series, in quad precision: error 1e-30,
/// no special cases.
struct Reference {
  Quad qv, vv, qr, vr;
};
Reference reference(const SpringLaw& law, double dt) {
  const Quad m = law.mass, c = law.damping, k = law.stiffness;
  Quad a[3][3] = {{0, dt, 0}, {-k / m * dt, -c / m * dt, dt / m}, {0, 0, 0}};
  // in units that make the rows comparable
  Quad norm = 0;
  for (auto& row : a)
    for (const Quad x : row) norm = std::max(norm, size(x));
  int halvings = 0;
  while (norm > Quad(1) / 1024) {
    norm /= 2;
    halvings++;
  }
  Quad scale = 1;
  for (int i = 0; i < halvings; i++) scale /= 2;
  Quad e[3][3] = {}, term[3][3] = {};
  for (int i = 0; i < 3; i++) term[i][i] = 1;  // e holds exp - 1, so that squaring keeps small parts
  const auto times = [](Quad(&x)[3][3], Quad(&y)[3][3], Quad(&out)[3][3]) {
    for (int i = 0; i < 3; i++)
      for (int j = 0; j < 3; j++) {
        out[i][j] = 0;
        for (int l = 0; l < 3; l++) out[i][j] += x[i][l] * y[l][j];
      }
  };
  for (auto& row : a)
    for (Quad& x : row) x *= scale;
  for (int n = 1; n < 16; n++) {
    Quad next[3][3];
    times(term, a, next);
    for (int i = 0; i < 3; i++)
      for (int j = 0; j < 3; j++) {
        term[i][j] = next[i][j] / n;
        e[i][j] += term[i][j];
      }
  }
  for (int n = 0; n < halvings; n++) {
    Quad square[3][3];
    times(e, e, square);
    for (int i = 0; i < 3; i++)
      for (int j = 0; j < 3; j++) e[i][j] = 2 * e[i][j] + square[i][j];
  }
  return {e[0][1], 1 + e[1][1], e[0][2], e[1][2]};
}

/// Error relative to the value, or to the amplitude where the value oscillates through 0.
double error(double got, Quad expected, Quad amplitude) {
  return static_cast<double>(size(got - expected) / std::max(size(expected), amplitude));
}

TEST(ExactStep, AllRegimesToThirteenDigits) {
  std::vector<double> logs;
  for (double x = -8; x <= 3; x += 0.5) logs.push_back(std::pow(10, x));
  double worst = 0;
  for (const double mass : {1.0, 1e-6, 1e3})
    for (const double c : logs)
      for (const double w : logs)
        for (const double dt : {1.0, 1e-3, 17.0}) {
          const SpringLaw law{mass, c * mass / dt, w * w * mass / (dt * dt)};
          if (c > 60 && w > 60)
            continue;  // the motion ends within the step: the reference would need thousands of halvings
          const ExactStep x = exactStep(law, dt);
          const Reference r = reference(law, dt);
          const bool swings = c < 2 * w;
          const Quad decay = swings ? Quad(std::exp(-c / 2)) : Quad(0),
                     amplitude = swings && w > 1 ? decay : Quad(0);
          worst = std::max({worst, error(x.qv, r.qv, amplitude * dt / w),
                            error(x.vr, r.vr, amplitude * dt / (w * mass)),
                            error(x.vv, r.vv, std::max(amplitude, c > 0.5 ? size(r.qv) * c / dt : Quad(0))),
                            error(x.qr, r.qr, amplitude * dt * dt / (w * w * mass))});
          ASSERT_LT(worst, 1e-13) << "m " << mass << " c " << c << " w " << w << " dt " << dt;
        }
  RecordProperty("worst", std::to_string(worst));
}

TEST(ExactStep, IsContinuousThroughTheDoubleRoot) {
  double worst = 0;
  for (const double a : {0.01, 0.3, 0.999, 1.0, 1.5, 4.0, 20.0})
    for (const double beside : {0.0, 1e-16, -1e-16, 1e-12, -1e-12, 1e-8, -1e-8, 1e-4, -1e-4, 1e-2, -1e-2}) {
      const SpringLaw law{2.0, 4 * a, 2 * a * a * (1 + beside)};
      const ExactStep x = exactStep(law, 1);
      const Reference r = reference(law, 1);
      worst = std::max({worst, error(x.qv, r.qv, 0), error(x.vv, r.vv, size(r.qv) * a), error(x.qr, r.qr, 0),
                        error(x.vr, r.vr, 0)});
    }
  EXPECT_LT(worst, 1e-13);
}

TEST(ExactStep, HasTheKnownLimits) {
  const ExactStep ballistic = exactStep({2, 0, 0}, 3);
  EXPECT_DOUBLE_EQ(ballistic.qv, 3);
  EXPECT_DOUBLE_EQ(ballistic.vv, 1);
  EXPECT_DOUBLE_EQ(ballistic.qr, 9.0 / 4);
  EXPECT_DOUBLE_EQ(ballistic.vr, 1.5);
  const ExactStep creeping = exactStep({0, 5, 2}, 3);  // first order
  EXPECT_EQ(creeping.qv, 0);
  EXPECT_NEAR(creeping.qr, -std::expm1(-6.0 / 5) / 2, 1e-16);
  EXPECT_NEAR(creeping.vr, std::exp(-6.0 / 5) / 5, 1e-16);
  const ExactStep still = exactStep({0, 0, 4}, 0.1);
  EXPECT_EQ(still.qr, 0.25);
  EXPECT_EQ(still.vv, 0);
  for (const double m : {1e-8, 1e-12, 1e-16, 1e-30, 1e-300}) {
    const ExactStep x = exactStep({m, 5, 2}, 3), none = exactStep({0, 5, 2}, 3);
    EXPECT_NEAR(x.qr / none.qr, 1, 3 * m + 1e-15) << m;
    EXPECT_NEAR(x.vr / none.vr, 1, 3 * m + 1e-15) << m;
    EXPECT_NEAR(x.qv, m * none.vr, 1e-7 * m);
  }
  for (const double k : {1e-8, 1e-12, 1e-16, 1e-30, 1e-300}) {  // toward a drag without a spring
    const ExactStep x = exactStep({1, 3, k}, 3), none = exactStep({1, 3, 0}, 3);
    EXPECT_NEAR(x.qr / none.qr, 1, 3 * k + 1e-15);
    EXPECT_NEAR(x.vv / none.vv, 1, 1e4 * k + 1e-13);  // vv is e^-9
  }
  EXPECT_THROW(exactStep({0, 0, 0}, 1), std::invalid_argument);
  EXPECT_THROW(exactStep({1, -1, 0}, 1), std::invalid_argument);
}

TEST(ExactStep, TwoStepsEqualOneOfTwiceTheLength) {
  for (const SpringLaw law :
       {SpringLaw{1, 0, 0}, SpringLaw{1, 0, 40}, SpringLaw{1, 0.3, 40}, SpringLaw{1, 2, 1},
        SpringLaw{1, 30, 2}, SpringLaw{0, 3, 2}, SpringLaw{1e-9, 3, 2}, SpringLaw{2, 5, 0}})
    for (const double dt : {1e-4, 0.05, 0.7, 4.0}) {
      const double force = 1.7, start = 0.3;
      const auto advance = [&](const ExactStep& x, double& q, double& v) {
        const double r = force - law.stiffness * q, q0 = q;
        q = q0 + x.qv * v + x.qr * r;
        v = x.vv * v + x.vr * r;
      };
      double q = start, v = law.mass > 1e-6 ? -2 : 0, q2 = q, v2 = v;
      const ExactStep one = exactStep(law, dt), two = exactStep(law, 2 * dt);
      advance(one, q, v);
      advance(one, q, v);
      advance(two, q2, v2);
      const double swing = 2 + 2 * std::sqrt(law.stiffness / std::max(law.mass, 1.0)) * 2;
      EXPECT_NEAR(q, q2, 1e-14 * (std::abs(q2) + swing))
          << law.mass << " " << law.damping << " " << law.stiffness << " " << dt;
      EXPECT_NEAR(v, v2, 1e-14 * (std::abs(v2) + swing * 8));
    }
}

/// Largest growth per step of the map with a neighbour force of stiffness kappa.
double growth(const SpringLaw& law, double kappa, double dt) {
  const ExactStep x = exactStep(law, dt);
  const SplitForce s = splitForce(law, x, dt);
  const auto step = [&](double& z, double& v) {
    const double f0 = -kappa * z, z0 = z;
    z = z0 + x.qv * v + x.qr * (f0 - law.stiffness * z0);
    v = x.vv * v - x.vr * law.stiffness * z0 + s.before * f0 - s.after * kappa * z;
  };
  double a = 1, b = 0, c = 0, d = 1;
  step(a, b);
  step(c, d);
  const double trace = a + d, det = a * d - b * c, disc = trace * trace / 4 - det;
  return disc >= 0 ? std::abs(trace / 2) + std::sqrt(disc) : std::sqrt(det);
}

TEST(ExactStep, StableLimitIsTight) {
  for (const SpringLaw law : {SpringLaw{1, 0, 0}, SpringLaw{1, 0, 40}, SpringLaw{1, 3, 40},
                              SpringLaw{1, 30, 2}, SpringLaw{0, 3, 2}, SpringLaw{2, 5, 0}})
    for (const double kappa : {0.5, 10.0, 1e4}) {
      const double dt = stableStep(law, kappa);
      if (!(dt < 1e300)) continue;
      EXPECT_GT(dt, 0);
      for (const double part : {0.01, 0.3, 0.9, 0.999})
        EXPECT_LE(growth(law, kappa, part * dt), 1 + 1e-12)
            << law.damping << " " << law.stiffness << " " << kappa << " " << part;
      const double w = std::sqrt(law.stiffness / std::max(law.mass, 1e-300)),
                   a = law.damping / (2 * std::max(law.mass, 1e-300));
      const bool quarter = w > a && std::sqrt(w * w - a * a) * dt > 1.57;
      if (!quarter) {
        EXPECT_GT(growth(law, kappa, 1.01 * dt), 1 + 1e-6)
            << law.damping << " " << law.stiffness << " " << kappa;
      }
    }
  EXPECT_NEAR(stableStep({2, 0, 0}, 50), 2 / std::sqrt(50.0 / 2), 1e-9);  // the limit of leap-frog
  const SpringLaw law{1, 0, 0};
  const ExactStep x = exactStep(law, 0.1);
  EXPECT_DOUBLE_EQ(splitForce(law, x, 0.1).before, 0.05);
  EXPECT_DOUBLE_EQ(splitForce(law, x, 0.1).after, 0.05);
}

}  // namespace
}  // namespace thaw
