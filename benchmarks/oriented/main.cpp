// oriented [--csv FILE] [--strict]: accuracy of oriented bodies at rest, of a rebuilt mesh, and the two ways of finding neighbours.
//   plane, sphere   energies of co-planarity, co-normality and co-circularity a particle at rest, over stiffness spacing^2; spacing; radius; curvature
//   lattice         rest spacing of Lennard-Jones 12-6 with the full sum, over sigma
//   rebuilt         a head: points sampled from its mesh, thinned to 5 % and grown again: distance from the original, in spacings, largest and mean
//   neighbours      ms for the lists of all particles, by the cells and by nanoflann (tree and searches), for several numbers of particles
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "core/geometry/point_tree.hpp"
#include "core/kinds/place_kinds.hpp"
#include "core/oriented/made_points.hpp"
#include "core/oriented/oriented_forces.hpp"
#include "core/oriented/triangulate.hpp"
#include "tests/support/simulation.hpp"

namespace {

using namespace thaw;
using test::Simulation;

int missed = 0;
FILE* out = nullptr;

/// One figure; target 0: none, else it must not be above it.
void row(const char* name, const char* figure, double particles, double value, double target) {
  const bool bad = target > 0 && !(value <= target);
  missed += bad;
  if (target > 0) std::fprintf(out, "\"%s: %s\",%.0f,%.6g,%.3g\n", name, figure, particles, value, target);
  else std::fprintf(out, "\"%s: %s\",%.0f,%.6g,\n", name, figure, particles, value);
  std::printf("%-12s %-76s %8.0f particles  %12.6g%s\n", name, figure, particles, value, target > 0 ? (bad ? "  MISSED" : "  ok") : "");
  std::fflush(stdout);
}

Scene bare(double spacing) {
  Scene s;
  s.spacing = spacing;
  s.domain.min = {-1.5, -1.5, -1.5};
  s.domain.max = {1.5, 1.5, 1.5};
  s.domain.gravity = {};
  s.output.every = 0;
  s.oriented.emplace_back();
  s.oriented[0].name = "body";
  s.oriented[0].damping = s.oriented[0].spinDamping = 5;
  return s;
}

/// Energy of one of the potentials a particle, over scale.
double energyOf(const Simulation& x, double PairPotential::* weight) {
  const Oriented& o = x.w.oriented.rows;
  PairPotential p = x.tools.oriented.potentials[0];
  const double w = p.*weight;
  p.attract = p.plane = p.normal = p.circle = 0;
  p.*weight = w;
  const OrientedLists& l = x.tools.oriented.lists;
  double sum = 0;
  for (std::size_t i = 0; i < o.owned; i++)
    for (std::uint32_t k = l.first[i]; k < l.first[i + 1]; k++) sum += 0.5 * pairForces(p, o.position[l.list[k]] - o.position[i], o.normal[i], o.normal[l.list[k]]).energy;
  return sum / (p.scale * static_cast<double>(o.owned));
}

double nearestApart(const Simulation& x, std::size_t i) {
  const Oriented& o = x.w.oriented.rows;
  const OrientedLists& l = x.tools.oriented.lists;
  double least = 1e300;
  for (std::uint32_t k = l.first[i]; k < l.first[i + 1]; k++) least = std::min(least, length(o.position[l.list[k]] - o.position[i]));
  return least;
}

void plane() {
  Scene s = bare(0.02);
  OrientedBody& b = s.oriented[0];
  b.source = OrientedSource::Patch;
  b.width = b.depth = 0.6;
  b.jitter = 0.2;
  b.relax = 100000;
  Simulation x(s);
  const Oriented& o = x.w.oriented.rows;
  const double n = static_cast<double>(o.owned);
  row("plane", "co-planarity energy", n, energyOf(x, &PairPotential::plane), 1e-10);
  row("plane", "co-normality energy", n, energyOf(x, &PairPotential::normal), 1e-10);
  row("plane", "co-circularity energy", n, energyOf(x, &PairPotential::circle), 1e-10);
  row("plane", "iterations of relaxation", n, static_cast<double>(x.tools.oriented.relaxed), 0);
  std::vector<double> apart;
  Vec3d mean{};
  for (std::size_t i = 0; i < o.owned; i++) mean += o.normal[i];
  mean = normalized(mean);
  double tilt = 0;
  for (std::size_t i = 0; i < o.owned; i++) {
    tilt = std::max(tilt, length(o.normal[i] - mean));
    if (std::abs(o.position[i].x) < 0.2 && std::abs(o.position[i].y) < 0.2) apart.push_back(nearestApart(x, i) / s.spacing);
  }
  std::sort(apart.begin(), apart.end());
  row("plane", "largest angle of a normal (rad)", n, tilt, 1e-5);
  row("plane", "|median distance of neighbours / spacing - 1|", n, std::abs(apart[apart.size() / 2] - 1), 0.02);
}

void lattice() {
  OrientedBody body;
  body.support = 60;
  const PairPotential p = pairPotential(body, 1);
  row("lattice", "full sum: |spacing / sigma - 1.11146|", 0, std::abs(std::pow(2.0, 1.0 / 6) / p.well - 1.11146), 1e-5);
}

void sphere() {
  const double R = 0.25;
  {  // at its place, normals outward: exactly without energy
    Scene s = bare(0.02);
    s.oriented[0].shape.kind = ShapeKind::Sphere;
    s.oriented[0].shape.radius = R;
    Simulation x(s);
    row("sphere", "co-circularity energy, radial normals", static_cast<double>(x.w.oriented.rows.owned), energyOf(x, &PairPotential::circle), 1e-10);
  }
  {  // 12 particles: an icosahedron, where all forces of Lennard-Jones are along the sphere or cancel
    Scene s = bare(0.3);
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
    row("sphere", "co-circularity energy, 12 at rest", 12, energyOf(x, &PairPotential::circle), 1e-10);
  }
  // co-circularity alone, from places and normals that are off; and with Lennard-Jones, which has tension around the defects of its lattice: the less of it
  // the less energy is left, in proportion (docs/oriented.md says why it cannot be 0)
  for (const double attract : {0.0, 0.01, 0.1}) {
    Scene s = bare(0.03);
    OrientedBody& b = s.oriented[0];
    b.shape.kind = ShapeKind::Sphere;
    b.shape.radius = R;
    b.attract = attract;
    b.plane = b.normal = 0;
    b.jitter = 0.03;
    b.relax = 20000;
    Simulation x(s);
    const double n = static_cast<double>(x.w.oriented.rows.owned);
    const std::string with = attract > 0 ? ", Lennard-Jones of weight " + std::to_string(attract).substr(0, 4) : " alone, off at the start";
    row("sphere", ("co-circularity energy at rest" + with).c_str(), n, energyOf(x, &PairPotential::circle), attract > 0 ? 0 : 1e-10);
    row("sphere", ("largest force left, over stiffness spacing" + with).c_str(), n, x.tools.oriented.unrest, 1e-9);
  }
  Scene s = bare(0.02);
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
  Simulation x(s);  // as scenes/oriented/relax_sphere.toml
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
  // curvature from neighbours: (n_j - n_i).r / r^2 of those within 1.7 spacings
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
  row("sphere", "co-circularity energy after 1 s (relax_sphere)", n, energyOf(x, &PairPotential::circle), 0);
  row("sphere", "radius over that at the start", n, radius / R, 0);
  row("sphere", "radius, rms deviation over its mean", n, std::sqrt(spread), 0.005);
  row("sphere", "curvature, rms error", n, std::sqrt(curvature), 0.05);
  row("sphere", "largest angle of a normal (rad)", n, turn, 0.1);
}

double seconds(const std::chrono::steady_clock::time_point& since) { return std::chrono::duration<double>(std::chrono::steady_clock::now() - since).count(); }

void rebuilt(double spacing) {
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
  row("rebuilt", "points that were given", n, static_cast<double>(x.tools.oriented.given[0].points.size()), 0);
  row("rebuilt", "largest distance from the original, spacings", n, most, 1);
  row("rebuilt", "mean distance from the original, spacings", n, mean, 0.2);
  row("rebuilt", "largest distance of the original, spacings", n, far, 1);
  row("rebuilt", "mean distance of the original, spacings", n, farMean, 0.2);
  row("rebuilt", "edges without two triangles, share", n, 2 * std::abs(1.5 * static_cast<double>(triangles.size()) - static_cast<double>(edgesOf(triangles).size())) / static_cast<double>(edgesOf(triangles).size()), 0);
  row("rebuilt", "time (s)", n, time, 0);
}

void neighbours() {
  for (const double spacing : {0.04, 0.015, 0.0085}) {
    Scene s = bare(spacing);
    s.oriented[0].shape.kind = ShapeKind::Sphere;
    s.oriented[0].shape.radius = 0.5;
    Simulation x(s);
    const Oriented& o = x.w.oriented.rows;
    const double n = static_cast<double>(o.owned), reach = 1.1 * s.oriented[0].support * spacing;
    double byCells = 1e300, byTree = 1e300, bySort = 1e300;
    std::size_t found = 0;
    for (int repeat = 0; repeat < 5; repeat++) {
      auto start = std::chrono::steady_clock::now();
      bringKindsHome(x.w, x.halos(), x.tools);
      bySort = std::min(bySort, seconds(start));
      start = std::chrono::steady_clock::now();
      readyOriented(x.w, x.halos(), x.tools);
      byCells = std::min(byCells, seconds(start));
      std::vector<Vec3d> places(o.position.data(), o.position.data() + o.owned);
      start = std::chrono::steady_clock::now();
      const PointTree tree(places);
      found = 0;
      for (std::size_t i = 0; i < o.owned; i++) found += tree.within(places[i], reach).size() - 1;
      byTree = std::min(byTree, seconds(start));
    }
    if (found != x.tools.oriented.lists.list.size()) std::printf("the two searches find different neighbours\n"), missed++;
    row("neighbours", "by the cells, sorted anew (ms)", n, 1e3 * (byCells + bySort), 0);
    row("neighbours", "by nanoflann (ms)", n, 1e3 * byTree, 0);
    row("neighbours", "cells over nanoflann", n, (byCells + bySort) / byTree, 1);
  }
}

}  // namespace

int main(int argc, char** argv) {
  const char* csv = nullptr;
  bool strict = false;
  std::string only;
  double spacing = 0.0125;  // m, of the surface that is rebuilt
  for (int a = 1; a < argc; a++) {
    const std::string key = argv[a];
    if (key == "--strict") strict = true;
    else if (key == "--csv" && a + 1 < argc) csv = argv[++a];
    else if (key == "--only" && a + 1 < argc) only = argv[++a];
    else if (key == "--spacing" && a + 1 < argc && std::atof(argv[a + 1]) > 0) spacing = std::atof(argv[++a]);
    else {
      const bool help = key == "--help" || key == "-h";
      return std::fprintf(help ? stdout : stderr, "scripts/bench oriented [--strict] [--only plane|lattice|sphere|rebuilt|neighbours] [--spacing METRES of rebuilt] [--csv FILE]\n"), help ? 0 : 2;
    }
  }
  out = csv ? std::fopen(csv, "w") : std::fopen("/dev/null", "w");
  if (!out) return std::fprintf(stderr, "%s: cannot be written\n", csv), 3;
  std::fprintf(out, "case,particles,value,target_value\n");
  const auto wanted = [&](const char* name) { return only.empty() || only == name; };
  if (wanted("lattice")) lattice();
  if (wanted("plane")) plane();
  if (wanted("sphere")) sphere();
  if (wanted("neighbours")) neighbours();
  if (wanted("rebuilt")) rebuilt(spacing);
  std::fclose(out);
  return strict && missed > 0 ? 1 : 0;
}
