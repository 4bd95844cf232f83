// SPDX-License-Identifier: Apache-2.0
// Solid particles and their bonds: the reference configuration (MKN04, K05 3.2). Particles are sorted by cell
// every step, but rows (solid indices) stay in place: they change only when a solid particle migrates, melts
// or freezes. Rows [0, owned) belong to continuum particles of this rank; rows [owned, owned + ghosts) are
// remote ends of bonds.
#pragma once
#include "core/fields/column.hpp"
#include "core/particles/bonds.hpp"

namespace thaw {

inline constexpr std::uint32_t noParticle = 0xffffffffu;

/// Data of a bond end in the bond loops (elastic_lanes.hpp), one cache line in single precision. It contains
/// the displacement from the reference configuration and the reference position. Its factor `hourglass` is k
/// (N/m) of the hourglass energy k/2 sum w |x - F X|^2. `flux` has the rows of V P A^-1 - k grad u (N/m). The
/// flux is the factor of w X in the force of a bond (elastic.hpp). If bonds have vectors, the reference is 0
/// and the displacement is the position. Positions are in m. In single precision they are the bits of 32-bit
/// fixed-point numbers.
template<class Real> struct alignas(4 * sizeof(Real)) BondEnd {
  Real displacement[3], reference[3], hourglass, flux[9];
};
template<class Real> struct FieldType<BondEnd<Real>> {
  static constexpr Scalar scalar = FieldType<Real>::scalar;
  static constexpr int components = 16;
};

struct Solids : Table {
  Solids() : Table("solid") {}
  bool energyKnown = true;  ///< `energy` and `deformation` match the current positions and bonds; otherwise
                            ///< findElasticEnergy (solid_step.hpp) computes both on demand
  // clang-format off
  Column<std::uint64_t> id{*this, "id", "1", Keep::State, "id of the continuum particle"};
  Column<std::uint32_t> particle{*this, "particle", "1", Keep::Local,
      "row of the continuum particle on this rank; noParticle for remote rows"};
  Column<std::uint16_t> material{*this, "material", "1", Keep::State, "index into the scene's materials"};
  Column<Vec3d> reference{*this, "reference", "m", Keep::State,
      "reference position, if all bonds share one configuration; X_ij is a difference of two"};
  Column<double> volume{*this, "volume", "m^3", Keep::State,
      "stress-free volume, reduced by fracture: the factor of all elastic energy"};
  Column<Mat3d> plasticInverse{*this, "plasticInverse", "1", Keep::State,
      "Fp^-1 - 1 of F = Fe Fp (plasticity.hpp); only where a material yields"};
  Column<Mat3d> referenceGradient{*this, "referenceGradient", "1", Keep::State,
      "F - 1 from the first reference configuration to the present one; only where references follow plastic "
      "flow"};
  Column<Mat3d> lastGradient{*this, "lastGradient", "1", Keep::State,
      "F - 1 of the last evaluation with the present bonds, for the work of plastic flow; -1: unknown; only "
      "with a limit of plastic strain"};
  Column<double> plasticPath{*this, "plasticPath", "1", Keep::State,
      "equivalent plastic strain; only where a material hardens"};
  // Copies of the continuum particle, set at the start of a step (owned rows) or received (remote rows).
  Column<Vec3d> position{*this, "position", "m", Keep::Transient, "position of the particle"};
  Column<Vec3d> velocity{*this, "velocity", "m/s", Keep::Transient,
      "velocity of the particle in the drift of this step; only with bond damping, fracture, new references "
      "or rigidify"};
  Column<float> liquid{*this, "liquid", "1", Keep::Transient,
      "liquid fraction of the particle; only where a material melts"};
  // Computed from bonds.
  Column<Sym3d> momentInverse{*this, "momentInverse", "1/m^2", Keep::Transient,
      "A^-1, A = sum w X X^T; recomputed when a bond changed"};
  Column<Mat3d> deformation{*this, "deformation", "1", Keep::Transient, "F = I + grad u"};
  Column<BondEnd<float>> end{*this, "end", "", Keep::Transient, "data of a bond end, in single precision"};
  Column<BondEnd<double>> endDouble{*this, "endDouble", "", Keep::Transient,
      "data of a bond end, in double precision"};
  Column<double> drag{*this, "drag", "kg/s", Keep::Transient,
      "bond damping coefficient per weight; only with bond damping"};
  Column<Sym3d> stress{*this, "stress", "Pa", Keep::Transient, "Cauchy stress, for output"};
  Column<Vec3d> force{*this, "force", "N", Keep::Transient, "elastic force on the particle"};
  Column<double> energy{*this, "energy", "J", Keep::State,
      "stored elastic, volume and hourglass energy; migrates with the solidIndex, also right after a "
      "restart"};
  Column<double> dissipated{*this, "dissipated", "J", Keep::Transient,
      "lost to plastic flow and bond damping in this step"};
  Column<std::uint8_t> exposed{*this, "exposed", "1", Keep::State,
      "lost a bond, froze, or touched liquid: the initial surface may no longer cover it; only with a "
      "surface"};
  Column<std::uint8_t> melted{*this, "melted", "1", Keep::Transient,
      "its particle melted in this step (melting.hpp)"};
  Column<std::uint8_t> rereferenced{*this, "rereferenced", "1", Keep::Transient,
      "took a new reference in this step (rereference.hpp)"};
  Column<std::uint8_t> changed{*this, "changed", "1", Keep::Local,
      "data derived from its bonds (momentInverse, ElasticWork) needs an update"};
  // clang-format on

  /// Marks a solid that lost a bond. Call it when the bond is lost, since a migrating solid keeps no trace of
  /// lost bonds.
  void markExposed(std::size_t solidIndex) {
    if (exposed.active) exposed[solidIndex] = 1;
  }
};

}  // namespace thaw
