// The pair interactions. Compiled once for each instruction set (core/simd/dispatch.cpp).
// d: position difference own - other in support radii; V: volumes in h^3; lengths come back with the factors in finish.
#include "core/fluid/cohesion.hpp"
#include "core/fluid/viscous_weight.hpp"
#include "core/kernels/kernels.hpp"
#include "core/neighbours/sweep.hpp"
#include "core/simd/pair_kernels.hpp"

namespace thaw {
namespace THAW_ISA {
namespace {

template<class Real> const Record<Real>* records(const void* p) { return static_cast<const Record<Real>*>(p); }
template<class L> THAW_INLINE L square(L a) { return a * a; }

/// Filling (SPH density over rest density): delta_i = sum_j V0_j W_ij / (its value on the lattice), the particle included.
template<class Real, class Kernel> struct Density {
  using L = Lanes<Real>;
  const Record<Real>* place;
  float* filling;
  std::int64_t* coincident;
  double scale;
  using Data = Lanes4<Real>;
  struct Sum { L filling = L(0.0), closest = L(1.0); };
  THAW_INLINE Data load(const std::uint32_t* rows) const { return thaw::THAW_ISA::load(place, rows); }
  THAW_INLINE void pair(const Data& i, const Data& j, const std::uint32_t*, Sum& s) const {
    const L q2 = square(positionDifference(i.a, j.a)) + square(positionDifference(i.b, j.b)) + square(positionDifference(i.c, j.c));
    s.filling += j.d * Kernel::w(q2);
    s.closest = select(j.d > L(0.0), min(s.closest, q2), s.closest);
  }
  THAW_INLINE void finish(const std::uint32_t* rows, const Data& i, const Sum& s, std::uint32_t dummy) const {
    const L total = s.filling + i.d * Kernel::w(L(0.0));
    const bool touching = any(s.closest < L(1e-20));
    for (int l = 0; l < 8; l++)
      if (rows[l] != dummy) {
        filling[rows[l]] = static_cast<float>(scale * static_cast<double>(total[l]));
        if (touching && s.closest[l] < Real(1e-20)) ++*coincident;
      }
  }
};

/// Pressure (variational: Monaghan 2005 eq. 3.3 with filling for density; or as printed in K05), viscosity (Monaghan's pair along r,
/// 2005 eq. 8.9 without its artificial scaling, or MCG03 eq. 13) and heat conduction (Cleary & Monaghan 1999 eq. 36).
/// A solid particle pushes back with the pressure of a liquid neighbour and no more (Akinci 2012): the force is the slope of the liquid's
/// energy of compression, so that nothing is gained or lost between the two. It drags on it; two solids do not see each other.
template<class Real, class Kernel, bool Laplacian, bool Heat> struct Forces {
  using L = Lanes<Real>;
  const Record<Real>*place, *motion, *state;
  const PairSums* in;
  double pressureScale, viscousScale, heatScale;
  struct Data { Lanes4<Real> place, motion, state; };
  struct Sum { L px = L(0.0), py = L(0.0), pz = L(0.0), vx = L(0.0), vy = L(0.0), vz = L(0.0), lost = L(0.0); Lanes<double> heat = Lanes<double>(0.0); };
  THAW_INLINE Data load(const std::uint32_t* rows) const {
    return {thaw::THAW_ISA::load(place, rows), thaw::THAW_ISA::load(motion, rows), thaw::THAW_ISA::load(state, rows)};
  }
  THAW_INLINE void pair(const Data& i, const Data& j, const std::uint32_t*, Sum& s) const {
    const L dx = positionDifference(i.place.a, j.place.a), dy = positionDifference(i.place.b, j.place.b), dz = positionDifference(i.place.c, j.place.c);
    const L q2 = dx * dx + dy * dy + dz * dz;
    const L Vj = j.place.d;
    const L slope = Kernel::slope(q2);
    const L fi = i.state.b, fj = j.state.b;
    const L pressure = Vj * slope * (i.state.a + j.state.a);
    s.px -= pressure * dx;
    s.py -= pressure * dy;
    s.pz -= pressure * dz;
    const L ux = i.motion.a - j.motion.a, uy = i.motion.b - j.motion.b, uz = i.motion.c - j.motion.c;
    const L wet = fi + fj - fi * fj;
    const L mui = i.motion.d, muj = j.motion.d;
    if constexpr (Laplacian) {
      const L mu = L(0.5) * (mui + muj) * wet * Vj * Kernel::laplace(q2);
      s.vx -= mu * ux;
      s.vy -= mu * uy;
      s.vz -= mu * uz;
      s.lost += mu * (ux * ux + uy * uy + uz * uz);
    } else {
      const L mean = L(2.0) * mui * muj / max(mui + muj, L(1e-30));
      const L approach = ux * dx + uy * dy + uz * dz;
      const L mu = wet * mean * Vj * alongPair(q2) * approach / (q2 + L(1e-6));
      s.vx -= mu * dx;
      s.vy -= mu * dy;
      s.vz -= mu * dz;
      s.lost += mu * approach;
    }
    if constexpr (Heat) {
      const L ki = i.state.d, kj = j.state.d;
      const L k = L(2.0) * ki * kj / max(ki + kj, L(1e-30));
      // the same for j but for its sign, to the last bit; summed in double precision so that no heat is lost to rounding
      s.heat += widen(i.place.d * Vj * k * Kernel::laplace(q2) * (j.state.c - i.state.c));
    }
  }
  THAW_INLINE void finish(const std::uint32_t* rows, const Data& i, const Sum& s, std::uint32_t dummy) const {
    for (int l = 0; l < 8; l++)
      if (rows[l] != dummy) {
        const double V = static_cast<double>(i.place.d[l]), p = V * pressureScale, v = V * viscousScale;
        Vec3d& f = in->force[rows[l]];
        f.x += p * static_cast<double>(s.px[l]) + v * static_cast<double>(s.vx[l]);
        f.y += p * static_cast<double>(s.py[l]) + v * static_cast<double>(s.vy[l]);
        f.z += p * static_cast<double>(s.pz[l]) + v * static_cast<double>(s.vz[l]);
        in->dissipation[rows[l]] += 0.5 * v * static_cast<double>(s.lost[l]);
        if constexpr (Heat) in->heatFlow[rows[l]] += heatScale * s.heat[l];
      }
  }
};

/// Surface tension (cohesion.hpp).
template<class Real> struct Tension {
  using L = Lanes<Real>;
  const Record<Real>*place, *surface;
  const PairSums* in;
  double scale;  // 8 / (pi moment4), and units in finish
  struct Data { Lanes4<Real> place, surface; };
  struct Sum { L x = L(0.0), y = L(0.0), z = L(0.0), energy = L(0.0); };
  THAW_INLINE Data load(const std::uint32_t* rows) const { return {thaw::THAW_ISA::load(place, rows), thaw::THAW_ISA::load(surface, rows)}; }
  THAW_INLINE void pair(const Data& i, const Data& j, const std::uint32_t*, Sum& s) const {
    const L dx = positionDifference(i.place.a, j.place.a), dy = positionDifference(i.place.b, j.place.b), dz = positionDifference(i.place.c, j.place.c);
    const L q = min(sqrt(dx * dx + dy * dy + dz * dz), L(1.0));
    const L strength = j.place.d * j.surface.a;
    const L f = strength * Cohesion::force(q) / max(q, L(1e-6));
    s.x -= f * dx;
    s.y -= f * dy;
    s.z -= f * dz;
    s.energy += strength * Cohesion::potential(q);
  }
  THAW_INLINE void finish(const std::uint32_t* rows, const Data& i, const Sum& s, std::uint32_t dummy) const {
    for (int l = 0; l < 8; l++)
      if (rows[l] != dummy) {
        const double own = scale * static_cast<double>(i.place.d[l]) * static_cast<double>(i.surface.a[l]);
        Vec3d& f = in->force[rows[l]];
        f.x += own * in->support * static_cast<double>(s.x[l]);
        f.y += own * in->support * static_cast<double>(s.y[l]);
        f.z += own * in->support * static_cast<double>(s.z[l]);
        in->interaction[rows[l]] += 0.5 * own * in->support * in->support * static_cast<double>(s.energy[l]);
      }
  }
};

/// Surface tension of the colour field as printed in K05 / MCG03: -k lap(c) n / |n| where |n| is above a threshold. Does not
/// obey Laplace's law under refinement (accuracy.md section 0.3): a named choice.
template<class Real> struct ColourField {
  using L = Lanes<Real>;
  const Record<Real>*place, *surface, *state;
  const PairSums* in;
  struct Data { Lanes4<Real> place, surface, state; };
  struct Sum { L x = L(0.0), y = L(0.0), z = L(0.0), laplacian = L(0.0); };
  THAW_INLINE Data load(const std::uint32_t* rows) const {
    return {thaw::THAW_ISA::load(place, rows), thaw::THAW_ISA::load(surface, rows), thaw::THAW_ISA::load(state, rows)};
  }
  THAW_INLINE void pair(const Data& i, const Data& j, const std::uint32_t*, Sum& s) const {
    const L dx = positionDifference(i.place.a, j.place.a), dy = positionDifference(i.place.b, j.place.b), dz = positionDifference(i.place.c, j.place.c);
    const L q2 = dx * dx + dy * dy + dz * dz, u = max(L(1.0) - q2, L(0.0));
    const L c = L(-945 / (32 * pi)) * j.place.d * u;  // poly6 by differentiation
    s.x += c * u * dx;
    s.y += c * u * dy;
    s.z += c * u * dz;
    s.laplacian += c * (L(3.0) - L(7.0) * q2);
  }
  THAW_INLINE void finish(const std::uint32_t* rows, const Data& i, const Sum& s, std::uint32_t dummy) const {
    for (int l = 0; l < 8; l++)
      if (rows[l] != dummy) {
        const double h = in->support, V = static_cast<double>(i.place.d[l]) * h * h * h, root = static_cast<double>(i.surface.a[l]);
        const Vec3d n{static_cast<double>(s.x[l]), static_cast<double>(s.y[l]), static_cast<double>(s.z[l])};
        const double size = __builtin_sqrt(n.x * n.x + n.y * n.y + n.z * n.z);
        if (size < 0.3) continue;  // |n| h: inside, noise (accuracy.md B24)
        const double laplacian = static_cast<double>(s.laplacian[l]) - 945 / (32 * pi) * 3 * static_cast<double>(i.place.d[l]);
        const double k = -root * root * laplacian / (h * h) * V / size;
        Vec3d& f = in->force[rows[l]];
        f.x += k * n.x;
        f.y += k * n.y;
        f.z += k * n.z;
      }
  }
};

/// Artificial viscosity (Monaghan 1992): acts on approaching pairs only; record: alpha c h rho / 10.
template<class Real, class Kernel> struct Artificial {
  using L = Lanes<Real>;
  const Record<Real>*place, *motion, *surface;
  const PairSums* in;
  double scale;
  struct Data { Lanes4<Real> place, motion, surface; };
  struct Sum { L x = L(0.0), y = L(0.0), z = L(0.0), lost = L(0.0); };
  THAW_INLINE Data load(const std::uint32_t* rows) const {
    return {thaw::THAW_ISA::load(place, rows), thaw::THAW_ISA::load(motion, rows), thaw::THAW_ISA::load(surface, rows)};
  }
  THAW_INLINE void pair(const Data& i, const Data& j, const std::uint32_t*, Sum& s) const {
    const L dx = positionDifference(i.place.a, j.place.a), dy = positionDifference(i.place.b, j.place.b), dz = positionDifference(i.place.c, j.place.c);
    const L q2 = dx * dx + dy * dy + dz * dz;
    const L approach = min((i.motion.a - j.motion.a) * dx + (i.motion.b - j.motion.b) * dy + (i.motion.c - j.motion.c) * dz, L(0.0));
    const L mean = L(2.0) * i.surface.c * j.surface.c / max(i.surface.c + j.surface.c, L(1e-30));
    const L mu = mean * j.place.d * Kernel::slope(q2) * approach / (q2 + L(0.01));
    s.x += mu * dx;
    s.y += mu * dy;
    s.z += mu * dz;
    s.lost -= mu * approach;
  }
  THAW_INLINE void finish(const std::uint32_t* rows, const Data& i, const Sum& s, std::uint32_t dummy) const {
    for (int l = 0; l < 8; l++)
      if (rows[l] != dummy) {
        const double v = scale * static_cast<double>(i.place.d[l]);
        Vec3d& f = in->force[rows[l]];
        f.x += v * static_cast<double>(s.x[l]);
        f.y += v * static_cast<double>(s.y[l]);
        f.z += v * static_cast<double>(s.z[l]);
        in->dissipation[rows[l]] += 0.5 * v * static_cast<double>(s.lost[l]);
      }
  }
};

/// XSPH (Monaghan 1989): velocity of the flow around a liquid particle, less its own, times epsilon.
template<class Real, class Kernel> struct Smoothing {
  using L = Lanes<Real>;
  const Record<Real>*place, *motion, *surface;
  const PairSums* in;
  struct Data { Lanes4<Real> place, motion, surface; };
  struct Sum { L x = L(0.0), y = L(0.0), z = L(0.0); };
  THAW_INLINE Data load(const std::uint32_t* rows) const {
    return {thaw::THAW_ISA::load(place, rows), thaw::THAW_ISA::load(motion, rows), thaw::THAW_ISA::load(surface, rows)};
  }
  THAW_INLINE void pair(const Data& i, const Data& j, const std::uint32_t*, Sum& s) const {
    const L dx = positionDifference(i.place.a, j.place.a), dy = positionDifference(i.place.b, j.place.b), dz = positionDifference(i.place.c, j.place.c);
    const L w = min(i.surface.d, j.surface.d) * j.place.d * Kernel::w(dx * dx + dy * dy + dz * dz);
    s.x -= w * (i.motion.a - j.motion.a);
    s.y -= w * (i.motion.b - j.motion.b);
    s.z -= w * (i.motion.c - j.motion.c);
  }
  THAW_INLINE void finish(const std::uint32_t* rows, const Data&, const Sum& s, std::uint32_t dummy) const {
    for (int l = 0; l < 8; l++)
      if (rows[l] != dummy) in->smoothed[rows[l]] = {static_cast<double>(s.x[l]), static_cast<double>(s.y[l]), static_cast<double>(s.z[l])};
  }
};

/// Share of a particle in the free surface: |grad c| times a length such that a column of particles below a flat surface adds up to 1.
template<class Real, class Kernel> struct Exposure {
  using L = Lanes<Real>;
  const Record<Real>* place;
  const PairSums* in;
  using Data = Lanes4<Real>;
  struct Sum { L x = L(0.0), y = L(0.0), z = L(0.0); };
  THAW_INLINE Data load(const std::uint32_t* rows) const { return thaw::THAW_ISA::load(place, rows); }
  THAW_INLINE void pair(const Data& i, const Data& j, const std::uint32_t*, Sum& s) const {
    const L dx = positionDifference(i.a, j.a), dy = positionDifference(i.b, j.b), dz = positionDifference(i.c, j.c);
    const L g = j.d * Kernel::slope(dx * dx + dy * dy + dz * dz);
    s.x += g * dx;
    s.y += g * dy;
    s.z += g * dz;
  }
  THAW_INLINE void finish(const std::uint32_t* rows, const Data&, const Sum& s, std::uint32_t dummy) const {
    const L size = sqrt(s.x * s.x + s.y * s.y + s.z * s.z);
    for (int l = 0; l < 8; l++)
      if (rows[l] != dummy) in->exposure[rows[l]] = static_cast<float>(static_cast<double>(size[l]) * in->exposureScale / in->support);
  }
};

/// Pairs of solid particles closer than the contact distance: rare, so they are listed and worked on one by one.
template<class Real> struct Close {
  using L = Lanes<Real>;
  const Record<Real>*place, *surface;
  ClosePairs* pairs;
  L limit2;
  struct Data { Lanes4<Real> place, surface; const std::uint32_t* rows; };
  struct Sum {};
  THAW_INLINE Data load(const std::uint32_t* rows) const { return {thaw::THAW_ISA::load(place, rows), thaw::THAW_ISA::load(surface, rows), rows}; }
  THAW_INLINE void pair(const Data& i, const Data& j, const std::uint32_t* at, Sum&) const {
    const L dx = positionDifference(i.place.a, j.place.a), dy = positionDifference(i.place.b, j.place.b), dz = positionDifference(i.place.c, j.place.c);
    const auto m = (dx * dx + dy * dy + dz * dz < limit2) & (i.surface.b * j.surface.b > L(0.0));
    if (any(m))
      for (int l = 0; l < 8; l++)
        if (laneOf(m, l)) ClosePairs::append(*pairs, i.rows[l], at[l]);
  }
  THAW_INLINE void finish(const std::uint32_t*, const Data&, const Sum&, std::uint32_t) const {}
};

/// Calls action with the kernel and the precision of the scene as types.
template<class Action> void choose(const PairSums& in, Action action) {
  const auto withReal = [&](auto real) {
    using Real = decltype(real);
    switch (in.kernel) {
      case KernelKind::WendlandC2: action(Real{}, WendlandC2{}); break;
      case KernelKind::Mcg03: action(Real{}, Mcg03{}); break;
      case KernelKind::CubicSpline: action(Real{}, CubicSpline{}); break;
    }
  };
  if (in.precision == Precision::Single) withReal(float{});
  else withReal(double{});
}

void density(const PairSums& in, GroupRange range) {
  choose(in, [&](auto real, auto kernel) {
    using Real = decltype(real);
    Density<Real, decltype(kernel)> term{records<Real>(in.place), in.filling, in.coincident, in.fillingScale * in.support * in.support * in.support};
    sweep(*in.lists, range, term, true);
  });
}

template<bool Laplacian, bool Heat> void forcesOf(const PairSums& in, GroupRange range) {
  choose(in, [&](auto real, auto kernel) {
    using Real = decltype(real);
    const double h = in.support;
    const double pressure = in.pressureForm == PairForm::Printed ? 0.5 : in.fillingScale * h * h * h;
    Forces<Real, decltype(kernel), Laplacian, Heat> term{records<Real>(in.place), records<Real>(in.motion), records<Real>(in.state), &in, pressure * h * h,
                                                         h, h};
    sweep(*in.lists, range, term, !Heat);
  });
}
void forces(const PairSums& in, GroupRange range) {
  const bool laplacian = in.viscosityForm == ViscosityForm::Laplacian;
  if (in.heat) laplacian ? forcesOf<true, true>(in, range) : forcesOf<false, true>(in, range);
  else laplacian ? forcesOf<true, false>(in, range) : forcesOf<false, false>(in, range);
}

template<class Real> void tensionOf(const PairSums& in, GroupRange range, bool colour) {
  if (colour) {
    ColourField<Real> term{records<Real>(in.place), records<Real>(in.surface), records<Real>(in.state), &in};
    sweep(*in.lists, range, term, true);
  } else {
    Tension<Real> term{records<Real>(in.place), records<Real>(in.surface), &in, Cohesion::scale};
    sweep(*in.lists, range, term, true);
  }
}
void tension(const PairSums& in, GroupRange range) {
  in.precision == Precision::Single ? tensionOf<float>(in, range, in.printedTension) : tensionOf<double>(in, range, in.printedTension);
}

void artificialViscosity(const PairSums& in, GroupRange range) {
  choose(in, [&](auto real, auto kernel) {
    using Real = decltype(real);
    Artificial<Real, decltype(kernel)> term{records<Real>(in.place), records<Real>(in.motion), records<Real>(in.surface), &in, 10 * in.support};
    sweep(*in.lists, range, term, true);
  });
}

void smoothing(const PairSums& in, GroupRange range) {
  choose(in, [&](auto real, auto kernel) {
    using Real = decltype(real);
    Smoothing<Real, decltype(kernel)> term{records<Real>(in.place), records<Real>(in.motion), records<Real>(in.surface), &in};
    sweep(*in.lists, range, term, false);
  });
}

void exposure(const PairSums& in, GroupRange range) {
  choose(in, [&](auto real, auto kernel) {
    using Real = decltype(real);
    Exposure<Real, decltype(kernel)> term{records<Real>(in.place), &in};
    sweep(*in.lists, range, term, false);
  });
}

template<class Real> void closePairsOf(const PairSums& in, GroupRange range, ClosePairs& pairs) {
  Close<Real> term{records<Real>(in.place), records<Real>(in.surface), &pairs, Lanes<Real>(in.closeDistance * in.closeDistance)};
  sweep(*in.lists, range, term, false);
}
void closePairs(const PairSums& in, GroupRange range, ClosePairs& pairs) {
  in.precision == Precision::Single ? closePairsOf<float>(in, range, pairs) : closePairsOf<double>(in, range, pairs);
}

#define THAW_STRING_(x) #x
#define THAW_STRING(x) THAW_STRING_(x)

}  // namespace

void searchNeighbours(const SearchInput&, Part, SearchBuffers&, NeighbourLists&);  // search_isa.cpp

const PairKernels& pairKernelSet();
const PairKernels& pairKernelSet() {
  static constexpr PairKernels set{THAW_STRING(THAW_ISA) + 4, searchNeighbours, density,  forces,    tension,
                                   artificialViscosity,       smoothing,        exposure, closePairs};
  return set;
}

}  // namespace THAW_ISA
}  // namespace thaw
