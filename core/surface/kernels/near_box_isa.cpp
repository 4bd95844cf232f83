// SPDX-License-Identifier: Apache-2.0
// Finds positions near a box, eight at a time. Every search on the surface begins with this kernel.
#include "core/simd/pack.hpp"
#include "core/surface/kernels/surface_kernels.hpp"

namespace thaw {
namespace THAW_ISA {

std::uint32_t nearBox(const NearBox& box, const float* x, const float* y, const float* z, std::uint32_t count,
                      std::uint32_t* found);
std::uint32_t nearBox(const NearBox& box, const float* x, const float* y, const float* z, std::uint32_t count,
                      std::uint32_t* found) {
  const LanesF mx(box.middle[0]), my(box.middle[1]), mz(box.middle[2]), hx(box.half[0]), hy(box.half[1]),
      hz(box.half[2]), most(box.reach2), zero(0.0f);
  const auto at = [](const float* from) {
    LanesF v;
    __builtin_memcpy(&v.v, from, 32);
    return v;
  };
  // distance outside of the box along one axis
  const auto beyond = [&](LanesF v, LanesF middle, LanesF half) {
    const LanesF d = v - middle;
    return max(max(d, -d) - half, zero);
  };
  Vec8u index{0, 1, 2, 3, 4, 5, 6, 7};
  std::uint32_t n = 0;
  for (std::uint32_t k = 0; k < count; k += 8, index += 8) {
    const LanesF dx = beyond(at(x + k), mx, hx), dy = beyond(at(y + k), my, hy),
                 dz = beyond(at(z + k), mz, hz);
    std::uint32_t kept = bitsOf(dx * dx + dy * dy + dz * dz < most);
    if (count - k < 8) kept &= (1u << (count - k)) - 1;
    n += pack8(index, kept, found + n);
  }
  return n;
}

}  // namespace THAW_ISA
}  // namespace thaw
