// SPDX-License-Identifier: Apache-2.0
// The sweep of an extension's pair force (core/fluid/pair_sums/extension_pair_force.hpp). An extension
// includes this in a source file that is compiled once per instruction set (thaw_instruction_sets() in
// CMake).
//
// A Law is made from PairConstants, and has
//   static constexpr bool moves;  // whether it reads velocities
//   template<class L> THAW_INLINE PairResult<L> operator()(const PairState<L>&) const;
// with L = Lanes<float> or Lanes<double>, eight pairs at once. Each factor must be symmetric in the two
// particles to the last bit, so that momentum is conserved.
//
// The force on particle i is F_i = sum_j f_i f_j (along * (x_i - x_j) + drag * (v_i - v_j)). Here f are the
// liquid fractions, and F_j has the opposite sign. With along = -(dE/dr) / r the sum of E over pairs is
// conserved.
#pragma once
#include "core/fluid/pair_sums/extension_pair_force.hpp"
#include "core/fluid/terms/term.hpp"

namespace thaw {
namespace THAW_ISA {
namespace {

/// Differences are own - other.
template<class L> struct PairState {
  L r;                 ///< m, distance, above 0 and less than the support radius
  L x, y, z;           ///< m
  L vx, vy, vz;        ///< m/s; 0 if the law does not read velocities
  L own[3], other[3];  ///< values of PairForce::pack
};

template<class L> struct PairResult {
  L along = L(0.0);        ///< N/m; the force on own is along * (x, y, z) + drag * (vx, vy, vz)
  L drag = L(0.0);         ///< N s/m
  L energy = L(0.0);       ///< J, stored in the pair; its derivative with respect to r is -along * r
  L dissipation = L(0.0);  ///< W, mechanical energy that the pair loses
};

template<class Real, class Law> struct PairForceTerm {
  using L = Lanes<Real>;
  const Record<Real>*position, *velocity, *values;
  const PairSums* in;
  const PairForceSums* out;
  Law law;
  L unit, support;  // m
  struct Data {
    Lanes4<Real> position, velocity, values;
  };
  struct Sum {
    LanesD x = LanesD(0.0), y = LanesD(0.0), z = LanesD(0.0);
    L energy = L(0.0), dissipation = L(0.0);
  };
  THAW_INLINE Data load(const std::uint32_t* entries) const {
    Data d{loadListed(position, entries), {}, loadListed(values, entries)};
    if constexpr (Law::moves) d.velocity = loadListed(velocity, entries);
    return d;
  }
  THAW_INLINE void pair(const Data& i, const Data& j, const std::uint32_t*, Sum& s) const {
    PairState<L> p;
    p.x = unit * unitDifference(i.position.a, j.position.a);
    p.y = unit * unitDifference(i.position.b, j.position.b);
    p.z = unit * unitDifference(i.position.c, j.position.c);
    p.r = sqrt(dot3(p.x, p.y, p.z, p.x, p.y, p.z));
    p.vx = p.vy = p.vz = L(0.0);
    if constexpr (Law::moves)
      p.vx = i.velocity.a - j.velocity.a, p.vy = i.velocity.b - j.velocity.b,
      p.vz = i.velocity.c - j.velocity.c;
    p.own[0] = i.values.a, p.own[1] = i.values.b, p.own[2] = i.values.c;
    p.other[0] = j.values.a, p.other[1] = j.values.b, p.other[2] = j.values.c;
    const L weight = i.values.d * j.values.d;  // product of liquid fractions; 0 for the dummy row
    const PairResult<L> f = law(p);
    const auto acts = (p.r < support) & (p.r > L(0.0)) & (weight > L(0.0));
    const auto weighted = [&](L value) { return select(acts, weight * value, L(0.0)); };
    const L along = weighted(f.along);
    if constexpr (Law::moves) {
      const L drag = weighted(f.drag);
      s.x += wide(fma(along, p.x, drag * p.vx));
      s.y += wide(fma(along, p.y, drag * p.vy));
      s.z += wide(fma(along, p.z, drag * p.vz));
      s.dissipation += weighted(f.dissipation);
    } else {
      s.x += wide(along * p.x);
      s.y += wide(along * p.y);
      s.z += wide(along * p.z);
    }
    s.energy += weighted(f.energy);
  }
  THAW_INLINE void finish(const std::uint32_t* rows, const Data&, const Sum& s, std::uint32_t dummy) const {
    for (int l = 0; l < 8; l++) {
      if (rows[l] == dummy) continue;
      Vec3d& f = in->force[rows[l]];
      f.x += s.x[l], f.y += s.y[l], f.z += s.z[l];
      out->energy[rows[l]] = 0.5 * static_cast<double>(s.energy[l]);
      if constexpr (Law::moves) in->dissipation[rows[l]] += 0.5 * static_cast<double>(s.dissipation[l]);
    }
  }
};

template<class Real, class Law>
void sumPairForceOf(const PairSums& in, const PairForceSums& out, GroupRange range) {
  using L = Lanes<Real>;
  PairForceTerm<Real, Law> term{records<Real>(in.positionVolume),
                                records<Real>(in.velocityViscosity),
                                records<Real>(out.records),
                                &in,
                                &out,
                                Law(out.constants),
                                L(in.support * lengthUnit<Real>),
                                L(in.support)};
  sweep(*in.lists, range, term, Groups::Fluid);
}

template<class Law> void sumPairForce(const PairSums& in, const PairForceSums& out, GroupRange range) {
  in.precision == Precision::Single ? sumPairForceOf<float, Law>(in, out, range)
                                    : sumPairForceOf<double, Law>(in, out, range);
}

/// Energy (J) of one pair, weighted by its liquid fractions.
template<class Law> double pairEnergy(const PairConstants& constants, const PairPoint& at) {
  using L = LanesD;
  const double r = length(at.distance);
  const double weight = at.own[3] * at.other[3];
  if (!(r < constants.support && r > 0 && weight > 0)) return 0;
  PairState<L> p{L(r),   L(at.distance.x), L(at.distance.y),         L(at.distance.z),        L(0.0),
                 L(0.0), L(0.0),           {L(0.0), L(0.0), L(0.0)}, {L(0.0), L(0.0), L(0.0)}};
  for (int k = 0; k < 3; k++) p.own[k] = L(at.own[k]), p.other[k] = L(at.other[k]);
  return weight * Law(constants)(p).energy[0];
}

/// The functions of a pair force on this instruction set.
template<class Law> constexpr PairForceKernels pairForceKernels() {
  return {sumPairForce<Law>, pairEnergy<Law>};
}

}  // namespace
}  // namespace THAW_ISA
}  // namespace thaw
