#include "core/surface/displace.hpp"

#include <array>

#include "core/solid/moment.hpp"
#include "core/surface/place_rows.hpp"
#include "core/surface/update_surface.hpp"

namespace thaw {
namespace {

double weight(double r2, double h2) {
  const double u = 1 - r2 / h2;
  return u * u * u;
}

/// Displacement and its gradient at a surfel.
struct Carry { Vec3d move{}; Mat3d gradient{}; double weight = 0, liquid = 0, temperature = 0; };

/// What a particle adds to the sums at a surfel x, times its weight: with u + G (x - x_j) = (u - G x_j) + G x the sums are the same for all x.
struct CarryPoint {
  Vec3d at;                 ///< m
  std::uint64_t component;
  std::array<double, 14> sum;  ///< u - G (x_j - origin), G, liquid fraction, temperature
};

/// In the order of the bins. origin: of the bins, which is the same on all ranks.
std::vector<CarryPoint> carryPoints(const SurfaceParticles& p, const Bins& bins) {
  std::vector<CarryPoint> points(bins.row.size());
  for (std::size_t k = 0; k < points.size(); k++) {
    const std::uint32_t j = bins.row[k];
    const Mat3d& g = p.gradient[j];
    const Vec3d c = p.displacement[j] - g * (bins.at[k] - bins.base);
    points[k] = {bins.at[k], p.component[j], {c.x, c.y, c.z, g.row[0].x, g.row[0].y, g.row[0].z, g.row[1].x, g.row[1].y, g.row[1].z, g.row[2].x, g.row[2].y, g.row[2].z,
                 p.liquid.active ? static_cast<double>(p.liquid[j]) : 0, p.temperature.active ? static_cast<double>(p.temperature[j]) : 0}};
  }
  return points;
}

Carry carryAt(const std::vector<CarryPoint>& points, const Bins& bins, const Vec3d& x, std::uint64_t component, double h) {
  Carry c;
  std::array<double, 14> sum{};
  const double perH2 = 1 / (h * h);
  forBinRunsAround(bins, x, x, h, [&](std::size_t from, std::size_t to) {
    for (std::uint32_t k = bins.first[from]; k < bins.first[to]; k++) {
      const CarryPoint& p = points[k];
      const Vec3d d = x - p.at;
      const double u = 1 - dot(d, d) * perH2;
      if (!(u > 0) || p.component != component) continue;
      const double w = u * u * u;
      c.weight += w;
      for (std::size_t a = 0; a < sum.size(); a++) sum[a] += w * p.sum[a];
    }
  });
  if (!(c.weight > 0)) return c;
  for (double& s : sum) s /= c.weight;
  c.gradient = {{{sum[3], sum[4], sum[5]}, {sum[6], sum[7], sum[8]}, {sum[9], sum[10], sum[11]}}};
  c.move = Vec3d{sum[0], sum[1], sum[2]} + c.gradient * (x - bins.base);
  c.liquid = sum[12];
  c.temperature = sum[13];
  return c;
}

/// Magnitude of Green's strain, 1: none where a body turns.
double strainOf(const Mat3d& g) {
  double sum = 0;
  for (int a = 0; a < 3; a++)
    for (int b = 0; b < 3; b++) {
      double e = g.row[a][b] + g.row[b][a];
      for (int k = 0; k < 3; k++) e += g.row[k][a] * g.row[k][b];
      sum += 0.25 * e * e;
    }
  return std::sqrt(sum);
}

/// Turns the tangents with the gradient of the displacement; false where they become one line: the frame is kept.
bool turnFrame(const Mat3d& gradient, Vec3d& normal, Vec3d& tangent) {
  const Vec3d second = cross(normal, tangent);
  const Vec3d a = tangent + gradient * tangent, b = second + gradient * second;
  const Vec3d n = cross(a, b);
  const double size = length(n), sides = length(a) * length(b);
  if (!(size > 1e-6 * sides)) return false;
  normal = n / size;
  tangent = normalized(a - dot(a, normal) * normal);
  return true;
}

/// Surfels without particles around follow those surfels that have some. Returns the rows that have neither.
std::vector<std::uint32_t> followNeighbours(World& w, SurfaceHalos halos, SurfaceTools& t) {
  Surfels& s = w.surface.surfels;
  ColumnList columns{&s.id, &s.position, &s.component, &s.carried, &s.moving};
  addGhosts(halos.surfels, s, w.surface.surfelCells, columns);
  const double h = w.surface.surfelSupport, h2 = h * h;
  fillBins(w.surface.grid, w.surface.surfelCells, s.position.data(), h, t.relax.surfelBins);
  std::vector<std::uint32_t> lost;
  for (std::uint32_t i = 0; i < s.owned; i++) {
    if (!s.moving[i]) continue;
    Vec3d sum{};
    double weights = 0;
    forRowsAround(t.relax.surfelBins, s.position[i], s.position[i], h, [&](std::uint32_t j, const Vec3d&) {
      const Vec3d d = s.position[i] - s.position[j];
      const double r2 = dot(d, d);
      if (s.moving[j] || r2 >= h2 || s.component[j] != s.component[i]) return;
      weights += weight(r2, h2);
      sum += weight(r2, h2) * s.carried[j];
    });
    if (weights > 0) s.carried[i] = sum / weights;
    else lost.push_back(i);
  }
  s.resize(s.owned, 0);
  return lost;
}

}  // namespace

void findDisplacementGradients(World& w, SurfaceHalos halos, SurfaceTools& t) {
  SurfaceParticles& p = w.surface.particles;
  ColumnList columns{&p.id, &p.position, &p.displacement, &p.component};
  if (p.liquid.active) columns.push_back(&p.liquid);
  if (p.temperature.active) columns.push_back(&p.temperature);
  addGhosts(halos.particles, p, w.surface.particleCells, columns);
  const double h = w.grid.support, h2 = h * h;
  fillBins(w.surface.grid, w.surface.particleCells, p.position.data(), 0.5 * h, t.relax.particleBins);
  for (std::size_t i = 0; i < p.owned; i++) {
    p.gradient[i] = {};
    if (p.component[i] == noComponent) continue;
    Sym3d moment;
    Mat3d sum{};
    forRowsAround(t.relax.particleBins, p.position[i], p.position[i], h, [&](std::uint32_t j, const Vec3d& at) {
      const Vec3d d = at - p.position[i];
      const double r2 = dot(d, d);
      if (r2 >= h2 || p.component[j] != p.component[i] || r2 == 0) return;
      const double v = weight(r2, h2);
      moment = moment + v * Sym3d{d.x * d.x, d.y * d.y, d.z * d.z, d.x * d.y, d.y * d.z, d.x * d.z};
      sum = sum + outer(v * (p.displacement[j] - p.displacement[i]), d);
    });
    const MomentInverse inverse = invertMoment(moment);
    p.gradient[i] = completeGradient(sum * full(inverse.inverse), inverse.inverse, inverse.rank);
  }
  ColumnList found{&p.gradient};
  refreshGhosts(halos.particles, p, found);
}

void displaceSurfels(World& w, SurfaceHalos halos, SurfaceTools& t) {
  Surfels& s = w.surface.surfels;
  const SurfaceParticles& p = w.surface.particles;
  SurfaceCounters& count = w.surface.counters;
  const bool blend = s.liquid.active;
  s.resize(s.owned, 0);
  s.activate(s.moving);   // here: no particles around
  s.activate(s.carried);  // here: how far
  fillBins(w.surface.grid, w.surface.particleCells, p.position.data(), 0.5 * w.surface.particleSupport, t.relax.particleBins);
  const std::vector<CarryPoint> points = carryPoints(p, t.relax.particleBins);
  std::int64_t told[2]{0, 0};  // without particles, frames kept
  for (std::size_t i = 0; i < s.owned; i++) {
    const Carry c = carryAt(points, t.relax.particleBins, s.position[i], s.component[i], w.surface.particleSupport);
    s.moving[i] = !(c.weight > 0);
    s.carried[i] = c.move;
    if (s.moving[i]) {
      told[0]++;
      s.calm[i] = 0;
      continue;
    }
    if (!turnFrame(c.gradient, s.normal[i], s.tangent[i])) told[1]++;
    s.calm[i] = std::max(0.0f, s.calm[i] - static_cast<float>(strainOf(c.gradient)));
    if (s.liquid.active) s.liquid[i] = static_cast<float>(c.liquid);
    if (s.temperature.active) s.temperature[i] = static_cast<float>(c.temperature);
  }
  halos.all.sum(told);
  count.keptNormals += told[1];
  std::vector<std::uint32_t> lost;
  if (told[0] > 0) lost = followNeighbours(w, halos, t);
  for (std::size_t i = 0; i < s.owned; i++) s.position[i] += s.carried[i];
  if (told[0] > 0) {
    std::int64_t gone[1]{static_cast<std::int64_t>(lost.size())};
    halos.all.sum(gone);
    count.lost += gone[0];
    std::vector<std::uint32_t> kept;
    auto at = lost.begin();
    for (std::uint32_t i = 0; i < s.owned; i++)
      if (at != lost.end() && *at == i) ++at;
      else kept.push_back(i);
    if (!lost.empty()) s.reorder(kept);
  }
  deactivate(s.moving);
  if (!blend) return deactivate(s.carried);
  s.activate(s.carriedNormal);
  for (std::size_t i = 0; i < s.owned; i++) s.carried[i] = s.position[i], s.carriedNormal[i] = s.normal[i];
}

}  // namespace thaw
