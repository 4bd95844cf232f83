// SPDX-License-Identifier: Apache-2.0
#include "core/surface/advection/displace.hpp"

#include <algorithm>
#include <array>

#include "core/solid/elasticity/moment.hpp"
#include "core/surface/advection/reference_motion.hpp"
#include "core/surface/data/place_rows.hpp"
#include "core/surface/work/surface_tools.hpp"

namespace thaw {
namespace {

double weight(double r2, double h2) {
  const double u = 1 - r2 / h2;
  return u * u * u;
}

/// Cutoff of the moment's smallest axis. Particles do not determine the displacement normal to a plane if
/// their heights above it are within a third of their distances. Otherwise, ripples of a single layer would
/// determine its thickness, and the two sides of a rotating plate would collapse.
constexpr double layerCutoff = 0.1;

/// Displacement (m) and its gradient at a surfel.
struct Carry {
  Vec3d move{};
  Mat3d gradient{};
  double weight = 0, moved = 0, liquid = 0, temperature = 0;
};

/// Packs the particles' contributions by row: u - G (x_j - origin), G, liquid fraction, temperature. Since u
/// + G (x - x_j) = (u - G x_j) + G x, these sums serve all x. origin: m, origin of the bins, the same on all
/// ranks.
void packParticles(const SurfaceParticles& p, const Vec3d& origin, AlignedVector<double>& records) {
  records.resize(carryRecord * p.size());
  for (std::size_t j = 0; j < p.size(); j++) {
    const Mat3d& g = p.gradient[j];
    const Vec3d x = p.position[j], c = p.displacement[j] - g * (x - origin);
    const std::array<double, carryRecord> r{x.x,
                                            x.y,
                                            x.z,
                                            p.liquid.active ? static_cast<double>(p.liquid[j]) : 1,
                                            c.x,
                                            c.y,
                                            c.z,
                                            g.row[0].x,
                                            g.row[0].y,
                                            g.row[0].z,
                                            g.row[1].x,
                                            g.row[1].y,
                                            g.row[1].z,
                                            g.row[2].x,
                                            g.row[2].y,
                                            g.row[2].z,
                                            p.liquid.active ? static_cast<double>(p.liquid[j]) : 0,
                                            p.temperature.active ? static_cast<double>(p.temperature[j]) : 0};
    std::copy(r.begin(), r.end(), &records[carryRecord * j]);
  }
}

/// Returns displacement, gradient and fields from the sums of one lane. fromOrigin: m, position relative to
/// the origin.
Carry carryOf(const double* sums, std::size_t lane, const Vec3d& fromOrigin) {
  Carry c;
  c.weight = sums[lane];
  if (!(c.weight > 0)) return c;
  std::array<double, carryValues> v;
  c.moved = sums[8 * (1 + carryValues) + lane];
  for (std::size_t k = 0; k < carryValues; k++)
    v[k] = sums[8 * (1 + k) + lane] / (k < carryMotion ? c.moved : c.weight);
  c.gradient = {{{v[3], v[4], v[5]}, {v[6], v[7], v[8]}, {v[9], v[10], v[11]}}};
  c.move = Vec3d{v[0], v[1], v[2]} + c.gradient * fromOrigin;
  c.liquid = v[12];
  c.temperature = v[13];
  return c;
}

/// Gradient of the interpolated displacement sum w (u + G (x - x_j)) / sum w. It is the mean of G plus the
/// term from the gradient of the weights. With K05's mean of G only, discs stand on edge in folds that bend
/// and open. Liquid surfels omit the term, because the iterations determine their normals.
struct Bend {
  CarrySums* in;
  const SurfaceKernels* kernels;
  alignas(32) std::array<double, 8 * 3> mean;
  alignas(32) std::array<double, 8 * bendSums> sums;
  void find(std::size_t g, const std::array<Carry, 8>& c) {
    for (std::size_t lane = 0; lane < 8; lane++)
      for (int a = 0; a < 3; a++) mean[8 * static_cast<std::size_t>(a) + lane] = c[lane].move[a];
    in->mean = mean.data();
    kernels->bend(*in, g, sums.data());
  }
  Mat3d added(std::size_t lane, double weight) const {
    Mat3d m;
    for (std::size_t a = 0; a < 3; a++)
      for (std::size_t b = 0; b < 3; b++)
        m.row[a][static_cast<int>(b)] = -6 * in->perSupport2 / weight * sums[8 * (3 * a + b) + lane];
    return m;
  }
};

/// Returns the magnitude of Green's strain (1), which vanishes for rotations.
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

/// Rotates the tangents by the displacement gradient. Returns false, without a change, if they become
/// collinear.
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

/// Moves surfels without particles with neighbouring surfels. Returns the rows without particles and without
/// such neighbours.
std::vector<std::uint32_t> followNeighbours(Surface& surface, SurfaceHalos halos, SurfaceTools& t) {
  Surfels& s = surface.surfels;
  ColumnList columns{&s.id, &s.position, &s.component, &s.carried, &s.moving};
  addGhosts(halos.surfels, s, surface.surfelCells, columns);
  const double h = surface.surfelSupport, h2 = h * h;
  fillBins(surface.grid, surface.surfelCells, s.position.data(), h, t.relax.surfelBins);
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

void findDisplacementGradients(const CellGrid& grid, Surface& surface, SurfaceHalos halos, SurfaceTools& t) {
  SurfaceParticles& p = surface.particles;
  ColumnList columns{&p.id, &p.position, &p.displacement, &p.component};
  if (p.liquid.active) columns.push_back(&p.liquid);
  if (p.temperature.active) columns.push_back(&p.temperature);
  if (p.referencePosition.active) columns.push_back(&p.referencePosition), columns.push_back(&p.covered);
  addGhosts(halos.particles, p, surface.particleCells, columns);
  const double h = grid.support, h2 = h * h;
  fillBins(surface.grid, surface.particleCells, p.position.data(), 0.5 * h, t.relax.particleBins);
  for (std::size_t i = 0; i < p.owned; i++) {
    p.gradient[i] = {};
    if (p.component[i] == noComponent) continue;
    Sym3d moment;
    Mat3d sum{};
    forRowsAround(
        t.relax.particleBins, p.position[i], p.position[i], h, [&](std::uint32_t j, const Vec3d& at) {
          const Vec3d d = at - p.position[i];
          const double r2 = dot(d, d);
          if (r2 >= h2 || p.component[j] != p.component[i] || r2 == 0) return;
          const double v = weight(r2, h2) *
                           (p.liquid.active
                                ? std::max(leastMotionWeight,
                                           1 - std::max(0.0, static_cast<double>(p.liquid[j]) -
                                                                 static_cast<double>(p.liquid[i])))
                                : 1);
          moment = moment + v * Sym3d{d.x * d.x, d.y * d.y, d.z * d.z, d.x * d.y, d.y * d.z, d.x * d.z};
          sum = sum + outer(v * (p.displacement[j] - p.displacement[i]), d);
        });
    const MomentInverse inverse = invertMoment(moment, layerCutoff);
    p.gradient[i] = completeGradient(sum * full(inverse.inverse), inverse.inverse, inverse.rank);
  }
  ColumnList found{&p.gradient};
  refreshGhosts(halos.particles, p, found);
}

namespace {

/// Lists the groups of surfels with their particles, and packs the particles.
void prepareSums(Surface& surface, RelaxTools& r) {
  const SurfaceParticles& p = surface.particles;
  const Surfels& s = surface.surfels;
  const double h = surface.particleSupport;
  fillBins(surface.grid, surface.particleCells, p.position.data(), 0.5 * h, r.particleBins);
  fillBins(surface.grid, surface.surfelCells, s.position.data(), h, r.surfelBins);
  packParticles(p, r.particleBins.base, r.carried);
  r.free.assign(s.owned, 1);
  listGroups(surface, r.free, r.surfelBins, r.particleBins, {0, h}, r.lists);
}

CarrySums carrySumsOf(const Surface& surface, const RelaxTools& r) {
  const Surfels& s = surface.surfels;
  CarrySums in;
  // null without surfels
  in.place = reinterpret_cast<const double*>(s.position.data());
  in.liquid = s.liquid.active ? s.liquid.data() : nullptr;
  in.particle = r.carried.data();
  in.self = r.lists.self.data();
  in.firstParticle = r.lists.firstParticle.data();
  in.particleRow = r.lists.particle.data();
  in.perSupport2 = 1 / (surface.particleSupport * surface.particleSupport);
  for (std::size_t a = 0; a < 3; a++) in.origin[a] = r.particleBins.base[static_cast<int>(a)];
  return in;
}

/// Surfels of this rank, later of all ranks.
struct CarryCounts {
  std::int64_t uncarried = 0;   ///< number of surfels without particles within their support
  std::int64_t keptFrames = 0;  ///< number of surfels whose tangents would become collinear
};

/// Sets the displacement and fields of a surfel, and rotates its frame.
void carrySurfel(Surfels& s, std::size_t i, const Carry& c, CarryCounts& count) {
  s.moving[i] = !(c.weight > 0);
  s.carried[i] = c.move;
  if (s.moving[i]) {
    count.uncarried++;
    s.resampleMargin[i] = 0;
    return;
  }
  if (!turnFrame(c.gradient, s.normal[i], s.tangent[i])) count.keptFrames++;
  const auto strain = static_cast<float>(strainOf(c.gradient));
  s.resampleMargin[i] = std::max(0.0f, s.resampleMargin[i] - strain);
  if (s.liquid.active) {
    s.strain[i] = strain;
    s.liquid[i] = static_cast<float>(c.liquid);
  }
  if (s.temperature.active) s.temperature[i] = static_cast<float>(c.temperature);
}

/// Sets displacements, fields and frames of surfels from the particles around them. Returns counts of all
/// ranks. Collective.
CarryCounts carryAll(Surface& surface, RelaxTools& r, Reducer& all) {
  Surfels& s = surface.surfels;
  prepareSums(surface, r);
  CarrySums in = carrySumsOf(surface, r);
  alignas(32) std::array<double, 8 * carrySums> sums;
  Bend bend{&in, r.kernels, {}, {}};
  std::array<Carry, 8> found;
  CarryCounts count;
  const auto bends = [](const Carry& c) { return c.weight > 0 && c.liquid < 1; };
  for (std::size_t g = 0; g < r.lists.groups(); g++) {
    r.kernels->carry(in, g, sums.data());
    for (std::size_t lane = 0; lane < 8; lane++)
      found[lane] = carryOf(sums.data(), lane, s.position[r.lists.self[8 * g + lane]] - r.particleBins.base);
    if (std::any_of(found.begin(), found.end(), bends)) {
      bend.find(g, found);
      for (std::size_t lane = 0; lane < 8; lane++)
        if (bends(found[lane]))
          found[lane].gradient = found[lane].gradient + bend.added(lane, found[lane].moved);
    }
    for (std::size_t lane = 0; lane < r.lists.lanes[g]; lane++)
      carrySurfel(s, r.lists.self[8 * g + lane], found[lane], count);
  }
  std::int64_t total[2]{count.uncarried, count.keptFrames};
  all.sum(total);
  return {total[0], total[1]};
}

/// Removes these rows, given in ascending order. Returns their number on all ranks. Collective.
std::int64_t removeRows(Surfels& s, const std::vector<std::uint32_t>& rows, Reducer& all) {
  std::int64_t removed[1]{static_cast<std::int64_t>(rows.size())};
  all.sum(removed);
  if (rows.empty()) return removed[0];
  std::vector<std::uint32_t> kept;
  auto at = rows.begin();
  for (std::uint32_t i = 0; i < s.owned; i++)
    if (at != rows.end() && *at == i) ++at;
    else kept.push_back(i);
  s.reorder(kept);
  return removed[0];
}

}  // namespace

void displaceSurfels(const Scene& scene, Surface& surface, SurfaceHalos halos, SurfaceTools& t) {
  Surfels& s = surface.surfels;
  const bool blend = s.liquid.active;
  s.resize(s.owned, 0);
  // in this function: surfels without particles
  s.activate(s.moving);
  // in this function: displacement
  s.activate(s.carried);
  if (blend) s.activate(s.strain);
  const CarryCounts count = carryAll(surface, t.relax, halos.all);
  surface.counters.keptNormals += count.keptFrames;
  std::vector<std::uint32_t> lost;
  if (count.uncarried > 0) lost = followNeighbours(surface, halos, t);
  moveByReference(scene, surface, t.relax.particleBins);
  for (std::size_t i = 0; i < s.owned; i++) s.position[i] += s.carried[i];
  if (count.uncarried > 0) surface.counters.lost += removeRows(s, lost, halos.all);
  deactivate(s.moving);
  if (!blend) return deactivate(s.carried);
  s.activate(s.carriedNormal);
  for (std::size_t i = 0; i < s.owned; i++) s.carried[i] = s.position[i], s.carriedNormal[i] = s.normal[i];
}

std::vector<Vec3d> interpolatedDisplacements(Surface& surface, SurfaceTools& t) {
  Surfels& s = surface.surfels;
  RelaxTools& r = t.relax;
  s.resize(s.owned, 0);
  prepareSums(surface, r);
  const CarrySums in = carrySumsOf(surface, r);
  alignas(32) std::array<double, 8 * carrySums> sums;
  std::vector<Vec3d> moves(s.owned);
  for (std::size_t g = 0; g < r.lists.groups(); g++) {
    r.kernels->carry(in, g, sums.data());
    for (std::size_t lane = 0; lane < r.lists.lanes[g]; lane++) {
      const std::size_t i = r.lists.self[8 * g + lane];
      moves[i] = carryOf(sums.data(), lane, s.position[i] - r.particleBins.base).move;
    }
  }
  return moves;
}

}  // namespace thaw
