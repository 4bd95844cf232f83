// A solid particle as it travels: between ranks in a migration, and through a checkpoint.
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/solid/solids.hpp"

namespace thaw {

struct BondRecord {
  std::uint64_t neighbourId;
  double reference[3], reverse[3];  ///< m, X_ij and X_ji; 0 where bonds have no vectors of their own
                                    ///< (Bonds::vectors), as the weight
  double weight;
};

/// Several solid particles one behind the other: id, number of bonds, the State columns of Solids, the bonds
/// in their order (ids alone where they have no vectors).
struct SolidRecords {
  std::vector<std::byte> bytes;
};

/// Appends slot's record.
void appendRecord(const Solids& solids, const Bonds& bonds, std::uint32_t slot, SolidRecords& records);

/// Appends a record but its State columns; returns where these are to be put.
std::size_t appendHead(SolidRecords& records, std::uint64_t id, std::size_t stateBytes,
                       std::span<const BondRecord> bonds, bool vectors);

/// One record read back; `next` is where the one behind it starts. Throws std::runtime_error where the bytes
/// end too early.
struct SolidRecordView {
  std::uint64_t id = 0;
  const std::byte* state = nullptr;
  std::vector<BondRecord> bonds;
};
std::size_t readRecord(const Solids& solids, const std::vector<std::byte>& bytes, std::size_t at,
                       SolidRecordView& view);

/// Makes room for `capacity` bonds a slot and `slots` slots; new places hold no bond.
void resizeBonds(Bonds& bonds, std::size_t slots, int capacity);

}  // namespace thaw
