// SPDX-License-Identifier: Apache-2.0
// Hash table from ids to numbers, with open addressing. It offers no iteration, so its internal order cannot
// affect results.
#pragma once
#include <cstdint>
#include <vector>

namespace thaw {

/// Mixes the bits of an id (finaliser of MurmurHash3).
inline std::uint64_t spreadBits(std::uint64_t x) {
  x ^= x >> 33;
  x *= 0xff51afd7ed558ccdull;
  x ^= x >> 33;
  x *= 0xc4ceb9fe1a85ec53ull;
  return x ^ (x >> 33);
}

/// The id ~0 is reserved: it marks free entries.
class IdTable {
 public:
  static constexpr std::uint32_t none = 0xffffffffu;

  std::size_t size() const { return size_; }
  std::size_t bytes() const {
    return key_.capacity() * sizeof(std::uint64_t) + value_.capacity() * sizeof(std::uint32_t);
  }
  /// Returns the number of an id, or none.
  std::uint32_t find(std::uint64_t id) const {
    if (size_ == 0) return none;
    for (std::size_t at = bucketOf(id);; at = (at + 1) & mask_) {
      if (key_[at] == id) return value_[at];
      if (key_[at] == free_) return none;
    }
  }
  /// Sets the number of an id, which may be new.
  void insert(std::uint64_t id, std::uint32_t value) {
    if (2 * (size_ + 1) > key_.size()) grow(key_.empty() ? 64 : 2 * key_.size());
    std::size_t at = bucketOf(id);
    while (key_[at] != free_ && key_[at] != id) at = (at + 1) & mask_;
    size_ += key_[at] == free_;
    key_[at] = id;
    value_[at] = value;
  }
  /// Makes room for this number of ids in total.
  void reserve(std::size_t ids) {
    std::size_t places = 64;
    while (places < 2 * ids) places *= 2;
    if (places > key_.size()) grow(places);
  }
  /// Removes an id; returns false if it was absent.
  bool erase(std::uint64_t id) {
    if (size_ == 0) return false;
    std::size_t at = bucketOf(id);
    while (key_[at] != id) {
      if (key_[at] == free_) return false;
      at = (at + 1) & mask_;
    }
    // Close the gap: later entries that would become unreachable move forward.
    for (std::size_t next = (at + 1) & mask_; key_[next] != free_; next = (next + 1) & mask_) {
      if (((next - bucketOf(key_[next])) & mask_) < ((next - at) & mask_)) continue;
      key_[at] = key_[next];
      value_[at] = value_[next];
      at = next;
    }
    key_[at] = free_;
    size_--;
    return true;
  }

 private:
  static constexpr std::uint64_t free_ = ~0ull;
  std::size_t bucketOf(std::uint64_t id) const { return spreadBits(id) & mask_; }
  void grow(std::size_t places) {  // a power of two
    std::vector<std::uint64_t> keys(places, free_);
    std::vector<std::uint32_t> values(keys.size());
    keys.swap(key_);
    values.swap(value_);
    mask_ = key_.size() - 1;
    size_ = 0;
    for (std::size_t k = 0; k < keys.size(); k++)
      if (keys[k] != free_) insert(keys[k], values[k]);
  }

  std::vector<std::uint64_t> key_;
  std::vector<std::uint32_t> value_;
  std::size_t mask_ = 0, size_ = 0;
};

}  // namespace thaw
