// SPDX-License-Identifier: Apache-2.0
// The lock of a run folder. OUT/lock names the process that writes there. It exists from before the first
// file is written until after the last one.
#pragma once
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "io/run/reports/process_identity.hpp"

namespace thaw {

inline constexpr const char* lockName = "lock";

/// Holder of a folder. It has no process if the lock is unreadable.
struct LockHolder {
  ProcessIdentity process;
  int ranks = 0;
  std::string since;  ///< UTC
  std::string text;   ///< content of the file
};

/// Returns the holder of the lock in a run folder, or nothing without a lock.
std::optional<LockHolder> lockHolder(const std::string& out);
/// Returns "process 12 on node3 (4 ranks, since 2030-01-02T03:04:05Z)".
std::string holderText(const LockHolder& holder);
/// Returns the same with the state of the process, as text and as JSON, for `thaw info`.
std::string lockText(const nlohmann::ordered_json& lock);
nlohmann::ordered_json lockJson(const LockHolder& holder);

struct LockRequest {
  std::string out;  ///< folder; made where it is missing
  int ranks = 1;
  bool force = false;   ///< take the lock of another host, or an unreadable one
  double waitTime = 1;  ///< s, time in which a holder on this host may still end
};

/// Lock of this process on a folder. Rank 0 only. A killed process leaves the file. The file is complete when
/// it appears: it is created by a hard link, or by O_EXCL where there are no hard links. Both are safe on
/// NFS.
class RunLock {
 public:
  RunLock() = default;
  RunLock(const RunLock&) = delete;
  RunLock& operator=(const RunLock&) = delete;
  ~RunLock() { release(); }
  /// Takes the lock. Returns a note if it replaces the lock of an ended process, or one by force, else "".
  /// Throws IoError if another process holds the lock.
  std::string take(const LockRequest& request);
  /// Removes the file, unless another process has taken it by force. Also removes folders that take made, if
  /// they are empty, as after a scene with errors.
  void release() noexcept;

 private:
  std::string path_, text_;
  std::vector<std::string> made_;  ///< folders made for the lock, the innermost first
};

}  // namespace thaw
