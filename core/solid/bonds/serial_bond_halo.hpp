// SPDX-License-Identifier: Apache-2.0
// Bond graph of a single process: all ends are owned here. For tests and tools without MPI.
#pragma once
#include <vector>

#include "core/halo/halo.hpp"
#include "core/solid/bonds/bond_graph.hpp"

namespace thaw {

class SerialBondHalo : public BondHalo {
 public:
  void migrate(const BondedRows& particles, Solids& solids, Bonds& bonds,
               const Migration& migration) override;
  bool rebuildBonds(const BondedRows& particles, Solids& solids, Bonds& bonds,
                    const BondUpdate& work) override;
  void begin(Solids&, std::span<AnyColumn* const>) override {}
  void finish(Solids&) override {}

  /// Adds records (SolidRecords::bytes) of particles without a row; the next bond update creates their
  /// solids.
  void adopt(std::vector<std::byte> records) { records_.push_back(std::move(records)); }
  const BondGraph& graph() const { return graph_; }

 private:
  BondGraph graph_;
  std::vector<std::vector<std::byte>> records_;
  std::vector<std::uint32_t> withoutIndex_;
};

}  // namespace thaw
