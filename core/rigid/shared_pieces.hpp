// SPDX-License-Identifier: Apache-2.0
// Pieces that several ranks have.
#pragma once
#include <cstdint>
#include <vector>

namespace thaw {

/// Numbers of shared pieces, the same on all ranks; work data behind RigidWork::contact.
struct RigidContactWork {
  std::vector<std::uint32_t> number;  ///< by row; notShared: only this rank has the piece
  std::size_t total = 0;              ///< of all ranks

  static constexpr std::uint32_t notShared = 0xffffffffu;
};

}  // namespace thaw
