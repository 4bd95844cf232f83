// The pair sums of one instruction set (compiled once for each, core/simd/dispatch.cpp): each term of core/fluid/terms/ with the kernel and
// the precision of the scene.
#include "core/fluid/terms/artificial_viscosity.hpp"
#include "core/fluid/terms/close_pairs.hpp"
#include "core/fluid/terms/colour_field.hpp"
#include "core/fluid/terms/density.hpp"
#include "core/fluid/terms/exposure.hpp"
#include "core/fluid/terms/forces.hpp"
#include "core/fluid/terms/incompressible.hpp"
#include "core/fluid/terms/smoothing.hpp"
#include "core/fluid/terms/tension.hpp"

namespace thaw {
namespace THAW_ISA {
namespace {

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

void compression(const PairSums& in, GroupRange range) {
  choose(in, [&](auto real, auto kernel) {
    using Real = decltype(real);
    const double h = in.support;
    Compression<Real, decltype(kernel)> term{records<Real>(in.place), records<Real>(in.motion), in.compression, in.fillingScale * h * h};
    sweep(*in.lists, range, term, true);
  });
}

void impulse(const PairSums& in, GroupRange range) {
  choose(in, [&](auto real, auto kernel) {
    using Real = decltype(real);
    const double h = in.support;
    Impulse<Real, decltype(kernel)> term{records<Real>(in.place), records<Real>(in.state), in.impulse, in.fillingScale * h * h * h * h * h};
    sweep(*in.lists, range, term, true);
  });
}

void response(const PairSums& in, GroupRange range) {
  choose(in, [&](auto real, auto kernel) {
    using Real = decltype(real);
    const double h = in.support;
    Response<Real, decltype(kernel)> term{records<Real>(in.place), records<Real>(in.state), in.impulse, in.compression, in.fillingScale * h * h};
    sweep(*in.lists, range, term, true);
  });
}

#define THAW_STRING_(x) #x
#define THAW_STRING(x) THAW_STRING_(x)

}  // namespace

void searchNeighbours(const SearchInput&, Part, SearchBuffers&, NeighbourLists&);  // search_isa.cpp

const PairKernels& pairKernelSet();
const PairKernels& pairKernelSet() {
  static constexpr PairKernels set{THAW_STRING(THAW_ISA) + 4, searchNeighbours, density,  forces,    tension,
                                   artificialViscosity,       smoothing,        exposure, closePairs, compression, impulse, response};
  return set;
}

}  // namespace THAW_ISA
}  // namespace thaw
