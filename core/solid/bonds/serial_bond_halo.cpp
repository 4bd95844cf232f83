// SPDX-License-Identifier: Apache-2.0
#include "core/solid/bonds/serial_bond_halo.hpp"

#include <algorithm>

namespace thaw {

void SerialBondHalo::migrate(const BondedRows& p, Solids&, Bonds&, const Migration& m) {
  if (!p.active) return;
  for (std::size_t i = p.owned - m.arrivals; i < p.owned; i++) p.solidIndex[i] = noSolid;
}

bool SerialBondHalo::rebuildBonds(const BondedRows& p, Solids& s, Bonds& b, const BondUpdate& work) {
  if (!p.active || !(work.changedHere || b.broken || work.asks() || !records_.empty())) return false;
  const SolidTables tables{p, s, b};
  graph_.begin();
  if (b.broken) graph_.dropBroken(tables);
  b.broken = false;
  findWithoutIndex(p, s, withoutIndex_);
  for (std::uint32_t solidIndex = 0; solidIndex < s.owned; solidIndex++)
    if (s.particle[solidIndex] == noParticle) graph_.remove(b, solidIndex);

  std::vector<SolidRecordView> records;
  std::size_t most = 0;
  for (const std::vector<std::byte>& bytes : records_)
    for (std::size_t at = 0; at < bytes.size();) {
      at = readRecord(s, bytes, at, records.emplace_back());
      most = std::max(most, records.back().bonds.size());
    }
  std::sort(records.begin(), records.end(),
            [](const SolidRecordView& x, const SolidRecordView& y) { return x.id < y.id; });
  std::vector<NewSolid> fresh;
  std::vector<const SolidRecordView*> recordOf;
  for (const std::uint32_t row : withoutIndex_) {
    const auto r = std::lower_bound(records.begin(), records.end(), p.id[row],
                                    [](const SolidRecordView& x, std::uint64_t id) { return x.id < id; });
    recordOf.push_back(r != records.end() && r->id == p.id[row] ? &*r : nullptr);
    fresh.push_back({row, recordOf.back() ? recordOf.back()->state : nullptr});
  }
  const auto before = static_cast<std::uint32_t>(graph_.rows());
  graph_.place(tables, fresh, work.remotesToCome);
  graph_.reserve(b, static_cast<int>(most));
  for (std::uint32_t i = 0; i < fresh.size(); i++)
    if (recordOf[i])
      for (const BondRecord& r : recordOf[i]->bonds) graph_.bond(tables, before + i, r, -1);
  for (const BondRequest& q : work.requests) graph_.bond(tables, q.solidIndex, bondOf(q), -1, q.other);
  graph_.bond(tables, work.pairs, [](const BondPair&) { return -1; });
  graph_.finish(tables);
  records_.clear();
  return true;
}

}  // namespace thaw
