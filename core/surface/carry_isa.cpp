// How the particles around eight surfels carry them along (K05 4.2.1): a lane is a surfel, as in forces_isa.cpp, but in double precision, so that what is
// carried round and round comes back to where it was.
#include "core/math/vec3.hpp"
#include "core/simd/lanes.hpp"
#include "core/surface/surface_kernels.hpp"

namespace thaw {
namespace THAW_ISA {

void carry(const CarrySums& in, std::size_t g, double* sums);
void carry(const CarrySums& in, std::size_t g, double* sums) {
  alignas(32) double own[3][8];
  for (std::size_t lane = 0; lane < 8; lane++)
    for (std::size_t a = 0; a < 3; a++) own[a][lane] = in.place[3 * in.self[8 * g + lane] + a];
  const LanesD x = loadRow(own[0]), y = loadRow(own[1]), z = loadRow(own[2]), zero(0.0), one(1.0), perSupport2(in.perSupport2);
  LanesD sum[carrySums];
  for (LanesD& s : sum) s = zero;
  for (std::uint64_t n = in.firstParticle[g]; n < in.firstParticle[g + 1]; n++) {
    const double* p = in.particle + carryRecord * in.particleRow[n];
    const LanesD dx = x - LanesD(p[0]), dy = y - LanesD(p[1]), dz = z - LanesD(p[2]);
    const LanesD u = max(one - (dx * dx + dy * dy + dz * dz) * perSupport2, zero), w = u * u * u;
    sum[0] += w;
    for (std::size_t k = 0; k < carryValues; k++) sum[1 + k] += w * LanesD(p[4 + k]);
  }
  for (std::size_t k = 0; k < carrySums; k++) {
    *reinterpret_cast<Vec4d*>(sums + 8 * k) = sum[k].lo;
    *reinterpret_cast<Vec4d*>(sums + 8 * k + 4) = sum[k].hi;
  }
}

}  // namespace THAW_ISA
}  // namespace thaw
