// SPDX-License-Identifier: Apache-2.0
// Spheres: co-circularity at rest with and without Lennard-Jones, and the roundness of a scene's sphere after
// one second.
#include <algorithm>
#include <cmath>

#include "benchmarks/oriented/tests.hpp"

namespace thaw::bench {

using test::Simulation;

namespace {

constexpr double R = 0.25;  // m

/// Rest energies of spheres (docs/theory/oriented.md explains which of them vanish).
void spheresAtRest(Figures& figures) {
  {  // on the sphere with outward normals the energy is exactly zero
    Scene s = defaultBody(0.02);
    s.oriented[0].shape.kind = ShapeKind::Sphere;
    s.oriented[0].shape.radius = R;
    Simulation x(s);
    figures.row("sphere", "co-circularity energy, radial normals",
                static_cast<double>(x.w.oriented.rows.owned), energyOf(x, &PairPotential::circle), 1e-10);
  }
  {  // 12 particles: an icosahedron, where Lennard-Jones forces are tangential or cancel
    Scene s = defaultBody(0.3);
    OrientedBody& b = s.oriented[0];
    b.source = OrientedSource::Points;
    const double g = 0.5 * (1 + std::sqrt(5.0));
    for (const double a : {-1.0, 1.0})
      for (const double c : {-g, g})
        for (const Vec3d& v : {Vec3d{0, a, c}, Vec3d{a, c, 0}, Vec3d{c, 0, a}}) {
          b.points.push_back(0.16 * v);
          b.normals.push_back(v);
        }
    b.plane = b.normal = 0;
    b.support = 2.5;
    b.jitter = 0.03;
    b.relax = 100000;
    Simulation x(s);
    figures.row("sphere", "co-circularity energy, 12 at rest", 12, energyOf(x, &PairPotential::circle),
                1e-10);
  }
  // Co-circularity from displaced positions and normals, alone and with Lennard-Jones. Lennard-Jones leaves
  // tension around the defects of its lattice, in proportion to its weight (docs/theory/oriented.md).
  for (const double attract : {0.0, 0.01, 0.1}) {
    Scene s = defaultBody(0.03);
    OrientedBody& b = s.oriented[0];
    b.shape.kind = ShapeKind::Sphere;
    b.shape.radius = R;
    b.attract = attract;
    b.plane = b.normal = 0;
    b.jitter = 0.03;
    b.relax = 20000;
    Simulation x(s);
    const double n = static_cast<double>(x.w.oriented.rows.owned);
    const std::string with = attract > 0 ? ", Lennard-Jones of weight " + std::to_string(attract).substr(0, 4)
                                         : " alone, off at the start";
    figures.row("sphere", ("co-circularity energy at rest" + with).c_str(), n,
                energyOf(x, &PairPotential::circle), attract > 0 ? 0 : 1e-10);
    figures.row("sphere", ("largest force left, over stiffness spacing" + with).c_str(), n,
                x.tools.oriented.residualForce, 1e-9);
  }
}

/// The scene of scenes/oriented/relax_sphere.toml.
void relaxedSphere(Figures& figures) {
  Scene s = defaultBody(0.02);
  OrientedBody& b = s.oriented[0];
  b.shape.kind = ShapeKind::Sphere;
  b.shape.radius = R;
  b.attract = 0.03;
  b.plane = 0.2;
  b.normal = 0.1;
  b.circle = 4;
  b.jitter = 0.08;
  b.growth = OrientedGrowth::Gaps;
  b.gap = 1.75;
  b.density = 20;
  b.inertia = 1;
  b.cfl = 0.5;
  b.damping = b.spinDamping = 40;
  s.end = 1;
  Simulation x(s);
  x.run();
  const Oriented& o = x.w.oriented.rows;
  const double n = static_cast<double>(o.owned);
  Vec3d centre{};
  for (std::size_t i = 0; i < o.owned; i++) centre += o.position[i];
  centre = centre / n;
  double radius = 0, spread = 0, turn = 0;
  for (std::size_t i = 0; i < o.owned; i++) radius += length(o.position[i] - centre) / n;
  for (std::size_t i = 0; i < o.owned; i++) {
    spread += std::pow(length(o.position[i] - centre) / radius - 1, 2) / n;
    turn = std::max(turn, length(o.normal[i] - normalized(o.position[i] - centre)));
  }
  // curvature from neighbours within 1.7 spacings: (n_j - n_i).r / r^2
  double curvature = 0;
  for (std::size_t i = 0; i < o.owned; i++) {
    double bend = 0, weight = 0;
    for (std::uint32_t k = x.tools.oriented.lists.first[i]; k < x.tools.oriented.lists.first[i + 1]; k++) {
      const std::uint32_t j = x.tools.oriented.lists.list[k];
      const Vec3d r = o.position[j] - o.position[i];
      if (dot(r, r) > 2.89 * s.spacing * s.spacing) continue;
      bend += dot(o.normal[j] - o.normal[i], r);
      weight += dot(r, r);
    }
    curvature += std::pow(bend / weight * radius - 1, 2) / n;
  }
  figures.row("sphere", "co-circularity energy after 1 s (relax_sphere)", n,
              energyOf(x, &PairPotential::circle), 0);
  figures.row("sphere", "radius over that at the start", n, radius / R, 0);
  figures.row("sphere", "radius, rms deviation over its mean", n, std::sqrt(spread), 0.005);
  figures.row("sphere", "curvature, rms error", n, std::sqrt(curvature), 0.05);
  figures.row("sphere", "largest angle of a normal (rad)", n, turn, 0.1);
}

}  // namespace

void sphere(Figures& figures) {
  spheresAtRest(figures);
  relaxedSphere(figures);
}

}  // namespace thaw::bench
