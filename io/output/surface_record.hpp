// What a checkpoint holds of a surface beside its surfels.
#pragma once
#include "io/output/checkpoint.hpp"

namespace thaw {

/// Of a world whose scene has a surface, or one that keepState has filled; else `there` is false.
SurfaceRecord surfaceRecordOf(const Surface& surface);
void restoreSurfaceRecord(const SurfaceRecord& record, Surface& surface);

/// Group /surface of a checkpoint. One process only; the group is there.
void writeSurfaceRecord(H5File& file, const SurfaceRecord& record);
/// IoError where it is damaged.
SurfaceRecord readSurfaceRecord(const H5File& file);

}  // namespace thaw
