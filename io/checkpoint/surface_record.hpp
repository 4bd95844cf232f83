// SPDX-License-Identifier: Apache-2.0
// State of a surface in a checkpoint, besides its surfels.
#pragma once
#include "io/checkpoint/checkpoint.hpp"

namespace thaw {

/// Returns the record of a surface; `there` is false if the scene has none and takeSnapshot has not filled
/// it.
SurfaceRecord surfaceRecordOf(const Surface& surface);
void restoreSurfaceRecord(const SurfaceRecord& record, Surface& surface);

/// Writes into the group /surface of a checkpoint, which must exist. One process only.
void writeSurfaceRecord(H5File& file, const SurfaceRecord& record);
/// Throws IoError if it is damaged.
SurfaceRecord readSurfaceRecord(const H5File& file);

}  // namespace thaw
