#include "core/solid/bond_records.hpp"

#include <algorithm>
#include <cstring>
#include <stdexcept>

namespace thaw {

void appendRecord(const Solids& s, const Bonds& b, std::uint32_t slot, SolidRecords& records) {
  std::vector<std::byte>& out = records.bytes;
  std::vector<BondRecord> list;
  for (int k = 0; k < b.capacity; k++) {
    const std::size_t at = b.at(slot, k);
    if (!(b.weight[at] > 0)) continue;
    BondRecord r{s.id[b.neighbour[at]], {b.x[at], b.y[at], b.z[at]}, {-b.x[at], -b.y[at], -b.z[at]}, b.weight[at]};
    if (b.twoFrames) r.reverse[0] = b.rx[at], r.reverse[1] = b.ry[at], r.reverse[2] = b.rz[at];
    list.push_back(r);
  }
  const std::uint64_t head[2] = {s.id[slot], list.size()};
  const std::size_t at = out.size(), state = s.stateBytes();
  out.resize(at + sizeof head + state + list.size() * sizeof(BondRecord));
  std::memcpy(out.data() + at, head, sizeof head);
  s.packState(slot, out.data() + at + sizeof head);
  if (!list.empty()) std::memcpy(out.data() + at + sizeof head + state, list.data(), list.size() * sizeof(BondRecord));
}

std::size_t readRecord(const Solids& s, const std::vector<std::byte>& bytes, std::size_t at, SolidRecordView& v) {
  std::uint64_t head[2];
  const std::size_t state = s.stateBytes();
  if (bytes.size() - at < sizeof head + state) throw std::runtime_error("the records of solid particles end too early");
  std::memcpy(head, bytes.data() + at, sizeof head);
  v.id = head[0];
  v.state = bytes.data() + at + sizeof head;
  at += sizeof head + state;
  if (head[1] > (bytes.size() - at) / sizeof(BondRecord)) throw std::runtime_error("the records of solid particles end too early");
  v.bonds.resize(head[1]);
  if (head[1] > 0) std::memcpy(v.bonds.data(), bytes.data() + at, head[1] * sizeof(BondRecord));
  return at + head[1] * sizeof(BondRecord);
}

void resizeBonds(Bonds& b, std::size_t slots, int capacity) {
  const std::size_t groups = (slots + lanes - 1) / lanes;
  const std::size_t before = b.capacity > 0 ? b.weight.size() / (static_cast<std::size_t>(b.capacity) * lanes) : 0;
  if (capacity <= b.capacity && groups <= before) return;
  capacity = std::max(capacity, b.capacity);
  const std::size_t room = groups <= before ? before : groups + groups / 16 + 8, block = static_cast<std::size_t>(capacity) * lanes;
  const auto grow = [&](auto& v) {
    using T = typename std::remove_reference_t<decltype(v)>::value_type;
    AlignedVector<T> bigger(room * block, T(0));
    for (std::size_t g = 0; g < before; g++)
      std::copy_n(v.data() + g * static_cast<std::size_t>(b.capacity) * lanes, static_cast<std::size_t>(b.capacity) * lanes, bigger.data() + g * block);
    v.swap(bigger);
  };
  grow(b.neighbour);
  grow(b.x);
  grow(b.y);
  grow(b.z);
  grow(b.weight);
  if (b.twoFrames) {
    grow(b.rx);
    grow(b.ry);
    grow(b.rz);
  }
  b.capacity = capacity;
}

}  // namespace thaw
