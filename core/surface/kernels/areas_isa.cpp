// SPDX-License-Identifier: Apache-2.0
// Areas of Voronoi cells, eight at a time. Each bisector keeps the interval that remains after clipping by
// the other bisectors. All pairs are clipped without branches. A surfel has eight to eleven neighbours, for
// which this is faster than clipping a polygon.
#include "core/math/vec3.hpp"
#include "core/simd/lanes.hpp"
#include "core/surface/kernels/surface_kernels.hpp"

namespace thaw {
namespace THAW_ISA {
namespace {

using V = Vec3<LanesD>;

THAW_INLINE const Record<double>* records(const double* p) {
  return reinterpret_cast<const Record<double>*>(p);
}
THAW_INLINE void store(double* to, LanesD v) {
  *reinterpret_cast<Vec4d*>(to) = v.lo;
  *reinterpret_cast<Vec4d*>(to + 4) = v.hi;
}

/// Half plane n . p <= height with a unit vector n. The remaining part of its border is [from, to] along n
/// rotated to the left.
struct Line {
  LanesD x, y, height, from, to;
};

/// Clips lines a and b at each other.
THAW_INLINE void clipAt(Line& a, Line& b, LanesD& farthest2) {
  const LanesD zero(0.0), far(1e300), least(1e-300);
  const LanesD sine = a.x * b.y - a.y * b.x, cosine = a.x * b.x + a.y * b.y;
  const LanesD overA = b.height - a.height * cosine, overB = a.height - b.height * cosine;
  const auto cross = max(sine, -sine) > least;
  // coincident lines: clipAlone handles the cell
  farthest2 = select(cross, farthest2, select(max(overA, -overA) > zero, farthest2, far));
  const LanesD back = LanesD(1.0) / select(cross, sine, least);
  const LanesD atA = overA * back, atB = -(overB * back);
  // Where b turns to the left of a, a ends there and b begins.
  const auto left = back > zero;
  a.to = select(left, min(a.to, atA), a.to);
  a.from = select(left, a.from, max(a.from, atA));
  b.from = select(left, max(b.from, atB), b.from);
  b.to = select(left, b.to, min(b.to, atB));
}

}  // namespace

void areas(const AreaCells& in, double* area, double* farthest2);
void areas(const AreaCells& in, double* area, double* farthest2) {
  const LanesD zero(0.0), one(1.0), half(0.5), far(1e300), none(1e150);
  const Lanes4<double> own = load(records(in.place), in.self), frame = load(records(in.normal), in.self);
  const V x{own.a, own.b, own.c}, n{frame.a, frame.b, frame.c};
  const LanesD tiny = LanesD(1e-12) * own.d * own.d;
  // orthonormal frame of the plane (D17)
  const LanesD sign = select(n.z < zero, LanesD(-1.0), one), a = -(one / (sign + n.z)), b = n.x * n.y * a;
  const V u{one + sign * n.x * n.x * a, sign * b, -(sign * n.x)}, v{b, sign + n.y * n.y * a, -n.y};
  Line lines[mostAreaNeighbours];
  LanesD farthest = zero, sum = zero;
  for (std::size_t k = 0; k < in.count; k++) {
    const Lanes4<double> place = load(records(in.place), in.near + 8 * k),
                         other = load(records(in.normal), in.near + 8 * k);
    const V d{place.a - x.x, place.b - x.y, place.c - x.z}, m{other.a, other.b, other.c};
    const LanesD d2 = dot(d, d), cosine = dot(n, m), height = dot(d, n), flat2 = d2 - height * height;
    const auto there = (flat2 > tiny) & (cosine > LanesD(in.cosBack));
    farthest = select(there & (cosine < LanesD(in.cosFlat)), far, farthest);
    // Higher or lower neighbours belong to another layer.
    const auto cuts = there & (height * height < half * d2);
    const LanesD perFlat = one / sqrt(select(cuts, flat2, one));
    // half of the arc length between the two surfels
    const LanesD away = half * sqrt(d2) * (one + (one - cosine) * LanesD(1.0 / 12));
    lines[k] = {select(cuts, dot(d, u) * perFlat, one), select(cuts, dot(d, v) * perFlat, zero),
                select(cuts, away, none * LanesD(static_cast<double>(k + 1))), -none, none};
  }
  for (std::size_t k = 1; k < in.count; k++)
    for (std::size_t j = 0; j < k; j++) clipAt(lines[j], lines[k], farthest);
  for (std::size_t k = 0; k < in.count; k++) {
    const Line& l = lines[k];
    const auto there = (l.to > l.from) & (l.height < none);
    sum += select(there, l.height * (l.to - l.from), zero);
    store(in.turn + 8 * k, select(there, select(l.y < zero, LanesD(3.0) + l.x, one - l.x), -one));
    farthest = max(farthest, select(there, l.height * l.height + max(l.from * l.from, l.to * l.to), zero));
  }
  store(area, half * sum);
  store(farthest2, select(farthest > zero, farthest, far));
}

}  // namespace THAW_ISA
}  // namespace thaw
