// SPDX-License-Identifier: Apache-2.0
#include "core/solid/bonds/bond_records.hpp"

#include <algorithm>
#include <cstring>
#include <stdexcept>

namespace thaw {

namespace {

constexpr std::uint64_t endsOnly = std::uint64_t(1) << 63;  // flag in the number of bonds; if set, only the
                                                            // ids of the other ends follow

}  // namespace

std::size_t appendHead(SolidRecords& records, std::uint64_t id, std::size_t stateBytes,
                       std::span<const BondRecord> bonds, bool vectors) {
  std::vector<std::byte>& out = records.bytes;
  const std::uint64_t head[2] = {id, bonds.size() | (vectors ? 0 : endsOnly)};
  const std::size_t at = out.size(), each = vectors ? sizeof(BondRecord) : sizeof(std::uint64_t);
  out.resize(at + sizeof head + stateBytes + bonds.size() * each);
  std::memcpy(out.data() + at, head, sizeof head);
  std::byte* to = out.data() + at + sizeof head + stateBytes;
  for (const BondRecord& b : bonds) {
    std::memcpy(to, &b, each);  // the id comes first
    to += each;
  }
  return at + sizeof head;
}

void appendRecord(const Solids& s, const Bonds& b, std::uint32_t solidIndex, SolidRecords& records) {
  std::vector<BondRecord> list;
  for (int k = 0; k < b.capacity; k++) {
    if (!b.hasBond(solidIndex, k)) continue;
    const std::size_t at = b.at(solidIndex, k);
    BondRecord r{s.id[b.neighbour[at]], {}, {}, 0};
    if (b.vectors) {
      r = {r.neighbourId, {b.x[at], b.y[at], b.z[at]}, {-b.x[at], -b.y[at], -b.z[at]}, b.weight[at]};
      if (b.twoFrames) r.reverse[0] = b.rx[at], r.reverse[1] = b.ry[at], r.reverse[2] = b.rz[at];
    }
    list.push_back(r);
  }
  const std::size_t state = appendHead(records, s.id[solidIndex], s.stateBytes(), list, b.vectors);
  s.packState(solidIndex, records.bytes.data() + state);
}

std::size_t readRecord(const Solids& s, const std::vector<std::byte>& bytes, std::size_t at,
                       SolidRecordView& v) {
  std::uint64_t head[2];
  const std::size_t state = s.stateBytes();
  if (bytes.size() - at < sizeof head + state)
    throw std::runtime_error("the records of solid particles are truncated");
  std::memcpy(head, bytes.data() + at, sizeof head);
  v.id = head[0];
  v.state = bytes.data() + at + sizeof head;
  at += sizeof head + state;
  const std::size_t each = head[1] & endsOnly ? sizeof(std::uint64_t) : sizeof(BondRecord),
                    count = head[1] & ~endsOnly;
  if (count > (bytes.size() - at) / each)
    throw std::runtime_error("the records of solid particles are truncated");
  v.bonds.assign(count, BondRecord{});
  for (BondRecord& b : v.bonds) {
    std::memcpy(&b, bytes.data() + at, each);
    at += each;
  }
  return at;
}

void resizeBonds(Bonds& b, std::size_t solidIndices, int capacity) {
  const std::size_t groups = (solidIndices + lanes - 1) / lanes;
  const std::size_t before = b.capacity > 0
                                 ? b.neighbour.size() / (static_cast<std::size_t>(b.capacity) * lanes)
                                 : 0;
  if (capacity <= b.capacity && groups <= before) return;
  capacity = std::max(capacity, b.capacity);
  const std::size_t room = groups <= before ? before
                           : before == 0    ? groups
                                            : groups + groups / 16 + 8,
                    block = static_cast<std::size_t>(capacity) * lanes;
  const auto grow = [&](auto& v) {
    using T = typename std::remove_reference_t<decltype(v)>::value_type;
    AlignedVector<T> bigger(room * block, T(0));
    for (std::size_t g = 0; g < before; g++)
      std::copy_n(v.data() + g * static_cast<std::size_t>(b.capacity) * lanes,
                  static_cast<std::size_t>(b.capacity) * lanes, bigger.data() + g * block);
    v.swap(bigger);
  };
  grow(b.neighbour);
  b.eachReal([&](BondReals& r) { r.with(grow); });
  b.capacity = capacity;
}

}  // namespace thaw
