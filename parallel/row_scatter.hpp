// SPDX-License-Identifier: Apache-2.0
// RowScatter over MPI.
#pragma once
#include "core/halo/surface_halos.hpp"
#include "parallel/cell_halo.hpp"
#include "parallel/communicator.hpp"

namespace thaw {

class MpiRowScatter : public RowScatter {
 public:
  explicit MpiRowScatter(const Communicator& comm) : comm_(comm) {}
  void scatterBack(std::span<const std::uint64_t> source, std::span<const std::uint64_t> values,
                   std::span<std::uint64_t> here) override;

 private:
  const Communicator& comm_;
};

/// The halos of a surface over MPI. The communicator must outlive it.
struct SurfaceRanks {
  MpiReducer all;
  MpiCellHalo surfels, particles;
  MpiRowScatter scatter;
  SurfaceRanks(const Communicator& comm, const CellGrid& grid)
      : all(comm), surfels(comm, grid), particles(comm, grid), scatter(comm) {}
  SurfaceHalos halos() { return {all, surfels, particles, scatter}; }
};

}  // namespace thaw
