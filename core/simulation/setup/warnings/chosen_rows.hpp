// SPDX-License-Identifier: Apache-2.0
// Choice of particles for warnings that check only some of them.
#pragma once
#include <cstdint>

#include "core/domain/emit.hpp"

namespace thaw {

/// Returns true for about `most` of the `count` particles of a source. The choice depends only on the id, and
/// is unrelated to the lattice.
inline bool chosenById(std::uint64_t id, std::int64_t count, double most) {
  const double fraction = static_cast<double>((numberOf(id) * 0x9e3779b97f4a7c15u) >> 32) / 4294967296.0;
  return fraction * static_cast<double>(count) <= most;
}

}  // namespace thaw
