// Solid particles and their bonds: the reference configuration (MKN04, K05 3.2). Rows ("slots") stay where they are while
// particles are sorted by cell every step; a slot changes only when a solid particle migrates, melts or freezes.
// Rows [0, owned) belong to continuum particles of this rank; rows [owned, owned + ghosts) are remote ends of bonds.
#pragma once
#include "core/particles/column.hpp"

namespace thaw {

inline constexpr std::uint32_t noParticle = 0xffffffffu;
inline constexpr int lanes = 8;  ///< bonds and neighbour lists are interleaved by groups of 8 rows (sliced ELLPACK)

struct Solids : Table {
  Solids() : Table("solid") {}
  Column<std::uint64_t> id{*this, "id", "1", Keep::State, "of the continuum particle"};
  Column<std::uint32_t> particle{*this, "particle", "1", Keep::Local, "row of the continuum particle on this rank, noParticle for remote rows"};
  Column<std::uint16_t> material{*this, "material", "1", Keep::State, "index into the scene's materials"};
  Column<double> volume{*this, "volume", "m^3", Keep::State, "of the reference configuration, as far as it is unbroken: the factor of all elastic energy"};
  Column<Sym3d> plasticStrain{*this, "plasticStrain", "1", Keep::State, "eps_p (OBH02); only where a material yields"};
  // copies of the continuum particle, set at the start of a step (owned rows) and received (remote rows)
  Column<Vec3d> position{*this, "position", "m", Keep::Transient, "of the particle"};
  Column<Vec3d> velocity{*this, "velocity", "m/s", Keep::Transient, "of the particle; only with bond damping"};
  Column<float> liquid{*this, "liquid", "1", Keep::Transient, "liquid fraction of the particle; only where a material melts"};
  // computed from bonds
  Column<Sym3d> momentInverse{*this, "momentInverse", "1/m^2", Keep::Transient, "A^-1, A = sum w X X^T; recomputed when a bond changed"};
  Column<Mat3d> deformation{*this, "deformation", "1", Keep::Transient, "F = I + grad u"};
  Column<Mat3d> flux{*this, "flux", "N/m", Keep::Transient, "V P A^-1 - k grad u, the factor of w X in the force of a bond (elastic.hpp); boundary groups and remote rows only"};
  Column<double> hourglass{*this, "hourglass", "N/m", Keep::Transient, "k of the hourglass energy k/2 sum w |x - F X|^2; boundary groups and remote rows only"};
  Column<double> drag{*this, "drag", "kg/s", Keep::Transient, "of the bonds' damping, per weight; only with bond damping, boundary groups and remote rows only"};
  Column<Sym3d> stress{*this, "stress", "Pa", Keep::Transient, "Cauchy stress, for output"};
  Column<Vec3d> force{*this, "force", "N", Keep::Transient, "elastic force on the particle"};
  Column<double> energy{*this, "energy", "J", Keep::State, "stored elastic, volume and hourglass energy; what leaves takes it along, also right after a restart"};
  Column<double> dissipated{*this, "dissipated", "J", Keep::Transient, "lost to plastic flow and bond damping in this step"};
  Column<std::uint8_t> melted{*this, "melted", "1", Keep::Transient, "its particle has melted in this step (melting.hpp)"};
  Column<std::uint8_t> rereferenced{*this, "rereferenced", "1", Keep::Transient, "took a new reference in this step (rereference.hpp)"};
  Column<std::uint8_t> changed{*this, "changed", "1", Keep::Local, "what is derived from its bonds (momentInverse, ElasticWork) is to be computed anew"};
};

/// Bonds of the owned slots. Bond k of slot s is element at(s, k) of each array. Weight 0 means none (neighbour is then s itself).
/// The order of a slot's bonds is part of the state: it is the order of sums, the same on any number of ranks.
struct Bonds {
  int capacity = 0;                        ///< bonds a slot has room for; grows as needed
  AlignedVector<std::uint32_t> neighbour;  ///< slot of the other end
  AlignedVector<double> x, y, z;           ///< reference vector X_ij from this end to the other, in this end's reference frame (m)
  AlignedVector<double> rx, ry, rz;        ///< the other end's own vector back to this one, X_ji; empty unless the scene freezes or re-references (then X_ji = -X_ij)
  AlignedVector<double> weight;            ///< w_ij, symmetric; 0: no bond or broken
  std::size_t at(std::size_t slot, int k) const { return (slot / lanes * static_cast<std::size_t>(capacity) + static_cast<std::size_t>(k)) * lanes + slot % lanes; }
  bool twoFrames = false;                  ///< rx, ry, rz are kept
  bool broken = false;                     ///< some weight became 0 on this rank since the last relink, which then drops these bonds
};

}  // namespace thaw
