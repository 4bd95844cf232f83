// SPDX-License-Identifier: Apache-2.0
#include "io/view/run/stop_request.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "io/run/run_lock.hpp"

namespace thaw {

bool mayBeLive(const std::filesystem::path& run) {
  const std::optional<LockHolder> holder = lockHolder(run.string());
  return holder && processStateOf(holder->process) != ProcessState::Gone;
}

std::string requestStop(const std::filesystem::path& run) {
  if (!mayBeLive(run)) return "no run is live in this folder";
  const std::string path = (run / stopName).string();
  const int file = ::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0666);
  if (file < 0 && errno != EEXIST) return path + ": cannot be made: " + std::strerror(errno);
  if (file >= 0) ::close(file);
  return {};
}

}  // namespace thaw
