// SPDX-License-Identifier: Apache-2.0
// Kernels for the surface between the surfels of a patch, for several positions at once. They compute the
// coverage of points on a circle, and sums for the projection. These kernels take most of the time of
// resampling.
#include "core/simd/lanes.hpp"
#include "core/surface/kernels/surface_kernels.hpp"

namespace thaw {
namespace THAW_ISA {
namespace {

// Loads eight floats of any alignment.
THAW_INLINE LanesF at(const float* from) {
  LanesF v;
  __builtin_memcpy(&v.v, from, 32);
  return v;
}

}  // namespace

void openPlaces(const CirclePlaces& circle, const float* disc, std::size_t discs, float* open);
void openPlaces(const CirclePlaces& circle, const float* disc, std::size_t discs, float* open) {
  const LanesF zero(0.0f), one(1.0f), half(0.5f), two(2.0f), most(1.2f), side(circle.side),
      ss(circle.curvature[0]), st(circle.curvature[1]), tt(circle.curvature[2]);
  for (std::size_t k = 0; k < circlePlaces; k += 8) {
    // on the circle of curvature in its direction (pointAround)
    const LanesF c = at(circle.cosine + k), d = at(circle.sine + k),
                 curved = min(most, max(-most, c * c * ss + two * c * d * st + d * d * tt));
    const LanesF sink = half * curved, flat = sqrt(one - sink * sink), up = one - curved * sink,
                 a = flat * (c * ss + d * st), b = flat * (c * st + d * tt);
    const LanesF alongU = flat * c, alongV = flat * d, size = one / sqrt(up * up + a * a + b * b);
    LanesF place[3], normal[3];
    for (std::size_t axis = 0; axis < 3; axis++) {
      const LanesF n(circle.normal[axis]), u(circle.tangent[axis]), v(circle.across[axis]);
      place[axis] = alongU * u + alongV * v - sink * n;
      normal[axis] = size * (up * n + a * u + b * v);
    }
    const LanesF x = place[0], y = place[1], z = place[2], nx = normal[0], ny = normal[1], nz = normal[2];
    LanesF left = one;
    for (std::size_t j = 0; j < discs; j++) {
      const float* p = disc + 6 * j;
      const LanesF ex = x - LanesF(p[0]), ey = y - LanesF(p[1]), ez = z - LanesF(p[2]);
      const auto covers = (ex * ex + ey * ey + ez * ez < one) &
                          (nx * LanesF(p[3]) + ny * LanesF(p[4]) + nz * LanesF(p[5]) > side);
      left = select(covers, zero, left);
    }
    __builtin_memcpy(open + k, &left.v, 32);
  }
}

bool covered(const DiscsAround& in, const float* place, const float* normal);
bool covered(const DiscsAround& in, const float* place, const float* normal) {
  const LanesF px(place[0]), py(place[1]), pz(place[2]), ux(normal[0]), uy(normal[1]), uz(normal[2]),
      most(in.most), side(in.side), over(0.2f), beside(0.8f);
  for (std::size_t j = 0; j < in.count; j += 8) {
    const LanesF dx = at(in.x + j) - px, dy = at(in.y + j) - py, dz = at(in.z + j) - pz,
                 r2 = at(in.radius2 + j);
    const LanesF facing = at(in.nx + j) * ux + at(in.ny + j) * uy + at(in.nz + j) * uz,
                 along = dx * ux + dy * uy + dz * uz, off2 = dx * dx + dy * dy + dz * dz;
    const auto above = (facing > over) & (max(along, -along) < most) & (off2 - along * along < r2),
               near = (facing > side) & (off2 < beside * r2);
    if (any(MaskF{above.bits | near.bits})) return true;
  }
  return false;
}

void betweenDiscs(const PatchPlaces& in, double* sums);
void betweenDiscs(const PatchPlaces& in, double* sums) {
  const LanesD zero(0.0), one(1.0), reach2(in.reach2), back2(in.back2),
      x = loadRow(in.place), y = loadRow(in.place + 8), z = loadRow(in.place + 16);
  LanesD weight = zero, along = zero, normalX = zero, normalY = zero, normalZ = zero, awayX = zero,
         awayY = zero, awayZ = zero;
  for (std::size_t j = 0; j < in.discs; j++) {
    const double* p = in.disc + 6 * j;
    const LanesD nx(p[3]), ny(p[4]), nz(p[5]), dx = x - LanesD(p[0]), dy = y - LanesD(p[1]),
                                               dz = z - LanesD(p[2]);
    const LanesD r2 = dx * dx + dy * dy + dz * dz, u = one - r2 * back2,
                 w = select(r2 < reach2, u * u * u, zero);
    weight += w;
    normalX += w * nx, normalY += w * ny, normalZ += w * nz;
    awayX += w * dx, awayY += w * dy, awayZ += w * dz;
    along += w * (nx * dx + ny * dy + nz * dz);
  }
  const LanesD all[patchSums] = {weight, along, normalX, normalY, normalZ, awayX, awayY, awayZ};
  for (std::size_t k = 0; k < patchSums; k++) toDoubles(all[k], sums + 8 * k);
}

}  // namespace THAW_ISA
}  // namespace thaw
