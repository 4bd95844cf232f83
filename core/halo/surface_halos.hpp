// What a surface update needs of other ranks. Surfels and the particle copies have their own cut of the
// domain, balanced by their own cost: the update is a phase of its own, and particles are sent to it.
#pragma once
#include "core/halo/halo.hpp"

namespace thaw {

/// Sends values back to the rows that particle copies were made of.
class RowCourier {
 public:
  virtual ~RowCourier() = default;
  /// here[row] = values[k] on rank home[k] >> 32, row home[k] & 0xffffffff. Collective.
  virtual void sendHome(std::span<const std::uint64_t> home, std::span<const std::uint64_t> values,
                        std::span<std::uint64_t> here) = 0;
};

/// Both cell halos always have the same partition: `particles` follows `surfels`.
struct SurfaceHalos {
  Reducer& all;
  CellHalo& surfels;
  CellHalo& particles;
  RowCourier& courier;
};

}  // namespace thaw
