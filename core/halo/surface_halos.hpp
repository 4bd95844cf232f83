// SPDX-License-Identifier: Apache-2.0
// Interface of a surface update to other ranks. Surfels and particle copies have their own domain
// decomposition, balanced by their own cost. The update is a separate phase, and particles are sent to it.
#pragma once
#include "core/halo/halo.hpp"

namespace thaw {

/// Sends values back to the rows from which particle copies were made.
class RowScatter {
 public:
  virtual ~RowScatter() = default;
  /// Sets here[row] = values[k] on rank source[k] >> 32, row source[k] & 0xffffffff. Collective.
  virtual void scatterBack(std::span<const std::uint64_t> source, std::span<const std::uint64_t> values,
                           std::span<std::uint64_t> here) = 0;
};

/// Both cell halos have the same partition: `particles` follows `surfels`.
struct SurfaceHalos {
  Reducer& all;
  CellHalo& surfels;
  CellHalo& particles;
  RowScatter& scatter;
};

}  // namespace thaw
