// SPDX-License-Identifier: Apache-2.0
// Movies from pictures, by ffmpeg if installed.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace thaw {

/// Returns whether a program of this name is on the search path.
bool isInstalled(const std::string& program);

/// Returns the ffmpeg command that makes the movie by hand.
std::string movieCommand(const std::vector<std::filesystem::path>& pictures,
                         const std::filesystem::path& file, double rate);

/// Encodes PNG pictures in order as H.264 in an MP4 file, at `rate` pictures a second. On failure it throws
/// IoError with file and cause, and leaves files unchanged.
void makeMovie(const std::vector<std::filesystem::path>& pictures, const std::filesystem::path& file,
               double rate);

}  // namespace thaw
