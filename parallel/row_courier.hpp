// RowCourier over MPI.
#pragma once
#include "core/halo/surface_halos.hpp"
#include "parallel/cell_halo.hpp"
#include "parallel/communicator.hpp"

namespace thaw {

class MpiRowCourier : public RowCourier {
 public:
  explicit MpiRowCourier(const Communicator& comm) : comm_(comm) {}
  void sendHome(std::span<const std::uint64_t> home, std::span<const std::uint64_t> values,
                std::span<std::uint64_t> here) override;

 private:
  const Communicator& comm_;
};

/// The halos of a surface over MPI. The communicator must outlive it.
struct SurfaceRanks {
  MpiReducer all;
  MpiCellHalo surfels, particles;
  MpiRowCourier courier;
  SurfaceRanks(const Communicator& comm, const CellGrid& grid)
      : all(comm), surfels(comm, grid), particles(comm, grid), courier(comm) {}
  SurfaceHalos halos() { return {all, surfels, particles, courier}; }
};

}  // namespace thaw
