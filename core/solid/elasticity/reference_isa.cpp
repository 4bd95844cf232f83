// SPDX-License-Identifier: Apache-2.0
// Each lane is a solid and sums its bonds in order. The operations are those of refreshSolid, without fused
// multiply-adds. An unused entry adds zeros: its end is the solid itself, and its weight is set to 0.
#include "core/simd/lanes.hpp"
#include "core/solid/elasticity/reference_kernels.hpp"

namespace thaw {
namespace THAW_ISA {

namespace {

/// Same as minimumImage, along one axis; period 0: not periodic.
THAW_INLINE LanesD nearest(LanesD d, double period) {
  if (!(period > 0)) return d;
  const LanesD half(period / 2), whole(period);
  return select(d > half, d - whole, select(d < -half, d + whole, d));
}

THAW_INLINE LanesD gather(const Vec3d* at, const std::uint32_t* rows, double Vec3d::*axis) {
  return {Vec4d{at[rows[0]].*axis, at[rows[1]].*axis, at[rows[2]].*axis, at[rows[3]].*axis},
          Vec4d{at[rows[4]].*axis, at[rows[5]].*axis, at[rows[6]].*axis, at[rows[7]].*axis}};
}

void moments(const ReferenceArrays& a, std::size_t group, GroupMoments& out) {
  std::uint32_t solidIndices[8];
  for (std::uint32_t l = 0; l < 8; l++) solidIndices[l] = static_cast<std::uint32_t>(8 * group) + l;
  const Vec3<LanesD> own{gather(a.reference, solidIndices, &Vec3d::x),
                         gather(a.reference, solidIndices, &Vec3d::y),
                         gather(a.reference, solidIndices, &Vec3d::z)};
  const LanesD support2(a.support * a.support);
  Sym3<LanesD> sum{LanesD(0.0), LanesD(0.0), LanesD(0.0), LanesD(0.0), LanesD(0.0), LanesD(0.0)};
  LanesD weights(0.0);
  for (std::size_t k = 0; k < a.capacity; k++) {
    const std::uint32_t* const ends = a.neighbour + 8 * (group * a.capacity + k);
    const Vec3<LanesD> X{nearest(gather(a.reference, ends, &Vec3d::x) - own.x, a.period[0]),
                         nearest(gather(a.reference, ends, &Vec3d::y) - own.y, a.period[1]),
                         nearest(gather(a.reference, ends, &Vec3d::z) - own.z, a.period[2])};
    const LanesD q = LanesD(1.0) - dot(X, X) / support2;
    alignas(64) double there[8];
    for (int l = 0; l < 8; l++) there[l] = ends[l] != solidIndices[l] ? 1 : 0;
    const LanesD weight = select((q > LanesD(1e-3)) & (loadRow(there) > LanesD(0.0)), q * q * q, LanesD(0.0));
    sum = sum + weight * symmetric(outer(X, X));
    weights += weight;
    double* const to = a.gathered + 32 * k;
    toDoubles(X.x, to), toDoubles(X.y, to + 8), toDoubles(X.z, to + 16), toDoubles(weight, to + 24);
  }
  const LanesD* const parts[6] = {&sum.xx, &sum.yy, &sum.zz, &sum.xy, &sum.yz, &sum.xz};
  for (int c = 0; c < 6; c++) toDoubles(*parts[c], out.moment[c]);
  toDoubles(weights, out.weights);
}

void levers(const ReferenceArrays& a, std::size_t, GroupMoments& out) {
  const Mat3<LanesD> inverse = full(Sym3<LanesD>{loadRow(out.inverse[0]), loadRow(out.inverse[1]),
                                                 loadRow(out.inverse[2]), loadRow(out.inverse[3]),
                                                 loadRow(out.inverse[4]), loadRow(out.inverse[5])});
  Vec3<LanesD> sum{LanesD(0.0), LanesD(0.0), LanesD(0.0)};
  LanesD lengths(0.0);
  for (std::size_t k = 0; k < a.capacity; k++) {
    const double* const from = a.gathered + 32 * k;
    const Vec3<LanesD> lever = loadRow(from + 24) *
                               (inverse * Vec3<LanesD>{loadRow(from), loadRow(from + 8), loadRow(from + 16)});
    sum += lever;
    lengths += sqrt(dot(lever, lever));
  }
  toDoubles(sum.x, out.sum[0]), toDoubles(sum.y, out.sum[1]), toDoubles(sum.z, out.sum[2]),
      toDoubles(lengths, out.lengths);
}

#define THAW_TEXT2(x) #x
#define THAW_TEXT(x) THAW_TEXT2(x)
constexpr ReferenceKernels set{THAW_TEXT(THAW_ISA) + 4, moments, levers};  // "isa_avx2" without "isa_"
#undef THAW_TEXT
#undef THAW_TEXT2

}  // namespace

const ReferenceKernels& referenceKernelSet();
const ReferenceKernels& referenceKernelSet() { return set; }

}  // namespace THAW_ISA
}  // namespace thaw
