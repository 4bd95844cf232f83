// SPDX-License-Identifier: Apache-2.0
// A solid body on one rank with bonds found by brute force, for tests of the elastic step without cells or
// halos.
#pragma once
#include <cmath>
#include <functional>
#include <memory>
#include <vector>

#include "core/solid/bonds/bond_entries.hpp"
#include "core/solid/elasticity/elastic.hpp"
#include "core/solid/elasticity/rereference.hpp"
#include "core/solid/fracture.hpp"

namespace thaw::test {

/// A number in [-1, 1) that is a function of its arguments.
inline double noise(std::uint64_t n, std::uint64_t salt) {
  std::uint64_t z = n * 0x9e3779b97f4a7c15ull + salt * 0xd1b54a32d192ed03ull + 0x2545f4914f6cdd1dull;
  z = (z ^ z >> 30) * 0xbf58476d1ce4e5b9ull;
  z = (z ^ z >> 27) * 0x94d049bb133111ebull;
  return static_cast<double>((z ^ z >> 31) >> 11) / 4503599627370496.0 - 1;
}
inline Vec3d noise3(std::uint64_t n, std::uint64_t salt) {
  return {noise(n, 3 * salt), noise(n, 3 * salt + 1), noise(n, 3 * salt + 2)};
}

/// nx * ny * nz points with this spacing, displaced by up to `jitter` spacings.
inline std::vector<Vec3d> lattice(Vec3i n, double spacing, double jitter = 0) {
  std::vector<Vec3d> points;
  for (int z = 0; z < n.z; z++)
    for (int y = 0; y < n.y; y++)
      for (int x = 0; x < n.x; x++)
        points.push_back(spacing *
                         (Vec3d{double(x), double(y), double(z)} + jitter * noise3(points.size(), 7)));
  return points;
}

inline Material elasticMaterial(double young = 1e6, double poisson = 0.3) {
  Material m;
  m.young = {young, 0};
  m.poisson = {poisson, poisson};
  return m;
}

struct SolidBody {
  Scene scene;
  Modules modules;
  CellGrid grid;
  Continuum particles;
  Solids solids;
  Bonds bonds;
  ElasticWork work;
  ElasticStep step;
  std::vector<double> mass;
};

struct BodyOptions {
  double spacing = 0.1, support = 1.6;
  Precision precision = Precision::Double;
  Vec3d period{};
  bool freezing = false;
  std::function<double(std::size_t)> volume;  // m^3; default spacing^3
  std::function<int(std::size_t)> material;   // default 0
};

inline std::unique_ptr<SolidBody> makeBody(const std::vector<Vec3d>& points, std::vector<Material> materials,
                                           const BodyOptions& options = {}) {
  auto body = std::make_unique<SolidBody>();
  SolidBody& b = *body;
  b.scene.spacing = options.spacing;
  b.scene.numerics.bondSupport = options.support;
  b.scene.numerics.elasticPrecision = options.precision;
  b.scene.materials = std::move(materials);
  b.modules.solid = true;
  b.modules.freezing = options.freezing;
  for (const Material& m : b.scene.materials) {
    b.modules.plastic = b.modules.plastic || m.yieldStrain.solid < never;
    b.modules.fracture = b.modules.fracture || m.breakStretch < never;
  }
  b.grid.period = options.period;
  for (int a = 0; a < 3; a++) b.grid.periodic[a] = options.period[a] > 0;
  activateSolidFields(b.particles, b.solids, b.bonds, b.work, {b.scene, b.modules, b.grid});
  const std::size_t n = points.size();
  b.solids.resize(n, 0);
  const double support = options.support * options.spacing;
  std::vector<std::vector<std::pair<std::uint32_t, Vec3d>>> found(n);
  for (std::size_t i = 0; i < n; i++) {
    b.solids.id[i] = i;
    b.solids.position[i] = points[i];
    if (b.solids.reference.active) b.solids.reference[i] = points[i];
    b.solids.volume[i] = options.volume ? options.volume(i)
                                        : options.spacing * options.spacing * options.spacing;
    b.solids.material[i] = static_cast<std::uint16_t>(options.material ? options.material(i) : 0);
    b.mass.push_back(b.solids.volume[i] * b.scene.materials[b.solids.material[i]].density);
    for (std::size_t j = 0; j < n; j++) {
      const Vec3d x = minimumImage(points[j] - points[i], b.work.periods);
      if (j != i && bondWeight(x, support) > 0) found[i].push_back({static_cast<std::uint32_t>(j), x});
    }
    b.bonds.capacity = std::max(b.bonds.capacity, static_cast<int>(found[i].size()));
  }
  const std::size_t room = (n + lanes - 1) / lanes * lanes * static_cast<std::size_t>(b.bonds.capacity);
  b.bonds.neighbour.resize(room);
  b.bonds.eachReal([&](BondReals& r) { r.assign(room, 0); });
  for (std::size_t i = 0; i < n; i++)
    for (int k = 0; k < b.bonds.capacity; k++) {
      const bool some = static_cast<std::size_t>(k) < found[i].size();
      const auto bond = some ? found[i][static_cast<std::size_t>(k)]
                             : std::pair<std::uint32_t, Vec3d>{static_cast<std::uint32_t>(i), Vec3d{}};
      const Vec3d& x = bond.second;
      putBond(b.bonds, b.bonds.at(i, k), bond.first,
              {bond.first, {x.x, x.y, x.z}, {-x.x, -x.y, -x.z}, some ? bondWeight(x, support) : 0});
    }
  refreshReference(b.work, b.solids, b.bonds, true);
  return body;
}

inline ElasticResult computeForces(SolidBody& b) {
  ElasticResult r = computeDeformationAndStress(b.work, b.solids, b.bonds, b.step, SolidPart::Inner);
  r += computeDeformationAndStress(b.work, b.solids, b.bonds, b.step, SolidPart::Boundary);
  computeElasticForces(b.work, b.solids, b.bonds, b.step, SolidPart::Inner);
  computeElasticForces(b.work, b.solids, b.bonds, b.step, SolidPart::Boundary);
  return r;
}
inline double totalEnergy(const SolidBody& b) {
  double e = 0;
  for (std::size_t s = 0; s < b.solids.owned; s++) e += b.solids.energy[s];
  return e;
}
/// Sum of |force|, as a scale of errors.
inline double forceScale(const SolidBody& b) {
  double f = 0;
  for (std::size_t s = 0; s < b.solids.owned; s++) f += length(b.solids.force[s]);
  return f;
}
inline void moveAll(SolidBody& b, const std::vector<Vec3d>& points,
                    const std::function<Vec3d(const Vec3d&)>& map) {
  for (std::size_t s = 0; s < b.solids.owned; s++) b.solids.position[s] = map(points[s]);
}
inline Mat3d rotation(const Vec3d& axis, double angle) {
  const Vec3d n = normalized(axis);
  const Mat3d k{{{0, -n.z, n.y}, {n.z, 0, -n.x}, {-n.y, n.x, 0}}};
  return identity3<double>() + std::sin(angle) * k + (1 - std::cos(angle)) * (k * k);
}
inline double largest(const Mat3d& m) {
  double r = 0;
  for (int i = 0; i < 3; i++)
    for (int k = 0; k < 3; k++) r = std::max(r, std::abs(m.row[i][k]));
  return r;
}

}  // namespace thaw::test
