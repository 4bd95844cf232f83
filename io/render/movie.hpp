// SPDX-License-Identifier: Apache-2.0
// Movies from pictures, by the program ffmpeg.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace thaw {

/// Returns the shell command that makes the movie. Requires: at least one picture, with names that differ by
/// their last digits only.
std::string movieCommand(const std::vector<std::filesystem::path>& pictures,
                         const std::filesystem::path& file, double rate);

/// Encodes PNG pictures in order as H.264 in an MP4 file, at `rate` pictures a second. Returns false without
/// ffmpeg. On failure ffmpeg prints its reason, IoError names the file, and files are unchanged.
bool makeMovie(const std::vector<std::filesystem::path>& pictures, const std::filesystem::path& file,
               double rate);

}  // namespace thaw
