// SPDX-License-Identifier: Apache-2.0
// Sums at surfels over surrounding particles and surfels (K05 4.2.2). A lane is a surfel, and adds its
// neighbours in the order of the group's list. Eight adjacent surfels share a list, so a neighbour is loaded
// once for all lanes. This is faster than a list for each surfel.
#include "core/math/vec3.hpp"
#include "core/simd/isa_name.hpp"
#include "core/simd/lanes.hpp"
#include "core/surface/kernels/surface_kernels.hpp"

namespace thaw {
namespace THAW_ISA {

namespace {

using V = Vec3<LanesF>;

THAW_INLINE const Record<float>* records(const float* p) { return reinterpret_cast<const Record<float>*>(p); }
THAW_INLINE V apart(const Lanes4<float>& own, const Record<float>& other) {
  return {positionDifference(own.a, LanesF(other.a)), positionDifference(own.b, LanesF(other.b)),
          positionDifference(own.c, LanesF(other.c))};
}
THAW_INLINE void store(float* to, int channel, LanesF v) {
  *reinterpret_cast<Vec8f*>(to + 8 * channel) = v.v;
}
THAW_INLINE void store(float* to, int channel, const V& v) {
  store(to, channel, v.x);
  store(to, channel + 1, v.y);
  store(to, channel + 2, v.z);
}

/// With `gaps`, particles above a surfel's gap cutoff add nothing.
template<bool gaps> THAW_INLINE void overParticlesOf(const ForceSums& in, std::size_t g) {
  const LanesF zero(0.0f), one(1.0f), perSupport2(in.perParticleSupport2), perNear2(in.perNearSupport2);
  const Lanes4<float> own = load(records(in.place), in.self + 8 * g);
  LanesF colour(0.0f), smooth(0.0f), near(0.0f);
  V gradient{zero, zero, zero}, smoothGradient{zero, zero, zero}, attraction{zero, zero, zero},
      nearGradient{zero, zero, zero}, up{zero, zero, zero};
  // smallest height of a surfel above a contributing particle
  LanesF lowest(0.0f);
  if constexpr (gaps) {
    const Lanes4<float> frame = load(records(in.normal), in.self + 8 * g);
    up = {frame.a, frame.b, frame.c};
    for (int lane = 0; lane < 8; lane++)
      lowest.v[lane] = -in.gapCutoff[in.self[8 * g + static_cast<std::size_t>(lane)]];
  }
  for (std::uint64_t n = in.firstParticle[g]; n < in.firstParticle[g + 1]; n++) {
    const std::uint32_t j = in.particleRow[n];
    const Record<float>& p = records(in.particle)[j];
    const V d = apart(own, p);
    LanesF r2 = dot(d, d);
    if constexpr (gaps) r2 = select(dot(d, up) > lowest, r2, LanesF(1e30f));
    const LanesF u = max(one - r2 * perSupport2, zero), u2 = u * u, v2 = LanesF(p.d) * u2, v3 = v2 * u,
                 a2 = LanesF(in.particleColour[j]) * u2;
    colour += v3;
    smooth += a2 * u;
    smoothGradient += a2 * d;
    gradient += v2 * d;
    attraction += v3 * d;
    const LanesF close = max(one - r2 * perNear2, zero), close2 = close * close;
    near += close2 * close;
    nearGradient += close2 * d;
  }
  float* to = in.overParticles + 8 * particleSums * g;
  store(to, Colour, colour);
  store(to, SmoothColour, smooth);
  store(to, Gradient, gradient);
  store(to, SmoothGradient, smoothGradient);
  store(to, Attraction, attraction);
  store(to, Near, near);
  store(to, NearGradient, nearGradient);
}

void overParticles(const ForceSums& in) {
  for (std::size_t k = 0; k < in.groupCount; k++) {
    if (in.groupHasGapCutoff && in.groupHasGapCutoff[in.groups[k]]) overParticlesOf<true>(in, in.groups[k]);
    else overParticlesOf<false>(in, in.groups[k]);
  }
}

template<bool plane> THAW_INLINE void overSurfelsOf(const ForceSums& in) {
  constexpr int channels = plane ? planeSums : sphereSums;
  const LanesF zero(0.0f), one(1.0f), two(2.0f), half(0.5f), tiny(1e-30f), beyond(1.0001f);
  for (std::size_t k = 0; k < in.groupCount; k++) {
    const std::size_t g = in.groups[k];
    const Lanes4<float> own = load(records(in.place), in.self + 8 * g),
                        frame = load(records(in.normal), in.self + 8 * g);
    const V normal{frame.a, frame.b, frame.c};
    const LanesF reach = LanesF(in.support) * frame.d, reach2 = reach * reach, perReach2 = one / reach2,
                 range = LanesF(half.v * in.repelRange);
    LanesF weight(0.0f), height(0.0f), stiffness(0.0f), movedNearby(0.0f), coincident(0.0f);
    // mean of d, or of normals
    V mean{zero, zero, zero}, repulsion{zero, zero, zero}, square{zero, zero, zero}, mixed{zero, zero, zero};
    for (std::uint64_t n = in.firstSurfel[g]; n < in.firstSurfel[g + 1]; n++) {
      const std::uint32_t j = in.surfel[n];
      const Record<float>& x = records(in.place)[j];
      const Record<float>& f = records(in.normal)[j];
      const V d = apart(own, x), other{LanesF(f.a), LanesF(f.b), LanesF(f.c)};
      const LanesF r2 = dot(d, d), span = range * (frame.d + LanesF(f.d));
      // Because of the margin, about half of the list is out of range.
      if (!any(r2 < max(reach2, span * span * beyond))) continue;
      const LanesF sides = dot(normal, other), u = max(one - r2 * perReach2, zero);
      const auto distinct = r2 > zero;
      // A continuous weight prevents oscillating normals.
      const LanesF like = max(min((sides - LanesF(in.sameSide)) * LanesF(in.perSide), one), zero);
      const LanesF w = select(distinct, like * u * u * u, zero);
      weight += w;
      if constexpr (plane) {
        mean += w * d;
        square += w * V{d.x * d.x, d.y * d.y, d.z * d.z};
        mixed += w * V{d.x * d.y, d.y * d.z, d.x * d.z};
      } else {
        // The neighbour's normal is mirrored at the bisector plane. A sphere through both surfels with these
        // normals is its own mirror image.
        const LanesF along = dot(d, other), fold = two * along / max(r2, tiny);
        height += w * half * (dot(d, normal) + along);
        mean += w * (other - fold * d);
      }
      const LanesF near = max(span - sqrt(r2), zero);
      const LanesF push = select((sides > LanesF(in.apart)) & distinct, near, zero);
      const LanesF perR2 = span / max(two * r2, tiny);
      repulsion += (push * perR2) * d;
      stiffness += select(push > zero, half * span * perR2, zero);
      movedNearby += select(r2 < reach2, LanesF(x.d), zero);
      coincident += select(distinct, zero, one);
    }
    float* to = in.overSurfels + 8 * channels * g;
    store(to, Weight, weight);
    store(to, Height, height);
    store(to, Normal, mean);
    store(to, Repulsion, repulsion);
    store(to, Stiffness, stiffness);
    store(to, MovedNearby, movedNearby);
    store(to, Coincident, coincident);
    if constexpr (plane) {
      store(to, Moment, square);
      store(to, Moment + 3, mixed);
    }
  }
}
void overSurfels(const ForceSums& in) { in.plane ? overSurfelsOf<true>(in) : overSurfelsOf<false>(in); }

}  // namespace

void carry(const CarrySums&, std::size_t, double*);  // carry_isa.cpp
void bend(const CarrySums&, std::size_t, double*);
void areas(const AreaCells&, double*, double*);                           // areas_isa.cpp
void openPlaces(const CirclePlaces&, const float*, std::size_t, float*);  // patch_isa.cpp
bool covered(const DiscsAround&, const float*, const float*);
void betweenDiscs(const PatchPlaces&, double*);
// near_box_isa.cpp
std::uint32_t nearBox(const NearBox&, const float*, const float*, const float*, std::uint32_t,
                      std::uint32_t*);

const SurfaceKernels& surfaceKernelSet();
const SurfaceKernels& surfaceKernelSet() {
  static constexpr SurfaceKernels set{isaName, overParticles, overSurfels, carry,        bend,
                                      areas,   openPlaces,    covered,     betweenDiscs, nearBox};
  return set;
}

}  // namespace THAW_ISA
}  // namespace thaw
