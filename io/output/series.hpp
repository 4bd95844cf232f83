// The index of a run's frames, NAME.hdf.series, that ParaView opens as one animation; and the names of a
// run's files.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "io/hdf5/io_error.hpp"

namespace thaw {

struct SeriesEntry {
  std::string name;  ///< of the file, relative to the index
  double time = 0;   ///< s
};

/// OUT/frames/NAME_000120.hdf and OUT/frames/NAME.hdf.series; NAME is that of the scene.
std::string frameFolder(const std::string& out);
std::string frameName(const std::string& scene, std::int64_t number);
std::string seriesPath(const std::string& out, const std::string& scene);

/// IoError where that cannot be done.
void makeFolder(const std::string& folder);
/// Makes OUT and its folders for frames and checkpoints. IoError where that cannot be done.
void makeOutputFolders(const std::string& out);

/// Replaces the index by rename. One process only.
void writeSeries(const std::string& path, const std::vector<SeriesEntry>& entries);
/// IoError if it is not there, or damaged.
std::vector<SeriesEntry> readSeries(const std::string& path);

/// Frames NAME_*.hdf in the folder that can be read, ascending by time, those after `until` (s) left out: for
/// the index of a run that goes on from a checkpoint. Later frames stay until they are written again.
/// Leftovers *.part are removed. One process only.
std::vector<SeriesEntry> framesPresent(const std::string& out, const std::string& scene, double until);

/// Frames of after `time` (s) go: out of the index first, which never names what is not there, then from the
/// disk. One process only.
void forgetSeries(const std::string& out, const std::string& scene, std::vector<SeriesEntry>& entries,
                  double time);

/// All indices in a folder of frames (or of a run), ascending by name.
std::vector<std::string> findSeries(const std::string& folder);

}  // namespace thaw
