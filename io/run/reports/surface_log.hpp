// SPDX-License-Identifier: Apache-2.0
// Logs of a surface. OUT/surface.csv has a line for each component at each frame. OUT/events.csv has a line
// for each split, merge and change of a label. One process only. Throws IoError if the disk fails.
#pragma once
#include <string>
#include <vector>

#include "core/surface/data/surface.hpp"
#include "core/time/clock.hpp"
#include "io/run/reports/volume_errors.hpp"

namespace thaw {

std::string componentLogPath(const std::string& out);
std::string eventLogPath(const std::string& out);

/// Starts a new log with its header.
void beginComponentLog(const std::string& out);

/// Adds the lines of the current frame (Clock::frame).
void addToComponentLog(const std::string& out, const Surface& surface, const Clock& clock);

/// Drops lines after `step` and an incomplete last line, at a rollback or restart. Starts a new log if it is
/// missing. Returns the volume errors of the remaining frames. Lines of earlier versions lack the target
/// volume; that field stays empty.
VolumeErrors truncateComponentLog(const std::string& out, std::int64_t step);

/// Replaces the whole log, which is part of the state.
void writeEventLog(const std::string& out, const std::vector<SurfaceEvent>& events);

}  // namespace thaw
