// SPDX-License-Identifier: Apache-2.0
// Work data of rigid pieces, reused in each step. Not part of the state.
#pragma once
#include <cstdint>
#include <memory>
#include <vector>

#include "core/math/exact_sum.hpp"

namespace thaw {

struct RigidContactWork;

struct RigidWork {
  std::vector<ExactSum> sums;           ///< of the particles of this rank, by row
  std::vector<std::int64_t> words;      ///< of the sums, for their exchange
  std::vector<std::uint64_t> departed;  ///< pieces with particles that left this rank in the last migration
  bool atStart = false;      ///< the next evaluation makes the pieces of the start
  bool changedHere = false;  ///< particles left the domain with their pieces
  std::shared_ptr<RigidContactWork> contact;
};

}  // namespace thaw
