// Logs of a surface as tables that any program reads: OUT/surface.csv, a line for each component at each
// frame; OUT/events.csv, a line for each split and merge, and each component whose label changed. One process
// only; IoError where the disk says no.
#pragma once
#include <string>
#include <vector>

#include "core/world.hpp"
#include "io/run/volume_held.hpp"

namespace thaw {

std::string componentLogPath(const std::string& out);
std::string eventLogPath(const std::string& out);

/// A new log, with its head.
void beginComponentLog(const std::string& out);

/// Lines of the frame that is being written (Clock::frame) behind the others.
void addToComponentLog(const std::string& out, const World& world);

/// Drops lines of after `step`, and one that was not finished; a log that is not there begins anew. Of a run
/// that goes back, or on from a checkpoint: lines of frames up to it were written before it. Returns what the
/// frames that are left say of volumes. Lines of earlier versions, without the volume that was to be held,
/// are kept with that field empty.
VolumeHeld cutComponentLog(const std::string& out, std::int64_t step);

/// The whole log, which is part of the state, in place of the one that is there.
void writeEventLog(const std::string& out, const std::vector<SurfaceEvent>& events);

}  // namespace thaw
