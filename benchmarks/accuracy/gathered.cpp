// SPDX-License-Identifier: Apache-2.0
#include "benchmarks/accuracy/gathered.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numeric>

#include "core/fluid/laws/particle_pressure.hpp"

namespace thaw::accuracy {
namespace {

/// Bins at least `radius` wide along each axis. Periodic axes wrap around.
struct Bins {
  Vec3d low, period;  // m; period 0: the axis is not periodic
  std::int64_t count[3];
  double edge[3];
  std::vector<std::vector<std::uint32_t>> members;

  Bins(const Domain& domain, const std::vector<GatheredParticle>& particles, double radius) {
    Vec3d high{-never, -never, -never};
    low = {never, never, never};
    for (int a = 0; a < 3; a++) {
      for (const GatheredParticle& p : particles) {
        low[a] = std::min(low[a], p.position[a]);
        high[a] = std::max(high[a], p.position[a]);
      }
      if (domain.side[static_cast<std::size_t>(a)][0] == Side::Periodic) {
        low[a] = domain.min[a];
        high[a] = domain.max[a];
        period[a] = high[a] - low[a];
      }
      count[a] = std::clamp<std::int64_t>(static_cast<std::int64_t>((high[a] - low[a]) / radius), 1, 256);
      edge[a] = std::max(high[a] - low[a], radius) / static_cast<double>(count[a]);
    }
    members.resize(static_cast<std::size_t>(count[0] * count[1] * count[2]));
    for (std::size_t i = 0; i < particles.size(); i++)
      members[indexOf(placeOf(particles[i].position))].push_back(static_cast<std::uint32_t>(i));
  }
  std::array<std::int64_t, 3> placeOf(const Vec3d& x) const {
    std::array<std::int64_t, 3> at{};
    for (int a = 0; a < 3; a++)
      at[static_cast<std::size_t>(a)] = std::clamp<std::int64_t>(
          static_cast<std::int64_t>((x[a] - low[a]) / edge[a]), 0, count[a] - 1);
    return at;
  }
  std::size_t indexOf(const std::array<std::int64_t, 3>& at) const {
    return static_cast<std::size_t>((at[2] * count[1] + at[1]) * count[0] + at[0]);
  }
  /// The bins around a bin, itself included, each once.
  std::vector<std::size_t> around(const std::array<std::int64_t, 3>& at) const {
    std::vector<std::size_t> found;
    for (std::int64_t k = 0; k < 27; k++) {
      std::array<std::int64_t, 3> to{at[0] + k % 3 - 1, at[1] + k / 3 % 3 - 1, at[2] + k / 9 - 1};
      bool inside = true;
      for (int a = 0; a < 3; a++) {
        std::int64_t& t = to[static_cast<std::size_t>(a)];
        if (period[a] > 0) t = (t + count[a]) % count[a];
        inside = inside && t >= 0 && t < count[a];
      }
      if (inside) found.push_back(indexOf(to));
    }
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
    return found;
  }
};

std::size_t rootOf(std::vector<std::size_t>& parent, std::size_t i) {
  while (parent[i] != i) i = parent[i] = parent[parent[i]];
  return i;
}

Vec3d nearestImage(Vec3d d, const Vec3d& period) {
  for (int a = 0; a < 3; a++)
    if (period[a] > 0) d[a] -= period[a] * std::round(d[a] / period[a]);
  return d;
}

Vec3d periodsOf(const Domain& domain) {
  Vec3d period;
  for (int a = 0; a < 3; a++)
    if (domain.side[static_cast<std::size_t>(a)][0] == Side::Periodic)
      period[a] = domain.max[a] - domain.min[a];
  return period;
}

/// Wendland's C2 kernel with support 1, not normalised.
double kernel(double q) { return std::pow(1 - q, 4) * (4 * q + 1); }

/// Sum of the kernel over a cubic lattice; support in spacings.
double latticeSum(double support) {
  double sum = 0;
  const int reach = static_cast<int>(support);
  for (int i = -reach; i <= reach; i++)
    for (int j = -reach; j <= reach; j++)
      for (int k = -reach; k <= reach; k++)
        if (const double q = std::sqrt(i * i + j * j + k * k) / support; q < 1) sum += kernel(q);
  return sum;
}

/// Unit vectors from the centre of a cube to those of its faces, edges and corners.
std::vector<Vec3d> directions26() {
  std::vector<Vec3d> all;
  for (int k = 0; k < 27; k++)
    if (k != 13) all.push_back(normalized(Vec3d{k % 3 - 1.0, k / 3 % 3 - 1.0, k / 9 - 1.0}));
  return all;
}

/// A bit for each direction within 37 degrees of d.
std::uint32_t directionsNear(const Vec3d& d) {
  static const std::vector<Vec3d> all = directions26();
  std::uint32_t near = 0;
  const double least = 0.8 * length(d);
  for (std::size_t k = 0; k < all.size(); k++)
    if (dot(all[k], d) >= least) near |= 1u << k;
  return near;
}

}  // namespace

std::vector<GatheredParticle> gather(Trial& r) {
  static_assert(std::is_trivially_copyable_v<GatheredParticle>);
  const Continuum& p = r.world.particles;
  std::vector<GatheredParticle> own;
  for (std::size_t i = 0; i < p.owned; i++)
    own.push_back({p.id[i], p.position[i], p.velocity[i], p.mass[i],
                   static_cast<double>(pressureOfParticle(r.world.scene, r.world.modules, r.world.particles,
                                                          r.tools.liquids, i)),
                   p.body[i]});
  const int ranks = r.comm.size(), bytes = static_cast<int>(own.size() * sizeof(GatheredParticle));
  std::vector<int> sizes(static_cast<std::size_t>(ranks)), places(static_cast<std::size_t>(ranks), 0);
  MPI_Allgather(&bytes, 1, MPI_INT, sizes.data(), 1, MPI_INT, r.comm.handle());
  std::partial_sum(sizes.begin(), sizes.end() - 1, places.begin() + 1);
  std::vector<GatheredParticle> all(static_cast<std::size_t>(places.back() + sizes.back()) /
                                    sizeof(GatheredParticle));
  MPI_Allgatherv(own.data(), bytes, MPI_BYTE, all.data(), sizes.data(), places.data(), MPI_BYTE,
                 r.comm.handle());
  std::sort(all.begin(), all.end(),
            [](const GatheredParticle& a, const GatheredParticle& b) { return a.id < b.id; });
  return all;
}

void forEachPair(const Domain& domain, const std::vector<GatheredParticle>& particles, double radius,
                 const PairAction& action) {
  const Bins bins(domain, particles, radius);
  const Vec3d period = periodsOf(domain);
  for (std::size_t i = 0; i < particles.size(); i++)
    for (const std::size_t bin : bins.around(bins.placeOf(particles[i].position)))
      for (const std::uint32_t j : bins.members[bin]) {
        if (j <= i) continue;
        const Vec3d between = nearestImage(particles[i].position - particles[j].position, period);
        if (dot(between, between) < radius * radius) action(i, j, between);
      }
}

Components findComponents(const Domain& domain, const std::vector<GatheredParticle>& particles, double link) {
  std::vector<std::size_t> parent(particles.size()), members(particles.size(), 0);
  std::iota(parent.begin(), parent.end(), std::size_t{0});
  forEachPair(domain, particles, link, [&](std::size_t i, std::size_t j, const Vec3d&) {
    parent[rootOf(parent, i)] = rootOf(parent, j);
  });
  Components c{};
  for (std::size_t i = 0; i < particles.size(); i++) members[rootOf(parent, i)]++;
  for (const std::size_t n : members) {
    if (n > 0) c.count++;
    c.largestShare = std::max(c.largestShare, static_cast<double>(n) / static_cast<double>(particles.size()));
  }
  return c;
}

double meanInnerDensity(const Domain& domain, double spacing,
                        const std::vector<GatheredParticle>& particles) {
  constexpr double support = 2.5;  // spacings; fixed, so that the measure does not depend on the formulation
  std::vector<double> density(particles.size(), kernel(0));
  std::vector<std::uint32_t> covered(particles.size(), 0);
  forEachPair(domain, particles, support * spacing, [&](std::size_t i, std::size_t j, const Vec3d& between) {
    const double q = length(between) / (support * spacing), w = kernel(q);
    density[i] += w;
    density[j] += w;
    if (q < 0.5) return;
    covered[j] |= directionsNear(between);
    covered[i] |= directionsNear(between * -1.0);
  });
  double sum = 0;
  std::size_t inside = 0;
  for (std::size_t i = 0; i < particles.size(); i++)
    if (covered[i] == (1u << 26) - 1) sum += density[i], inside++;
  return inside == 0 ? 0 : sum / (latticeSum(support) * static_cast<double>(inside));
}

bool writeMiddleLayer(Trial& r, const std::string& path) {
  const std::vector<GatheredParticle> all = gather(r);
  if (r.comm.rank() != 0) return true;
  FILE* out = std::fopen(path.c_str(), "w");
  if (!out) return false;
  const double middle = 0.5 * (r.world.scene.domain.min.z + r.world.scene.domain.max.z), dx = r.spacing();
  std::fprintf(out, "x,y,speed,pressure\n");
  for (const GatheredParticle& p : all)
    if (p.position.z >= middle && p.position.z < middle + dx)
      std::fprintf(out, "%.4g,%.4g,%.4g,%.4g\n", p.position.x, p.position.y, length(p.velocity), p.pressure);
  return std::fclose(out) == 0;
}

}  // namespace thaw::accuracy
