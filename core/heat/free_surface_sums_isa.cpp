// SPDX-License-Identifier: Apache-2.0
// The sums of free_surface_sums.hpp, compiled once per instruction set.
#include "core/heat/free_surface_sums.hpp"

#include "core/fluid/terms/choose_types.hpp"
#include "core/fluid/terms/term.hpp"
#include "core/simd/isa_name.hpp"

namespace thaw {
namespace THAW_ISA {
namespace {

/// Position difference own - other, in support radii.
template<class Real> struct Difference {
  Lanes<Real> x, y, z, q2;
  THAW_INLINE Difference(const Lanes4<Real>& i, const Lanes4<Real>& j)
      : x(positionDifference(i.a, j.a)),
        y(positionDifference(i.b, j.b)),
        z(positionDifference(i.c, j.c)),
        q2(dot3(x, y, z, x, y, z)) {}
};

/// Exposed area. One term of the pair sums.
template<class Real> struct ExposedArea {
  using L = Lanes<Real>;
  const Record<Real>* positionVolume;
  const ExposedAreaLaw* law;
  L perReach;
  float* area;
  using Data = Lanes4<Real>;
  struct Sum {
    L weight = L(0.0), x = L(0.0), y = L(0.0), z = L(0.0);
  };
  THAW_INLINE Data load(const std::uint32_t* entries) const { return loadListed(positionVolume, entries); }
  THAW_INLINE void pair(const Data& i, const Data& j, const std::uint32_t*, Sum& s) const {
    const Difference<Real> d(i, j);
    const L q = perReach * sqrt(d.q2), g = j.d * max(L(1.0) - q * q, L(0.0));
    s.weight = fma(g, q, s.weight);
    s.x = fma(g, d.x, s.x);
    s.y = fma(g, d.y, s.y);
    s.z = fma(g, d.z, s.z);
  }
  THAW_INLINE void finish(const std::uint32_t* rows, const Data&, const Sum& s, std::uint32_t dummy) const {
    const L size = perReach * sqrt(dot3(s.x, s.y, s.z, s.x, s.y, s.z));
    for (int l = 0; l < 8; l++)
      if (rows[l] != dummy)
        area[rows[l]] = static_cast<float>(areaOf(*law, law->perVolume * static_cast<double>(s.weight[l]),
                                                  law->perVolume * static_cast<double>(size[l])));
  }
};

/// Sums of the conduction correction. One term of the pair sums.
template<class Real, class Kernel> struct ConductionMoments {
  using L = Lanes<Real>;
  const Record<Real>* positionVolume;
  ConductionSums* sums;
  using Data = Lanes4<Real>;
  struct Sum {
    L weight = L(0.0), xx = L(0.0), yy = L(0.0), zz = L(0.0), xy = L(0.0), yz = L(0.0), xz = L(0.0);
  };
  THAW_INLINE Data load(const std::uint32_t* entries) const { return loadListed(positionVolume, entries); }
  THAW_INLINE void pair(const Data& i, const Data& j, const std::uint32_t*, Sum& s) const {
    const Difference<Real> d(i, j);
    const L w = j.d * Kernel::laplace(d.q2), x = w * d.x, y = w * d.y, z = w * d.z;
    s.weight += w;
    s.xx = fma(x, d.x, s.xx);
    s.yy = fma(y, d.y, s.yy);
    s.zz = fma(z, d.z, s.zz);
    s.xy = fma(x, d.y, s.xy);
    s.yz = fma(y, d.z, s.yz);
    s.xz = fma(x, d.z, s.xz);
  }
  THAW_INLINE void finish(const std::uint32_t* rows, const Data&, const Sum& s, std::uint32_t dummy) const {
    const auto at = [](const L& lanes, int l) { return static_cast<float>(lanes[l]); };
    for (int l = 0; l < 8; l++)
      if (rows[l] != dummy)
        sums[rows[l]] = {at(s.weight, l),
                         {at(s.xx, l), at(s.yy, l), at(s.zz, l), at(s.xy, l), at(s.yz, l), at(s.xz, l)}};
  }
};

// The check does not see that the term of the generic lambda writes the areas.
// NOLINTNEXTLINE(readability-non-const-parameter)
void areas(const PairSums& in, const ExposedAreaLaw& law, float* area, GroupRange range) {
  const auto sum = [&](auto real) {
    using Real = decltype(real);
    ExposedArea<Real> term{records<Real>(in.positionVolume), &law, Lanes<Real>(1 / law.reach), area};
    sweep(*in.lists, range, term, Groups::All);
  };
  if (in.precision == Precision::Single) sum(float{});
  else sum(double{});
}

void conduction(const PairSums& in, ConductionSums* sums, GroupRange range) {
  chooseTypes(in, [&](auto real, auto kernel) {
    using Real = decltype(real);
    ConductionMoments<Real, decltype(kernel)> term{records<Real>(in.positionVolume), sums};
    sweep(*in.lists, range, term, Groups::All);
  });
}

}  // namespace

const FreeSurfaceKernels& freeSurfaceKernelSet();
const FreeSurfaceKernels& freeSurfaceKernelSet() {
  static constexpr FreeSurfaceKernels set{isaName, areas, conduction};
  return set;
}

}  // namespace THAW_ISA
}  // namespace thaw
