// SPDX-License-Identifier: Apache-2.0
// Interpolates the particles' displacement at eight surfels (K05 4.2.1). A lane is a surfel, as in
// forces_isa.cpp. Double precision avoids drift of surfaces in long rotations.
#include "core/math/vec3.hpp"
#include "core/simd/lanes.hpp"
#include "core/surface/kernels/surface_kernels.hpp"

namespace thaw {
namespace THAW_ISA {

namespace {

/// Loads the positions of a group's surfels.
THAW_INLINE void loadPlaces(const CarrySums& in, std::size_t g, LanesD* place) {
  alignas(32) double own[3][8];
  for (std::size_t lane = 0; lane < 8; lane++)
    for (std::size_t a = 0; a < 3; a++) own[a][lane] = in.place[3 * in.self[8 * g + lane] + a];
  for (std::size_t a = 0; a < 3; a++) place[a] = loadRow(own[a]);
}

THAW_INLINE LanesD loadLiquid(const CarrySums& in, std::size_t g) {
  if (!in.liquid) return LanesD(1.0);
  alignas(32) double own[8];
  for (std::size_t lane = 0; lane < 8; lane++)
    own[lane] = static_cast<double>(in.liquid[in.self[8 * g + lane]]);
  return loadRow(own);
}

/// Returns the factor of a particle's weight in the motion of a surfel.
THAW_INLINE LanesD carrying(double particle, const LanesD& surfel) {
  return max(LanesD(1.0) - max(LanesD(particle) - surfel, LanesD(0.0)), LanesD(leastMotionWeight));
}

}  // namespace

void carry(const CarrySums& in, std::size_t g, double* sums);
void carry(const CarrySums& in, std::size_t g, double* sums) {
  LanesD place[3];
  loadPlaces(in, g, place);
  const LanesD x = place[0], y = place[1], z = place[2], zero(0.0), one(1.0), perSupport2(in.perSupport2);
  const LanesD liquid = loadLiquid(in, g);
  LanesD sum[carrySums];
  for (LanesD& s : sum) s = zero;
  for (std::uint64_t n = in.firstParticle[g]; n < in.firstParticle[g + 1]; n++) {
    const double* p = in.particle + carryRecord * in.particleRow[n];
    const LanesD dx = x - LanesD(p[0]), dy = y - LanesD(p[1]), dz = z - LanesD(p[2]);
    const LanesD u = max(one - (dx * dx + dy * dy + dz * dz) * perSupport2, zero), w = u * u * u;
    const LanesD moves = w * carrying(p[3], liquid);
    sum[0] += w;
    sum[1 + carryValues] += moves;
    for (std::size_t k = 0; k < carryMotion; k++) sum[1 + k] += moves * LanesD(p[4 + k]);
    for (std::size_t k = carryMotion; k < carryValues; k++) sum[1 + k] += w * LanesD(p[4 + k]);
  }
  for (std::size_t k = 0; k < carrySums; k++) toDoubles(sum[k], sums + 8 * k);
}

void bend(const CarrySums& in, std::size_t g, double* sums);
void bend(const CarrySums& in, std::size_t g, double* sums) {
  LanesD place[3], from[3], mean[3], sum[bendSums];
  loadPlaces(in, g, place);
  const LanesD zero(0.0), one(1.0), perSupport2(in.perSupport2), liquid = loadLiquid(in, g);
  for (std::size_t a = 0; a < 3; a++)
    from[a] = place[a] - LanesD(in.origin[a]), mean[a] = loadRow(in.mean + 8 * a);
  for (LanesD& s : sum) s = zero;
  for (std::uint64_t n = in.firstParticle[g]; n < in.firstParticle[g + 1]; n++) {
    const double* p = in.particle + carryRecord * in.particleRow[n];
    const double* G = p + 7;
    const LanesD dx = place[0] - LanesD(p[0]), dy = place[1] - LanesD(p[1]), dz = place[2] - LanesD(p[2]);
    const LanesD u = max(one - (dx * dx + dy * dy + dz * dz) * perSupport2, zero),
                 u2 = u * u * carrying(p[3], liquid);
    const LanesD wx = u2 * dx, wy = u2 * dy, wz = u2 * dz;
    for (std::size_t a = 0; a < 3; a++) {
      const LanesD value = LanesD(p[4 + a]) - mean[a] + LanesD(G[3 * a]) * from[0] +
                           LanesD(G[3 * a + 1]) * from[1] + LanesD(G[3 * a + 2]) * from[2];
      sum[3 * a] += value * wx;
      sum[3 * a + 1] += value * wy;
      sum[3 * a + 2] += value * wz;
    }
  }
  for (std::size_t k = 0; k < bendSums; k++) toDoubles(sum[k], sums + 8 * k);
}

}  // namespace THAW_ISA
}  // namespace thaw
