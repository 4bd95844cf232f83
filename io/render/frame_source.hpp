// Frames on disk, for pictures: which there are, and what a picture needs of one.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "io/render/render_frames.hpp"

namespace thaw {

/// The frames that `path` stands for, in the order of time: a frame file (.hdf) itself, those of a series index (.hdf.series), or those
/// of a folder, which may be a run's folder or its frames/. A folder's index counts; without one, all .hdf files in the order of their names.
/// Throws IoError naming the path if there are none.
std::vector<std::filesystem::path> findFrames(const std::filesystem::path& path);

/// Names of the fields that a frame has, ascending. Throws IoError naming the file and the cause.
std::vector<std::string> fieldsOf(const std::filesystem::path& frame);

/// ReadFrame for VTKHDF frames. The field "speed" is the length of "velocity". Throws IoError naming the file and the cause:
/// not HDF5, truncated, not a frame, no such field (with those there are).
FrameView readFrameView(const std::filesystem::path& frame, const std::string& field);

/// The scene as text that the run kept in the frame, and its name; empty if it has none.
struct KeptScene { std::string name, text; };
KeptScene keptSceneOf(const std::filesystem::path& frame);

}  // namespace thaw
