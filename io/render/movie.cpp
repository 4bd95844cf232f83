// SPDX-License-Identifier: Apache-2.0
#include "io/render/movie.hpp"

#include <fmt/format.h>
#include <sys/wait.h>

#include <csignal>
#include <cstdio>
#include <fstream>

#include "io/hdf5/io_error.hpp"
#include "io/text/shell_word.hpp"

namespace thaw {

namespace fs = std::filesystem;

namespace {

/// Returns the command that encodes the pictures at its input. Players require even sizes and this pixel
/// format.
std::string encoder(const fs::path& file, double rate) {
  return fmt::format(
      "ffmpeg -y -v error -f image2pipe -c:v png -framerate {:g} -i - -c:v libx264 -crf 18 -pix_fmt yuv420p "
      "-vf 'pad=ceil(iw/2)*2:ceil(ih/2)*2' -movflags +faststart -f mp4 {}",
      rate, shellWord(file.string()));
}

}  // namespace

std::string movieCommand(const std::vector<fs::path>& pictures, const fs::path& file, double rate) {
  std::string first = pictures.front().string();
  first.resize(first.find_last_not_of("0123456789", first.rfind(".png") - 1) + 1);
  return "cat " + shellWord(first) + "*.png | " + encoder(file, rate);
}

bool makeMovie(const std::vector<fs::path>& pictures, const fs::path& file, double rate) {
  constexpr int notFound = 127;  // the shell's exit code
  fs::path part = file;
  part += ".part";
  std::FILE* const pipe = ::popen(
      ("command -v ffmpeg >/dev/null || exit 127; " + encoder(part, rate)).c_str(), "w");
  if (!pipe) throw IoError(file.string(), "cannot start ffmpeg");
  auto* const before = std::signal(SIGPIPE, SIG_IGN);  // ffmpeg may exit before it has read all
  fs::path unreadable;
  for (const fs::path& picture : pictures) {
    std::ifstream in(picture, std::ios::binary);
    char bytes[1 << 16];
    while (in.read(bytes, sizeof bytes), in.gcount() > 0)
      std::fwrite(bytes, 1, static_cast<std::size_t>(in.gcount()), pipe);
    if (!in.eof() && unreadable.empty()) unreadable = picture;
  }
  const int status = ::pclose(pipe), code = WIFEXITED(status) ? WEXITSTATUS(status) : 128;
  std::signal(SIGPIPE, before);
  if (code == notFound) return false;
  const bool read = unreadable.empty();
  std::error_code error;
  if (code == 0 && read) fs::rename(part, file, error);
  if (code == 0 && read && !error) return true;
  const std::string cause = error  ? "cannot be written: " + error.message()
                            : read ? fmt::format("ffmpeg failed with exit code {}", code)
                                   : "picture " + unreadable.string() + " cannot be read";
  fs::remove(part, error);
  throw IoError(file.string(), cause);
}

}  // namespace thaw
