// SPDX-License-Identifier: Apache-2.0
// A head rebuilt from 5 % of the points of its mesh: distances between the two surfaces.
#include <cmath>
#include <string>

#include "benchmarks/oriented/tests.hpp"
#include "core/geometry/trees/point_tree.hpp"
#include "core/oriented/mesh/triangulate.hpp"
#include "core/oriented/sampling/sample_points.hpp"

namespace thaw::bench {

using test::Simulation;

namespace {

/// Distances between the particles and the mesh in both directions, in spacings.
void measure(Figures& figures, const Simulation& x, const char* when) {
  const Scene& s = x.w.scene;
  const Oriented& o = x.w.oriented.rows;
  const Shape& shape = s.oriented[0].shape;
  const double n = static_cast<double>(o.owned);
  const auto original = makeSignedDistance(shape);
  double most = 0, mean = 0, far = 0, farMean = 0;
  std::vector<Vec3d> places, normals;
  for (std::size_t i = 0; i < o.owned; i++) {
    const double d = std::abs(original->distance(o.position[i])) / s.spacing;
    most = std::max(most, d);
    mean += d / n;
    places.push_back(o.position[i]);
    normals.push_back(o.normal[i]);
  }
  // From the original to the nearest particle, minus the largest distance in a hexagonal lattice (a spacing
  // over root 3).
  const PointTree tree(places);
  const SampledPoints all = sampleMesh(shape, 0.5 * s.spacing, 7, {});
  for (const Vec3d& p : all.places) {
    const double d = std::max(0.0,
                              length(places[tree.nearest(p, 1)[0]] - p) / s.spacing - 1 / std::sqrt(3.0));
    far = std::max(far, d);
    farMean += d / static_cast<double>(all.places.size());
  }
  const std::vector<double> spacings(places.size(), s.spacing);
  const auto triangles = triangulate({places, normals, spacings, {}, {}});
  const auto row = [&](const char* name, double value, double target) {
    figures.row("rebuilt", (std::string(name) + ", " + when).c_str(), n, value, target);
  };
  row("largest distance from the original, spacings", most, 1);
  row("mean distance from the original, spacings", mean, 0.2);
  row("largest distance of the original, spacings", far, 1);
  row("mean distance of the original, spacings", farMean, 0.2);
  row("edges without two triangles, share",
      2 *
          std::abs(1.5 * static_cast<double>(triangles.size()) -
                   static_cast<double>(edgesOf(triangles).size())) /
          static_cast<double>(edgesOf(triangles).size()),
      0);
}

}  // namespace

/// The scene of scenes/oriented/interpolate.toml: relaxed, then run to its end with potentials and damping
/// only.
void rebuilt(Figures& figures, double spacing) {
  Scene s = defaultBody(spacing);
  OrientedBody& b = s.oriented[0];
  b.shape.kind = ShapeKind::Mesh;
  b.shape.mesh = "builtin:head";
  b.thin = 0.05;
  b.growth = OrientedGrowth::Borders;
  b.removalDistance = 0.6;
  b.attract = 0.1;
  b.circle = 1.5;
  b.relax = 400;
  b.density = 20;
  b.inertia = 1;
  b.cfl = 0.5;
  b.damping = b.spinDamping = 60;
  s.end = 0.02;
  const auto start = std::chrono::steady_clock::now();
  Simulation x(s);
  const double n = static_cast<double>(x.w.oriented.rows.owned), relaxed = seconds(start);
  figures.row("rebuilt", "given points", n, static_cast<double>(x.tools.oriented.given[0].points.size()), 0);
  measure(figures, x, "relaxed");
  const auto begin = std::chrono::steady_clock::now();
  if (!x.run()) std::printf("rebuilt: the run failed before its end\n");
  figures.row("rebuilt", "time to relax (s)", n, relaxed, 0);
  figures.row("rebuilt", "time of the run (s)", n, seconds(begin), 0);
  measure(figures, x, "at the end");
}

}  // namespace thaw::bench
