// SPDX-License-Identifier: Apache-2.0
// Packed form of a solid particle, for migration and checkpoints.
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/particles/solids.hpp"

namespace thaw {

struct BondRecord {
  std::uint64_t neighbourId;
  double reference[3], reverse[3];  ///< m, X_ij and X_ji; if bonds have no vectors (Bonds::vectors), these
                                    ///< and the weight are 0
  double weight;
};

/// A sequence of solid particles. Each record consists of the id, the number of bonds, the State columns of
/// Solids, and the bonds in order. For bonds without vectors, only ids are stored.
struct SolidRecords {
  std::vector<std::byte> bytes;
};

/// Appends the record of a solid.
void appendRecord(const Solids& solids, const Bonds& bonds, std::uint32_t solidIndex, SolidRecords& records);

/// Appends a record with empty State columns. Returns the offset of these columns.
std::size_t appendHead(SolidRecords& records, std::uint64_t id, std::size_t stateBytes,
                       std::span<const BondRecord> bonds, bool vectors);

/// One record read back. readRecord returns the offset of the next record. Throws std::runtime_error if the
/// bytes end early.
struct SolidRecordView {
  std::uint64_t id = 0;
  const std::byte* state = nullptr;
  std::vector<BondRecord> bonds;
};
std::size_t readRecord(const Solids& solids, const std::vector<std::byte>& bytes, std::size_t at,
                       SolidRecordView& view);

/// Makes room for `solids` solids with `capacity` bonds each; new entries hold no bond.
void resizeBonds(Bonds& bonds, std::size_t solidIndices, int capacity);

}  // namespace thaw
