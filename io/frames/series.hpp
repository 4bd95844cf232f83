// SPDX-License-Identifier: Apache-2.0
// The index of a run's frames, NAME.hdf.series, which ParaView opens as one animation, and the names of a
// run's files.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "io/hdf5/io_error.hpp"

namespace thaw {

struct SeriesEntry {
  std::string name;  ///< file name, relative to the index
  double time = 0;   ///< s
};

/// Return OUT/frames, NAME_000120.hdf and OUT/frames/NAME.hdf.series. NAME is that of the scene.
std::string frameFolder(const std::string& out);
std::string frameName(const std::string& scene, std::int64_t number);
std::string seriesPath(const std::string& out, const std::string& scene);

/// Makes a folder. Throws IoError.
void makeFolder(const std::string& folder);
/// Makes OUT and its folders for frames and checkpoints. Throws IoError.
void makeOutputFolders(const std::string& out);

/// Replaces the index at once. One process only.
void writeSeries(const std::string& path, const std::vector<SeriesEntry>& entries);
/// Throws IoError if it is missing or damaged.
std::vector<SeriesEntry> readSeries(const std::string& path);

/// Returns the readable frames NAME_*.hdf of the folder up to `until` (s), ascending by time, for the index
/// at a restart. Later frames remain until they are overwritten. Removes incomplete files *.part. One process
/// only.
std::vector<SeriesEntry> framesPresent(const std::string& out, const std::string& scene, double until);

/// Removes frames after `time` (s): first from the index, which never names a missing file, then from disk.
/// One process only.
void removeFramesAfter(const std::string& out, const std::string& scene, std::vector<SeriesEntry>& entries,
                       double time);

/// Returns all indices in a folder of frames or of a run, ascending by name.
std::vector<std::string> findSeries(const std::string& folder);

}  // namespace thaw
