// Solid particles and their bonds: the reference configuration (MKN04, K05 3.2). Rows ("slots") stay where
// they are while particles are sorted by cell every step; a slot changes only when a solid particle migrates,
// melts or freezes. Rows [0, owned) belong to continuum particles of this rank; rows [owned, owned + ghosts)
// are remote ends of bonds.
#pragma once
#include "core/particles/column.hpp"
#include "core/solid/bonds.hpp"

namespace thaw {

inline constexpr std::uint32_t noParticle = 0xffffffffu;

/// What the loops over bonds read of either end (elastic_lanes.hpp), of one cache line in single precision:
/// displacement from the reference configuration, place in it, k of the hourglass energy k/2 sum w |x - F
/// X|^2 (N/m), and by rows the flux V P A^-1 - k grad u (N/m), the factor of w X in the force of a bond
/// (elastic.hpp). Where bonds have vectors of their own the reference is 0, and the displacement is the
/// place. Places are in m, or in single precision the bits of 32-bit fixed point.
template<class Real> struct alignas(4 * sizeof(Real)) BondEnd {
  Real displacement[3], reference[3], hourglass, flux[9];
};
template<class Real> struct FieldType<BondEnd<Real>> {
  static constexpr Scalar scalar = FieldType<Real>::scalar;
  static constexpr int components = 16;
};

struct Solids : Table {
  Solids() : Table("solid") {}
  bool energyKnown = true;  ///< `energy` and `deformation` are those of the places and bonds of now; steps
                            ///< need not find them (findElasticEnergy, solid_step.hpp)
  // clang-format off
  Column<std::uint64_t> id{*this, "id", "1", Keep::State, "of the continuum particle"};
  Column<std::uint32_t> particle{*this, "particle", "1", Keep::Local,
      "row of the continuum particle on this rank, noParticle for remote rows"};
  Column<std::uint16_t> material{*this, "material", "1", Keep::State, "index into the scene's materials"};
  Column<Vec3d> reference{*this, "reference", "m", Keep::State,
      "place in the reference configuration, where all bonds are of one; X_ij is a difference of two"};
  Column<double> volume{*this, "volume", "m^3", Keep::State,
      "without stress, as far as it is unbroken: the factor of all elastic energy"};
  Column<Mat3d> plasticInverse{*this, "plasticInverse", "1", Keep::State,
      "Fp^-1 - 1 of F = Fe Fp (plasticity.hpp); only where a material yields"};
  Column<Mat3d> referenceGradient{*this, "referenceGradient", "1", Keep::State,
      "F - 1 from the first reference configuration to the present one; only where references follow plastic "
      "flow"};
  Column<double> plasticPath{*this, "plasticPath", "1", Keep::State,
      "equivalent plastic strain; only where a material hardens"};
  // copies of the continuum particle, set at the start of a step (owned rows) and received (remote rows)
  Column<Vec3d> position{*this, "position", "m", Keep::Transient, "of the particle"};
  Column<Vec3d> velocity{*this, "velocity", "m/s", Keep::Transient,
      "of the particle; only with bond damping"};
  Column<float> liquid{*this, "liquid", "1", Keep::Transient,
      "liquid fraction of the particle; only where a material melts"};
  // computed from bonds
  Column<Sym3d> momentInverse{*this, "momentInverse", "1/m^2", Keep::Transient,
      "A^-1, A = sum w X X^T; recomputed when a bond changed"};
  Column<Mat3d> deformation{*this, "deformation", "1", Keep::Transient, "F = I + grad u"};
  Column<BondEnd<float>> end{*this, "end", "", Keep::Transient,
      "what its bonds read of it, in single precision"};
  Column<BondEnd<double>> endDouble{*this, "endDouble", "", Keep::Transient, "the same in double precision"};
  Column<double> drag{*this, "drag", "kg/s", Keep::Transient,
      "of the bonds' damping, per weight; only with bond damping"};
  Column<Sym3d> stress{*this, "stress", "Pa", Keep::Transient, "Cauchy stress, for output"};
  Column<Vec3d> force{*this, "force", "N", Keep::Transient, "elastic force on the particle"};
  Column<double> energy{*this, "energy", "J", Keep::State,
      "stored elastic, volume and hourglass energy; what leaves takes it along, also right after a restart"};
  Column<double> dissipated{*this, "dissipated", "J", Keep::Transient,
      "lost to plastic flow and bond damping in this step"};
  Column<std::uint8_t> bared{*this, "bared", "1", Keep::State,
      "it has lost a bond, has frozen, or was beside liquid: the surface that it had at the start need not "
      "cover it; only with a surface"};
  Column<std::uint8_t> melted{*this, "melted", "1", Keep::Transient,
      "its particle has melted in this step (melting.hpp)"};
  Column<std::uint8_t> rereferenced{*this, "rereferenced", "1", Keep::Transient,
      "took a new reference in this step (rereference.hpp)"};
  Column<std::uint8_t> changed{*this, "changed", "1", Keep::Local,
      "what is derived from its bonds (momentInverse, ElasticWork) is to be computed anew"};
  // clang-format on

  /// A slot has lost a bond: told where it is lost, since a slot that migrates takes its bonds along but not
  /// those that are lost.
  void bare(std::size_t slot) {
    if (bared.active) bared[slot] = 1;
  }
};

}  // namespace thaw
