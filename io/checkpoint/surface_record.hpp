// SPDX-License-Identifier: Apache-2.0
// State of a surface in a checkpoint, besides its surfels.
#pragma once
#include "io/checkpoint/checkpoint.hpp"

namespace thaw {

/// Returns the record of a surface. `there` is false if the scene has no surface and takeSnapshot has not
/// filled the record.
SurfaceRecord surfaceRecordOf(const Surface& surface);
void restoreSurfaceRecord(const SurfaceRecord& record, Surface& surface);

/// Writes the record into the group /surface of a checkpoint. Requires: the group exists. One process only.
void writeSurfaceRecord(H5File& file, const SurfaceRecord& record);
/// Reads the record. Throws IoError if the group is damaged.
SurfaceRecord readSurfaceRecord(const H5File& file);

}  // namespace thaw
