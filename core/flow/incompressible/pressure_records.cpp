// SPDX-License-Identifier: Apache-2.0
#include "core/flow/incompressible/pressure_records.hpp"

namespace thaw {
namespace {

template<class Real> struct Four { Real a, b, c, d; };

template<class Real> Four<Real>* rows(AlignedVector<std::byte>& bytes) {
  return reinterpret_cast<Four<Real>*>(bytes.data());
}

/// Calls action with the precision of the records.
template<class Action> void withReal(const RecordContext& x, Action action) {
  x.scene.numerics.precision == Precision::Double ? action(double{}) : action(float{});
}

}  // namespace

void packMobility(const RecordContext& x, const Continuum& p, std::size_t n, PairRecords& r) {
  withReal(x, [&](auto real) {
    using Real = decltype(real);
    for (std::size_t i = 0; i < n; i++)
      rows<Real>(r.pressurePhaseHeat)[i].c = p.clamped.active && p.clamped[i]
                                                 ? Real(0)
                                                 : static_cast<Real>(1 / p.mass[i]);
  });
}

void packTrialPressure(const RecordContext& x, const Continuum& p, std::size_t begin, std::size_t end,
                       PairRecords& r) {
  withReal(x, [&](auto real) {
    using Real = decltype(real);
    for (std::size_t i = begin; i < end; i++)
      rows<Real>(r.pressurePhaseHeat)[i].a = static_cast<Real>(p.trialPressure[i]);
    if (!x.scene.numerics.correctedGradients) return;
    for (std::size_t i = begin; i < end; i++) {
      const double k = static_cast<double>(p.trialPressure[i]);
      const Sym3f& d = p.correction[i];
      const auto times = [k](double a) { return static_cast<Real>(k * a); };
      const auto diagonal = [&](float a) { return times(1 + static_cast<double>(a)); };
      const auto off = [&](float a) { return times(static_cast<double>(a)); };
      rows<Real>(r.pressureDiagonal)[i] = {diagonal(d.xx), diagonal(d.yy), diagonal(d.zz), Real(0)};
      rows<Real>(r.pressureOffDiagonal)[i] = {off(d.xy), off(d.xz), off(d.yz), Real(0)};
    }
  });
}

void packTrialVelocity(const RecordContext& x, const Continuum& p, std::size_t begin, std::size_t end,
                       PairRecords& r) {
  withReal(x, [&](auto real) {
    using Real = decltype(real);
    for (std::size_t i = begin; i < end; i++) {
      Four<Real>& m = rows<Real>(r.velocityViscosity)[i];
      const Vec3d& v = p.trialVelocity[i];
      m.a = static_cast<Real>(v.x), m.b = static_cast<Real>(v.y), m.c = static_cast<Real>(v.z);
    }
  });
}

float packedFraction(const RecordContext& x, const PairRecords& r, std::size_t row) {
  return x.scene.numerics.precision == Precision::Double
             ? static_cast<float>(reinterpret_cast<const Four<double>*>(r.pressurePhaseHeat.data())[row].b)
             : reinterpret_cast<const Four<float>*>(r.pressurePhaseHeat.data())[row].b;
}

}  // namespace thaw
