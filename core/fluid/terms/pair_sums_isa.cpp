// SPDX-License-Identifier: Apache-2.0
// The pair sums, compiled once per instruction set (core/fluid/pair_sums/dispatch.cpp): each term of
// core/fluid/terms/ with the kernel and precision of the scene.
#include <type_traits>

#include "core/fluid/terms/artificial_viscosity.hpp"
#include "core/fluid/terms/carried_density.hpp"
#include "core/fluid/terms/choose_types.hpp"
#include "core/fluid/terms/close_pairs.hpp"
#include "core/fluid/terms/colour_field.hpp"
#include "core/fluid/terms/conduction.hpp"
#include "core/fluid/terms/density.hpp"
#include "core/fluid/terms/forces.hpp"
#include "core/fluid/terms/free_surface_indicator.hpp"
#include "core/fluid/terms/incompressible.hpp"
#include "core/fluid/terms/smoothing.hpp"
#include "core/fluid/terms/surface_energy.hpp"
#include "core/fluid/terms/tension.hpp"
#include "core/fluid/terms/uniform_forces.hpp"
#include "core/fluid/terms/viscosity_correction.hpp"
#include "core/fluid/terms/viscous_operator.hpp"
#include "core/simd/isa_name.hpp"

namespace thaw {
namespace THAW_ISA {
namespace {

template<class Real, class Kernel> void carriedDensity(const PairSums& in, GroupRange range, double scale) {
  using L = Lanes<Real>;
  const CarryStep& x = *in.carry;
  const double c = x.liquids[0].soundSpeed;
  const Vec3d down = in.uniform ? x.weight * (1 / (c * c)) : x.weight;
  const auto sum = [&]<Carry carry, bool Surfaces, Mix mix>() {
    CarriedDensity<Real, Kernel, carry, Surfaces, mix> term{records<Real>(in.positionVolume),
                                                            records<Real>(in.velocityViscosity),
                                                            records<Real>(in.pressurePhaseHeat),
                                                            &in,
                                                            scale,
                                                            {L(down.x), L(down.y), L(down.z)}};
    sweep(*in.lists, range, term, Groups::Fluid);
  };
  const auto withSurfaces = [&]<Carry carry, Mix mix>() {
    if (x.surfaces) sum.template operator()<carry, true, mix>();
    else sum.template operator()<carry, false, mix>();
  };
  if (!x.corrected) return withSurfaces.template operator()<Carry::Density, Mix::Solids>();
  if constexpr (std::is_same_v<Kernel, WendlandC2>) {  // the default kernel
    if (in.uniform) return withSurfaces.template operator()<Carry::Corrected, Mix::One>();
    if (!x.solids) return withSurfaces.template operator()<Carry::Corrected, Mix::Liquids>();
  }
  withSurfaces.template operator()<Carry::Corrected, Mix::Solids>();
}

void density(const PairSums& in, GroupRange range) {
  chooseTypes(in, [&](auto real, auto kernel) {
    using Real = decltype(real);
    const double scale = in.relativeDensityScale * in.support * in.support * in.support;
    if (in.carried) return carriedDensity<Real, decltype(kernel)>(in, range, scale);
    if (in.concentrationGradient) {
      CarriedDensity<Real, decltype(kernel), Carry::Nothing> term{
          records<Real>(in.positionVolume),
          nullptr,
          nullptr,
          &in,
          scale,
          {Lanes<Real>(0.0), Lanes<Real>(0.0), Lanes<Real>(0.0)}};
      return sweep(*in.lists, range, term, Groups::Fluid);
    }
    Density<Real, decltype(kernel)> term{records<Real>(in.positionVolume), in.relativeDensity, in.coincident,
                                         in.relativeDensityScale * in.support * in.support * in.support,
                                         in.selfExcess};
    sweep(*in.lists, range, term, Groups::Fluid);
  });
}

template<bool Viscous, bool Laplacian, bool Heat, bool Carried, bool Relief = false>
void forcesIn(const PairSums& in, GroupRange range) {
  chooseTypes(in, [&](auto real, auto kernel) {
    using Real = decltype(real);
    const double h = in.support;
    const double pressure = in.pressureForm == PairForm::Printed ? 0.5 : in.relativeDensityScale * h * h * h;
    Forces<Real, decltype(kernel), Viscous, Laplacian, Heat, Carried, Relief> term{
        records<Real>(in.positionVolume),
        records<Real>(in.velocityViscosity),
        records<Real>(in.pressurePhaseHeat),
        records<Real>(in.pressureDiagonal),
        records<Real>(in.pressureOffDiagonal),
        &in,
        Lanes<Real>(pressure * h * h),
        Lanes<Real>(h / lengthUnit<Real>),
        Lanes<Real>(in.viscousWeight.scale),
        in.conductionScale * h,
        Lanes<Real>(in.relativeDensityScale * h * h * h / lengthUnit<Real>),
        Lanes<Real>(lengthUnit<Real> / h)};
    sweep(*in.lists, range, term, Groups::Fluid);
    if constexpr (Heat) {
      Conduction<Real, decltype(kernel)> nonFluid{
          records<Real>(in.positionVolume), records<Real>(in.pressurePhaseHeat), &in, in.conductionScale * h};
      sweep(*in.lists, range, nonFluid, Groups::NonFluid);
    }
  });
}
template<bool Viscous, bool Laplacian, bool Heat> void forcesOf(const PairSums& in, GroupRange range) {
  if (in.relief) return forcesIn<Viscous, Laplacian, Heat, true, true>(in, range);
  in.carried ? forcesIn<Viscous, Laplacian, Heat, true>(in, range)
             : forcesIn<Viscous, Laplacian, Heat, false>(in, range);
}
template<class Real, bool Heat, bool Shocks, bool Carried = false>
void uniformOf(const PairSums& in, GroupRange range) {
  using L = Lanes<Real>;
  const double h = in.support;
  const double pressure = in.pressureForm == PairForm::Printed ? 0.5 : in.relativeDensityScale * h * h * h;
  const auto mean = [](double value) {  // pair mean of two equal values, rounded as for any pair
    const L v = L(static_cast<Real>(value));
    return L(2.0) * v * v / max(v + v, L(1e-30));
  };
  UniformForces<Real, WendlandC2, Heat, Shocks, Carried> term{records<Real>(in.positionVolume),
                                                              records<Real>(in.velocityViscosity),
                                                              records<Real>(in.pressureDiagonal),
                                                              &in,
                                                              L(pressure * h * h),
                                                              L(h / lengthUnit<Real>),
                                                              L(in.viscousWeight.scale),
                                                              mean(in.viscosity),
                                                              mean(in.conductivity),
                                                              mean(in.artificial),
                                                              L(in.volume),
                                                              in.conductionScale * h,
                                                              10 * h};
  sweep(*in.lists, range, term, Heat ? Groups::All : Groups::Fluid);
}
template<class Real> void uniform(const PairSums& in, GroupRange range) {
  if (in.carried)
    return in.artificial > 0 ? uniformOf<Real, false, true, true>(in, range)
                             : uniformOf<Real, false, false, true>(in, range);
  if (in.artificial > 0)
    in.heat ? uniformOf<Real, true, true>(in, range) : uniformOf<Real, false, true>(in, range);
  else in.heat ? uniformOf<Real, true, false>(in, range) : uniformOf<Real, false, false>(in, range);
}
void forces(const PairSums& in, GroupRange range) {
  if (in.uniform)
    return in.precision == Precision::Single ? uniform<float>(in, range) : uniform<double>(in, range);
  const bool laplacian = in.viscosityForm == ViscosityForm::Laplacian;
  if (!in.viscous)
    in.heat ? forcesOf<false, false, true>(in, range) : forcesOf<false, false, false>(in, range);
  else if (in.heat)
    laplacian ? forcesOf<true, true, true>(in, range) : forcesOf<true, false, true>(in, range);
  else laplacian ? forcesOf<true, true, false>(in, range) : forcesOf<true, false, false>(in, range);
}

void viscosityCorrection(const PairSums& in, GroupRange range) {
  chooseTypes(in, [&](auto real, auto kernel) {
    using Real = decltype(real);
    ViscosityCorrection<Real, decltype(kernel)> term{
        records<Real>(in.positionVolume),    records<Real>(in.velocityViscosity),
        records<Real>(in.pressurePhaseHeat), &in,
        Lanes<Real>(in.viscousWeight.scale), in.relativeDensityScale * in.support * in.support * in.support};
    sweep(*in.lists, range, term, Groups::Fluid);
  });
}

template<class Real, ViscousPass pass>
void viscousOf(const PairSums& in, const ViscousSums& out, GroupRange range) {
  const auto velocities = [](const ViscousRecord* r) { return reinterpret_cast<const Record<double>*>(r); };
  ViscousOperator<Real, pass> term{
      records<Real>(in.positionVolume),   velocities(out.velocity), velocities(out.middle), &out, in.support,
      Lanes<Real>(in.viscousWeight.scale)};
  sweep(*in.lists, range, term, Groups::Fluid);
}
template<class Real> void viscousPass(const PairSums& in, const ViscousSums& out, GroupRange range) {
  switch (out.pass) {
    case ViscousPass::Start: viscousOf<Real, ViscousPass::Start>(in, out, range); break;
    case ViscousPass::Apply: viscousOf<Real, ViscousPass::Apply>(in, out, range); break;
    case ViscousPass::Force: viscousOf<Real, ViscousPass::Force>(in, out, range); break;
  }
}
void viscous(const PairSums& in, const ViscousSums& out, GroupRange range) {
  in.precision == Precision::Single ? viscousPass<float>(in, out, range)
                                    : viscousPass<double>(in, out, range);
}

template<class Real> void tensionOf(const PairSums& in, GroupRange range, bool colour) {
  if (colour) {
    ColourField<Real> term{records<Real>(in.positionVolume), records<Real>(in.surface),
                           records<Real>(in.pressurePhaseHeat), &in};
    sweep(*in.lists, range, term, Groups::Fluid);
  } else {
    Tension<Real> term{records<Real>(in.positionVolume), records<Real>(in.surface), &in, Cohesion::scale};
    sweep(*in.lists, range, term, Groups::Fluid);
  }
}
void tension(const PairSums& in, GroupRange range) {
  in.precision == Precision::Single ? tensionOf<float>(in, range, in.printedTension)
                                    : tensionOf<double>(in, range, in.printedTension);
}

template<class Real> void surfaceSeenOf(const PairSums& in, GroupRange range) {
  SurfaceColour<Real> term{records<Real>(in.positionVolume), &in};
  sweep(*in.lists, range, term, Groups::Fluid);
}
void surfaceColours(const PairSums& in, GroupRange range) {
  in.precision == Precision::Single ? surfaceSeenOf<float>(in, range) : surfaceSeenOf<double>(in, range);
}

template<class Real> void surfaceForcesOf(const PairSums& in, GroupRange range) {
  SurfaceForces<Real> term{records<Real>(in.positionVolume), records<Real>(in.surfaceEnergyDerivatives), &in,
                           in.support * in.support};
  sweep(*in.lists, range, term, Groups::Fluid);
}
void surfaceForces(const PairSums& in, GroupRange range) {
  in.precision == Precision::Single ? surfaceForcesOf<float>(in, range) : surfaceForcesOf<double>(in, range);
}

void artificialViscosity(const PairSums& in, GroupRange range) {
  chooseTypes(in, [&](auto real, auto kernel) {
    using Real = decltype(real);
    Artificial<Real, decltype(kernel)> term{records<Real>(in.positionVolume),
                                            records<Real>(in.velocityViscosity), records<Real>(in.surface),
                                            &in, 10 * in.support};
    sweep(*in.lists, range, term, Groups::Fluid);
  });
}

void smoothing(const PairSums& in, GroupRange range) {
  chooseTypes(in, [&](auto real, auto kernel) {
    using Real = decltype(real);
    Smoothing<Real, decltype(kernel)> term{records<Real>(in.positionVolume),
                                           records<Real>(in.velocityViscosity), records<Real>(in.surface),
                                           &in};
    sweep(*in.lists, range, term, Groups::All);
  });
}

void freeSurfaceIndicator(const PairSums& in, GroupRange range) {
  chooseTypes(in, [&](auto real, auto kernel) {
    using Real = decltype(real);
    FreeSurfaceIndicator<Real, decltype(kernel)> term{records<Real>(in.positionVolume), &in};
    sweep(*in.lists, range, term, Groups::All);
  });
}

template<class Real> void closePairsOf(const PairSums& in, GroupRange range, ClosePairs& pairs) {
  Close<Real> term{records<Real>(in.positionVolume), records<Real>(in.surface), &pairs,
                   Lanes<Real>(in.closeDistance * in.closeDistance)};
  sweep(*in.lists, range, term, Groups::All);
}
void closePairs(const PairSums& in, GroupRange range, ClosePairs& pairs) {
  in.precision == Precision::Single ? closePairsOf<float>(in, range, pairs)
                                    : closePairsOf<double>(in, range, pairs);
}

template<bool Corrected> void compressionOf(const PairSums& in, GroupRange range) {
  chooseTypes(in, [&](auto real, auto kernel) {
    using Real = decltype(real);
    const double h = in.support;
    Compression<Real, decltype(kernel), Corrected> term{records<Real>(in.positionVolume),
                                                        records<Real>(in.velocityViscosity), in.correction,
                                                        in.compression, in.relativeDensityScale * h * h};
    sweep(*in.lists, range, term, Groups::Fluid);
  });
}
void compression(const PairSums& in, GroupRange range) {
  in.correction ? compressionOf<true>(in, range) : compressionOf<false>(in, range);
}

template<bool Corrected> void impulseOf(const PairSums& in, GroupRange range) {
  chooseTypes(in, [&](auto real, auto kernel) {
    using Real = decltype(real);
    const double h = in.support;
    Impulse<Real, decltype(kernel), Corrected> term{
        records<Real>(in.positionVolume),
        records<Real>(Corrected ? in.pressureDiagonal : in.pressurePhaseHeat),
        records<Real>(in.pressureOffDiagonal), in.impulse, in.relativeDensityScale * h * h * h * h * h};
    sweep(*in.lists, range, term, Groups::Fluid);
  });
}
void impulse(const PairSums& in, GroupRange range) {
  in.correction ? impulseOf<true>(in, range) : impulseOf<false>(in, range);
}

void response(const PairSums& in, GroupRange range) {
  chooseTypes(in, [&](auto real, auto kernel) {
    using Real = decltype(real);
    Response<Real, decltype(kernel)> term{records<Real>(in.positionVolume),
                                          records<Real>(in.pressurePhaseHeat), &in};
    sweep(*in.lists, range, term, Groups::Fluid);
  });
}

}  // namespace

void searchNeighbours(const SearchInput&, Part, SearchBuffers&, NeighbourLists&);  // search_isa.cpp

const PairKernels& pairKernelSet();
const PairKernels& pairKernelSet() {
  static constexpr PairKernels set{isaName,   searchNeighbours,     density,       forces,
                                   tension,   surfaceColours,       surfaceForces, artificialViscosity,
                                   smoothing, freeSurfaceIndicator, closePairs,    viscosityCorrection,
                                   viscous,   compression,          impulse,       response};
  return set;
}

}  // namespace THAW_ISA
}  // namespace thaw
