// A head rebuilt from 5 % of the points of its mesh: how far the surfaces are from each other.
#include <cmath>

#include "benchmarks/oriented/tests.hpp"
#include "core/geometry/point_tree.hpp"
#include "core/oriented/made_points.hpp"
#include "core/oriented/triangulate.hpp"

namespace thaw::bench {

using test::Simulation;

void rebuilt(Figures& figures, double spacing) {
  Scene s = bare(spacing);
  OrientedBody& b = s.oriented[0];
  b.shape.kind = ShapeKind::Mesh;
  b.shape.mesh = "builtin:head";
  b.thin = 0.05;
  b.growth = OrientedGrowth::Borders;
  b.crowd = 0.6;
  b.attract = 0.1;
  b.circle = 1.5;
  b.relax = 400;
  const auto start = std::chrono::steady_clock::now();
  Simulation x(s);
  const double time = seconds(start);
  const Oriented& o = x.w.oriented.rows;
  const double n = static_cast<double>(o.owned);
  const auto original = makeSignedDistance(b.shape);
  double most = 0, mean = 0, far = 0, farMean = 0;
  std::vector<Vec3d> places;
  for (std::size_t i = 0; i < o.owned; i++) {
    const double d = std::abs(original->distance(o.position[i])) / s.spacing;
    most = std::max(most, d);
    mean += d / n;
    places.push_back(o.position[i]);
  }
  // and from the original to the rebuilt: to the nearest particle, less what a hexagonal lattice has anyway (a spacing over root 3)
  const PointTree tree(places);
  const MadePoints all = sampleMesh(b.shape, 0.5 * s.spacing, 7, {});
  for (const Vec3d& p : all.places) {
    const double d = std::max(0.0, length(places[tree.nearest(p, 1)[0]] - p) / s.spacing - 1 / std::sqrt(3.0));
    far = std::max(far, d);
    farMean += d / static_cast<double>(all.places.size());
  }
  std::vector<Vec3d> normals;
  for (std::size_t i = 0; i < o.owned; i++) normals.push_back(o.normal[i]);
  const std::vector<double> spacings(places.size(), s.spacing);
  const auto triangles = triangulate({places, normals, spacings, {}, {}});
  figures.row("rebuilt", "points that were given", n, static_cast<double>(x.tools.oriented.given[0].points.size()), 0);
  figures.row("rebuilt", "largest distance from the original, spacings", n, most, 1);
  figures.row("rebuilt", "mean distance from the original, spacings", n, mean, 0.2);
  figures.row("rebuilt", "largest distance of the original, spacings", n, far, 1);
  figures.row("rebuilt", "mean distance of the original, spacings", n, farMean, 0.2);
  figures.row("rebuilt", "edges without two triangles, share", n, 2 * std::abs(1.5 * static_cast<double>(triangles.size()) - static_cast<double>(edgesOf(triangles).size())) / static_cast<double>(edgesOf(triangles).size()), 0);
  figures.row("rebuilt", "time (s)", n, time, 0);
}

}  // namespace thaw::bench
