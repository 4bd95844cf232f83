// A film from pictures, by ffmpeg where it is installed.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace thaw {

/// Is a program of this name on the search path?
bool isInstalled(const std::string& program);

/// The command that makes the film by hand: `ffmpeg ...`.
std::string movieCommand(const std::vector<std::filesystem::path>& pictures,
                         const std::filesystem::path& file, double rate);

/// Encodes PNG pictures, in their order, as H.264 in an MP4 file that browsers and players show: `rate`
/// pictures a second. The file is there, whole, afterwards, or an IoError names it with the cause and nothing
/// changed.
void makeMovie(const std::vector<std::filesystem::path>& pictures, const std::filesystem::path& file,
               double rate);

}  // namespace thaw
