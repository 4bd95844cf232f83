// SPDX-License-Identifier: Apache-2.0
#include "io/render/movie.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <sstream>

#include "io/hdf5/io_error.hpp"

extern char** environ;

namespace thaw {

namespace fs = std::filesystem;

namespace {

/// Options after the input. Players require even sizes and this pixel format.
std::vector<std::string> encoding() {
  return {"-c:v",      "libx264",   "-crf", "18",
          "-pix_fmt",  "yuv420p",   "-vf",  "pad=ceil(iw/2)*2:ceil(ih/2)*2",
          "-movflags", "+faststart"};
}

struct Descriptor {
  int number = -1;
  ~Descriptor() { close(); }
  void close() {
    if (number >= 0) ::close(number);
    number = -1;
  }
};

/// Writes all bytes; false if the reader has closed.
bool writeAll(int to, const std::string& bytes) {
  for (std::size_t done = 0; done < bytes.size();) {
    const ssize_t n = ::write(to, bytes.data() + done, bytes.size() - done);
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) return false;
    done += static_cast<std::size_t>(n);
  }
  return true;
}

std::string contentOf(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  std::stringstream text;
  text << in.rdbuf();
  if (!in) throw IoError(path.string(), "cannot be read");
  return text.str();
}

/// Runs ffmpeg with the pictures at its input; returns its exit code and the text of stderr.
int encode(const std::vector<fs::path>& pictures, const fs::path& part, double rate, std::string& said) {
  std::vector<std::string> words{"ffmpeg",     "-y",   "-v",  "error",      "-f",
                                 "image2pipe", "-c:v", "png", "-framerate", fmt::format("{:g}", rate),
                                 "-i",         "-"};
  for (std::string& w : encoding()) words.push_back(std::move(w));
  words.insert(words.end(), {"-f", "mp4", part.string()});
  std::vector<char*> arguments;
  for (std::string& w : words) arguments.push_back(w.data());
  arguments.push_back(nullptr);

  int in[2], err[2];
  if (pipe2(in, O_CLOEXEC) != 0) throw IoError(part.string(), std::strerror(errno));
  Descriptor inRead{in[0]}, inWrite{in[1]};
  if (pipe2(err, O_CLOEXEC) != 0) throw IoError(part.string(), std::strerror(errno));
  Descriptor errRead{err[0]}, errWrite{err[1]};
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, inRead.number, 0);
  posix_spawn_file_actions_adddup2(&actions, errWrite.number, 2);
  pid_t child = 0;
  const int failed = posix_spawnp(&child, "ffmpeg", &actions, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  if (failed) throw IoError(part.string(), std::string("ffmpeg cannot be started: ") + std::strerror(failed));
  inRead.close(), errWrite.close();

  auto* const before = std::signal(SIGPIPE, SIG_IGN);  // ffmpeg may exit before it has read all
  std::string problem;
  try {
    for (const fs::path& picture : pictures)
      if (!writeAll(inWrite.number, contentOf(picture))) break;
  } catch (const IoError& error) { problem = error.what(); }
  inWrite.close();
  std::signal(SIGPIPE, before);
  char buffer[4096];
  for (ssize_t n; (n = ::read(errRead.number, buffer, sizeof buffer)) != 0;) {
    if (n < 0 && errno != EINTR) break;
    if (n > 0) said.append(buffer, static_cast<std::size_t>(n));
  }
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {}
  if (!problem.empty()) throw std::runtime_error(problem);
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128;
}

}  // namespace

bool isInstalled(const std::string& program) {
  const char* path = std::getenv("PATH");
  std::istringstream folders(path ? path : "/usr/local/bin:/usr/bin:/bin");
  for (std::string folder; std::getline(folders, folder, ':');)
    if (access((fs::path(folder) / program).c_str(), X_OK) == 0) return true;
  return false;
}

std::string movieCommand(const std::vector<fs::path>& pictures, const fs::path& file, double rate) {
  std::string pattern = pictures.empty() ? "*.png" : pictures.front().string();
  const std::size_t end = pattern.rfind(".png"), digits = pattern.find_last_not_of("0123456789", end - 1);
  if (end != std::string::npos && digits != std::string::npos)
    pattern.replace(digits + 1, end - digits - 1, "*");
  std::string command = fmt::format("ffmpeg -framerate {:g} -pattern_type glob -i '{}'", rate, pattern);
  for (const std::string& w : encoding())
    command += w.find('(') == std::string::npos ? " " + w : " '" + w + "'";
  return command + " '" + file.string() + "'";
}

void makeMovie(const std::vector<fs::path>& pictures, const fs::path& file, double rate) {
  fs::path part = file;
  part += ".part";
  if (file.has_parent_path()) fs::create_directories(file.parent_path());
  std::string said;
  std::error_code error;
  try {
    const int code = encode(pictures, part, rate, said);
    while (!said.empty() && said.back() == '\n') said.pop_back();
    if (code != 0)
      throw IoError(file.string(),
                    "ffmpeg failed" + (said.empty() ? fmt::format(" with exit code {}", code) : ": " + said));
    fs::rename(part, file, error);
    if (error) throw IoError(file.string(), "cannot be written: " + error.message());
  } catch (...) {
    fs::remove(part, error);
    throw;
  }
}

}  // namespace thaw
