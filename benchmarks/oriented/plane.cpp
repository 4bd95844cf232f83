// SPDX-License-Identifier: Apache-2.0
// A plane at rest: energies, normals, spacing. Rest spacing of the full Lennard-Jones sum.
#include <algorithm>
#include <cmath>

#include "benchmarks/oriented/tests.hpp"

namespace thaw::bench {

using test::Simulation;

/// Energy per particle of one of the potentials, over stiffness spacing^2.
double energyOf(const Simulation& x, double PairPotential::*weight) {
  const Oriented& o = x.w.oriented.rows;
  PairPotential p = x.tools.oriented.potentials[0];
  const double w = p.*weight;
  p.attract = p.plane = p.normal = p.circle = 0;
  p.*weight = w;
  const OrientedLists& l = x.tools.oriented.lists;
  double sum = 0;
  for (std::size_t i = 0; i < o.owned; i++)
    for (std::uint32_t k = l.first[i]; k < l.first[i + 1]; k++)
      sum += 0.5 *
             pairForces(p, o.position[l.list[k]] - o.position[i], o.normal[i], o.normal[l.list[k]]).energy;
  return sum / (p.scale * static_cast<double>(o.owned));
}

namespace {

double nearestApart(const Simulation& x, std::size_t i) {
  const Oriented& o = x.w.oriented.rows;
  const OrientedLists& l = x.tools.oriented.lists;
  double least = 1e300;
  for (std::uint32_t k = l.first[i]; k < l.first[i + 1]; k++)
    least = std::min(least, length(o.position[l.list[k]] - o.position[i]));
  return least;
}

}  // namespace

void plane(Figures& figures) {
  Scene s = defaultBody(0.02);
  OrientedBody& b = s.oriented[0];
  b.source = OrientedSource::Patch;
  b.width = b.depth = 0.6;
  b.jitter = 0.2;
  b.relax = 100000;
  Simulation x(s);
  const Oriented& o = x.w.oriented.rows;
  const double n = static_cast<double>(o.owned);
  figures.row("plane", "co-planarity energy", n, energyOf(x, &PairPotential::plane), 1e-10);
  figures.row("plane", "co-normality energy", n, energyOf(x, &PairPotential::normal), 1e-10);
  figures.row("plane", "co-circularity energy", n, energyOf(x, &PairPotential::circle), 1e-10);
  figures.row("plane", "iterations of relaxation", n, static_cast<double>(x.tools.oriented.relaxed), 0);
  std::vector<double> apart;
  Vec3d mean{};
  for (std::size_t i = 0; i < o.owned; i++) mean += o.normal[i];
  mean = normalized(mean);
  double tilt = 0;
  for (std::size_t i = 0; i < o.owned; i++) {
    tilt = std::max(tilt, length(o.normal[i] - mean));
    if (std::abs(o.position[i].x) < 0.2 && std::abs(o.position[i].y) < 0.2)
      apart.push_back(nearestApart(x, i) / s.spacing);
  }
  std::sort(apart.begin(), apart.end());
  figures.row("plane", "largest angle of a normal (rad)", n, tilt, 1e-5);
  figures.row("plane", "|median distance of neighbours / spacing - 1|", n,
              std::abs(apart[apart.size() / 2] - 1), 0.02);
}

void lattice(Figures& figures) {
  OrientedBody body;
  body.support = 60;
  const PairPotential p = pairPotential(body, 1);
  figures.row("lattice", "full sum: |spacing / sigma - 1.11146|", 0,
              std::abs(std::pow(2.0, 1.0 / 6) / p.well - 1.11146), 1e-5);
}

}  // namespace thaw::bench
