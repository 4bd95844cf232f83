// SPDX-License-Identifier: Apache-2.0
#include "io/run/run_lock.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <thread>

#include "io/frames/series.hpp"
#include "io/hdf5/io_error.hpp"

using Json = nlohmann::ordered_json;

namespace thaw {
namespace {

using Wait = std::chrono::steady_clock;

std::string pathOf(const std::string& out) { return out + "/" + lockName; }

std::string ownText(int ranks) {
  const ProcessIdentity own = ownProcess();
  const Json j = {{"host", own.host},
                  {"pid", own.pid},
                  {"began_ticks", own.began},
                  {"ranks", ranks},
                  {"since", utcNow()}};
  return j.dump() + "\n";
}

LockHolder holderOf(const std::string& text) {
  LockHolder h;
  h.text = text;
  const Json j = Json::parse(text, nullptr, false);
  try {
    h.process = {j.at("host").get<std::string>(), j.at("pid").get<long>(),
                 j.at("began_ticks").get<long long>()};
    h.ranks = j.at("ranks").get<int>();
    h.since = j.at("since").get<std::string>();
  } catch (const Json::exception&) { h.process = {}; }
  return h;
}

struct File {
  int fd;
  explicit File(int f) : fd(f) {}
  File(const File&) = delete;
  File& operator=(const File&) = delete;
  ~File() {
    if (fd >= 0) ::close(fd);
  }
};

[[noreturn]] void failed(const std::string& path, const std::string& what) {
  throw IoError(path, what + ": " + std::strerror(errno));
}

/// Writes a new file. Returns false if one exists.
bool createWith(const std::string& path, const std::string& text) {
  const File file(::open(path.c_str(), O_CREAT | O_EXCL | O_WRONLY, 0666));
  if (file.fd < 0 && errno == EEXIST) return false;
  if (file.fd < 0) failed(path, "cannot be created");
  const bool written = ::write(file.fd, text.data(), text.size()) == static_cast<ssize_t>(text.size());
  if (!written || (::fsync(file.fd) != 0 && errno != EINVAL && errno != ENOTSUP)) {
    const int error = errno;
    ::unlink(path.c_str());
    errno = error;
    failed(path, "cannot be written");
  }
  return true;
}

/// Writes the text to a file of this process beside the lock. Returns its path.
std::string prepare(const std::string& path, const std::string& text) {
  const ProcessIdentity own = ownProcess();
  std::string aside = fmt::format("{}.{}.{}", path, own.host, own.pid);
  ::unlink(aside.c_str());  // left by a process with this number
  createWith(aside, text);
  return aside;
}

/// Makes the lock. Returns false if one exists.
bool create(const std::string& path, const std::string& text) {
  const std::string aside = prepare(path, text);
  const int result = ::link(aside.c_str(), path.c_str()), error = errno;
  struct stat about {};
  // NFS may lose the reply.
  const bool linked = result == 0 || (::stat(aside.c_str(), &about) == 0 && about.st_nlink == 2);
  ::unlink(aside.c_str());
  if (linked) return true;
  if (error == EEXIST) return false;
  return createWith(path, text);  // no hard links on this file system
}

/// Replaces the lock `old` by a new one. Returns false if it is no longer there. The kernel's lock on the old
/// file excludes other processes. Without such locks the text written last remains. The other process
/// detects that the text is not its own.
bool replace(const std::string& path, const LockHolder& old, const std::string& text) {
  const File file(::open(path.c_str(), O_RDWR));
  if (file.fd < 0 && errno == ENOENT) return false;
  if (file.fd < 0) failed(path, "cannot be opened");
  const bool guarded = ::flock(file.fd, LOCK_EX) == 0;
  struct stat opened {
  }, there{};
  if (::fstat(file.fd, &opened) != 0 || ::stat(path.c_str(), &there) != 0 || opened.st_ino != there.st_ino)
    return false;
  std::string now(old.text.size() + 1, '\0');
  if (::pread(file.fd, now.data(), now.size(), 0) != static_cast<ssize_t>(old.text.size()) ||
      now.compare(0, old.text.size(), old.text) != 0)
    return false;
  const std::string aside = prepare(path, text);
  if (::rename(aside.c_str(), path.c_str()) != 0) failed(path, "cannot be replaced");
  if (guarded) return true;
  std::this_thread::sleep_for(std::chrono::milliseconds(300));
  std::ifstream last(path);
  return std::string{std::istreambuf_iterator<char>(last), {}} == text;
}

/// Makes a folder and its missing parents. Returns the new folders, the innermost first.
std::vector<std::string> makeFolders(const std::string& folder) {
  std::vector<std::string> made;
  std::error_code error;
  for (std::filesystem::path p = folder; !p.empty() && !std::filesystem::exists(p, error);
       p = p.parent_path())
    if (p.has_filename()) made.push_back(p.string());
  makeFolder(folder);
  return made;
}

constexpr const char* advice = "wait until it ends, stop it, or choose another --out";

}  // namespace

std::optional<LockHolder> lockHolder(const std::string& out) {
  std::ifstream file(pathOf(out));
  if (!file) return std::nullopt;
  return holderOf({std::istreambuf_iterator<char>(file), {}});
}

std::string holderText(const LockHolder& h) {
  if (h.process.pid <= 0) return "a process that the lock does not name";
  return fmt::format("process {} on {} ({} rank{}, since {})", h.process.pid, h.process.host, h.ranks,
                     h.ranks == 1 ? "" : "s", h.since);
}

Json lockJson(const LockHolder& h) {
  constexpr const char* names[] = {"running", "gone", "unknown"};
  return {{"host", h.process.host},
          {"pid", h.process.pid},
          {"began_ticks", h.process.began},
          {"ranks", h.ranks},
          {"since", h.since},
          {"holder", names[static_cast<int>(processStateOf(h.process))]},
          {"text", holderText(h)}};
}

std::string lockText(const Json& j) {
  const std::string state = j.at("holder").get<std::string>(), text = j.at("text").get<std::string>();
  if (state == "running") return "by " + text;
  return fmt::format("by {}, {}", text,
                     state == "gone" ? "which has ended: the next run takes over"
                                     : "on another host: the next run needs --force");
}

std::string RunLock::take(const LockRequest& q) {
  made_ = makeFolders(q.out);
  const std::string path = pathOf(q.out), text = ownText(q.ranks);
  const auto start = Wait::now();
  const auto waited = [&] { return std::chrono::duration<double>(Wait::now() - start).count(); };
  for (bool tried = false; waited() < q.waitTime + 60; tried = true) {
    if (tried) std::this_thread::sleep_for(std::chrono::milliseconds(50));
    std::string note;
    if (create(path, text)) {
      path_ = path, text_ = text;
      return note;
    }
    const std::optional<LockHolder> holder = lockHolder(q.out);
    if (!holder) continue;  // the holder has just ended
    const ProcessState presence = processStateOf(holder->process);
    const std::string who = holderText(*holder);
    const bool elsewhere = presence == ProcessState::Unknown && holder->process.pid > 0;
    if (presence == ProcessState::Gone) {
      note = fmt::format("note: {} has ended and left its lock: this run takes over {}", who, q.out);
    } else if (presence == ProcessState::Unknown && q.force) {
      note = fmt::format("note: this run takes over {} from {} (--force)", q.out, who);
    } else {
      if (!elsewhere && waited() < q.waitTime) continue;  // The holder may be ending, or writing its lock.
      if (presence == ProcessState::Here)
        throw IoError(q.out, fmt::format("another run uses this folder: {}; {}", who, advice));
      throw IoError(
          q.out,
          fmt::format("another run may use this folder: {}; {}; if it has ended, --force takes the folder",
                      who, advice));
    }
    if (!replace(path, *holder, text)) continue;
    path_ = path, text_ = text;
    return note;
  }
  throw IoError(path, "cannot be acquired: it keeps changing; try again");
}

void RunLock::release() noexcept {
  if (path_.empty()) return;
  try {
    std::ifstream file(path_);
    if (std::string{std::istreambuf_iterator<char>(file), {}} == text_) ::unlink(path_.c_str());
  } catch (const std::exception&) {  // The file stays, as after a kill.
  }
  path_.clear();
  std::error_code error;
  for (const std::string& folder : made_)
    if (!std::filesystem::remove(folder, error)) break;  // not empty
}

}  // namespace thaw
