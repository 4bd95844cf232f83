// SPDX-License-Identifier: Apache-2.0
// Work data of rigid pieces, reused in each step. It is not part of the state.
#pragma once
#include <cstdint>
#include <vector>

#include "core/math/exact_sum.hpp"

namespace thaw {

/// Numbers of the pieces that several ranks have.
struct SharedPieces {
  std::vector<std::uint32_t> number;  ///< by row, the same on all ranks; notShared: only this rank has the
                                      ///< piece
  std::size_t total = 0;              ///< number of shared pieces of all ranks

  static constexpr std::uint32_t notShared = 0xffffffffu;
};

/// Statistics of the contact solver in the last step, equal on all ranks.
struct ContactUse {
  std::int64_t iterations = 0;
  double residual = 0;   ///< m/s, largest velocity error of a contact
  double tolerance = 0;  ///< m/s
  double deepest = 0;    ///< m, largest overlap in all steps since the start of the program
};

struct RigidWork {
  std::vector<ExactSum> sums;           ///< sums over the particles of this rank, by row
  std::vector<std::int64_t> words;      ///< words of the sums, for their exchange
  std::vector<std::uint64_t> departed;  ///< pieces with particles that left this rank in the last migration
  SharedPieces shared;
  ContactUse contacts;
  bool atStart = false;      ///< the next evaluation makes the initial pieces
  bool changedHere = false;  ///< particles of pieces left the domain on this rank
};

}  // namespace thaw
