// SPDX-License-Identifier: Apache-2.0
// The sums of contact_heat.hpp, compiled once per instruction set.
#include "core/heat/contact_heat.hpp"

#include "core/fluid/terms/choose_types.hpp"
#include "core/fluid/terms/term.hpp"
#include "core/simd/isa_name.hpp"

namespace thaw {
namespace THAW_ISA {
namespace {

/// Mask of the pairs across a contact, from the records `ends`.
template<class Real> THAW_INLINE auto inContact(const Lanes4<Real>& i, const Lanes4<Real>& j) {
  using L = Lanes<Real>;
  const L difference = i.a - j.a;
  return (difference * difference > L(0.5)) & (i.b + j.b < L(1.5));
}

/// Normals of contacts: the gradient of the other bodies' volume. One term of the pair sums.
template<class Real, class Kernel> struct ContactNormals {
  using L = Lanes<Real>;
  const Record<Real>*positionVolume, *ends;
  Vec3f* normal;
  struct Data {
    Lanes4<Real> positionVolume, ends;
  };
  struct Sum {
    L x = L(0.0), y = L(0.0), z = L(0.0);
  };
  THAW_INLINE Data load(const std::uint32_t* entries) const {
    return {loadListed(positionVolume, entries), loadListed(ends, entries)};
  }
  THAW_INLINE void pair(const Data& i, const Data& j, const std::uint32_t*, Sum& s) const {
    const L dx = positionDifference(i.positionVolume.a, j.positionVolume.a),
            dy = positionDifference(i.positionVolume.b, j.positionVolume.b),
            dz = positionDifference(i.positionVolume.c, j.positionVolume.c);
    const L weight = L(0.0) - j.positionVolume.d * Kernel::slope(dot3(dx, dy, dz, dx, dy, dz)),
            g = select(inContact<Real>(i.ends, j.ends), weight, L(0.0));
    s.x += g * dx;
    s.y += g * dy;
    s.z += g * dz;
  }
  THAW_INLINE void finish(const std::uint32_t* rows, const Data&, const Sum& s, std::uint32_t dummy) const {
    for (int l = 0; l < 8; l++) {
      if (rows[l] == dummy) continue;
      const Vec3d n{static_cast<double>(s.x[l]), static_cast<double>(s.y[l]), static_cast<double>(s.z[l])};
      const double size = __builtin_sqrt(n.x * n.x + n.y * n.y + n.z * n.z), scale = size > 0 ? 1 / size : 0;
      normal[rows[l]] = {static_cast<float>(scale * n.x), static_cast<float>(scale * n.y),
                         static_cast<float>(scale * n.z)};
    }
  }
};

/// Flow across contacts minus that of the conduction sum. One term of the pair sums.
template<class Real, class Kernel> struct ContactHeat {
  using L = Lanes<Real>;
  const Record<Real>*positionVolume, *pressurePhaseHeat, *ends, *faces;
  double* heatFlow;
  double scale;
  L perSupport;  // 1/m
  L spacings;    // per support radius
  static constexpr double unit = lengthUnit<Real>;
  struct Data {
    Lanes4<Real> positionVolume, pressurePhaseHeat, ends, faces;
  };
  struct Sum {
    Lanes<double> heat = Lanes<double>(0.0);
  };
  THAW_INLINE Data load(const std::uint32_t* entries) const {
    return {loadListed(positionVolume, entries), loadListed(pressurePhaseHeat, entries),
            loadListed(ends, entries), loadListed(faces, entries)};
  }
  /// Distance along the normal of the contact, in support radii.
  THAW_INLINE static L across(const Data& i, const Data& j, L x, L y, L z, L r2) {
    constexpr double least = 0.1;  // fraction of the distance, for rough contacts
    const L nx = i.faces.a - j.faces.a, ny = i.faces.b - j.faces.b, nz = i.faces.c - j.faces.c;
    const L size2 = dot3(nx, ny, nz, nx, ny, nz), along = dot3(nx, ny, nz, x, y, z), r = sqrt(r2);
    const L projected = sqrt(along * along / max(size2, L(1e-6)));
    return max(select(size2 > L(1e-6), max(projected, L(least) * r), r), L(1e-6));
  }
  THAW_INLINE void pair(const Data& i, const Data& j, const std::uint32_t*, Sum& s) const {
    const L dx = unitDifference(i.positionVolume.a, j.positionVolume.a),
            dy = unitDifference(i.positionVolume.b, j.positionVolume.b),
            dz = unitDifference(i.positionVolume.c, j.positionVolume.c);
    const L r2 = dot3(dx, dy, dz, dx, dy, dz);
    // Repeats the operations of the conduction sum, so its flow cancels to the last bit.
    const L joined = conducted(i.positionVolume.d * j.positionVolume.d, i.pressurePhaseHeat,
                               j.pressurePhaseHeat, Kernel::laplace(L(unit) * sqrt(r2), L(unit * unit) * r2));
    const L ki = i.pressurePhaseHeat.d, kj = j.pressurePhaseHeat.d,
            k = L(2.0) * ki * kj / max(ki + kj, L(1e-30));
    const L z = across(i, j, L(unit) * dx, L(unit) * dy, L(unit) * dz, L(unit * unit) * r2);
    const L near = min(max((L(apart) - spacings * z) * L(1 / (apart - touching)), L(0.0)), L(1.0)),
            factor = near * z / (z + k * max(i.faces.d, j.faces.d) * perSupport);
    const auto contact = inContact<Real>(i.ends, j.ends);
    s.heat += wide(select(contact, factor * joined, L(0.0)));
    s.heat -= wide(select(contact, joined, L(0.0)));
  }
  THAW_INLINE void finish(const std::uint32_t* rows, const Data&, const Sum& s, std::uint32_t dummy) const {
    for (int l = 0; l < 8; l++)
      if (rows[l] != dummy) heatFlow[rows[l]] += scale * s.heat[l];
  }
};

template<class Real, class Kernel>
void normalsWith(const PairSums& in, const ContactHeatSums& out, GroupRange range) {
  ContactNormals<Real, Kernel> term{records<Real>(in.positionVolume), records<Real>(out.ends), out.normal};
  sweep(*in.lists, range, term, Groups::All);
}

template<class Real, class Kernel>
void heatWith(const PairSums& in, const ContactHeatSums& out, GroupRange range) {
  ContactHeat<Real, Kernel> term{records<Real>(in.positionVolume),
                                 records<Real>(in.pressurePhaseHeat),
                                 records<Real>(out.ends),
                                 records<Real>(out.faces),
                                 in.heatFlow,
                                 in.conductionScale * in.support,
                                 Lanes<Real>(1 / in.support),
                                 Lanes<Real>(in.support / out.spacing)};
  sweep(*in.lists, range, term, Groups::All);
}

void normals(const PairSums& in, const ContactHeatSums& out, GroupRange range) {
  chooseTypes(in,
              [&](auto real, auto kernel) { normalsWith<decltype(real), decltype(kernel)>(in, out, range); });
}
void heat(const PairSums& in, const ContactHeatSums& out, GroupRange range) {
  chooseTypes(in,
              [&](auto real, auto kernel) { heatWith<decltype(real), decltype(kernel)>(in, out, range); });
}

}  // namespace

const ContactHeatKernels& contactHeatKernelSet();
const ContactHeatKernels& contactHeatKernelSet() {
  static constexpr ContactHeatKernels set{isaName, normals, heat};
  return set;
}

}  // namespace THAW_ISA
}  // namespace thaw
