// Large plastic flow is absorbed into the reference configuration (MKN04 3.5), by push-forward so that the
// stress turns with the body (docs/validation/stability.md B13).
#pragma once
#include "core/solid/elastic.hpp"

namespace thaw {

/// Slots whose plastic strain since the last reference is longer than Numerics::plasticRereference take the
/// current configuration as reference: X_ij <- x_ij, Fp^-1 <- Ve of Fe = Ve R. F becomes the identity; stress
/// and elastic energy stay, and the energy of the hourglass control goes. Weights stay. Slots that are
/// inverted or pressed nearly flat (|F^-1|^2 > 6) wait, as do those whose bonds would no longer span space.
/// Their neighbours renew their copies of the vectors (Bonds::rx) here, and for remote slots in phase 2
/// (Boundary), by the exchanged column Solids::rereferenced. Call after phase 1 of both parts and breakBonds.
/// The jump of elastic energy is added to phaseJump (J). Returns the number of slots.
std::int64_t rereference(ElasticWork& work, Solids& solids, Bonds& bonds, const ElasticStep& step,
                         ExactSum& phaseJump);

/// Renews, in the bonds of these groups, the copies of the vectors of neighbours in this range that took a
/// new reference.
struct SlotRange {
  std::size_t begin, end;
};
void followReferences(ElasticWork& work, const Solids& solids, Bonds& bonds,
                      std::span<const std::uint32_t> groups, SlotRange flagged);

/// Renews copies of vectors of remote slots that took a new reference; part of phase 2.
void followRemoteReferences(ElasticWork& work, const Solids& solids, Bonds& bonds);

}  // namespace thaw
