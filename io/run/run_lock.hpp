// One run a folder: OUT/lock names the process that writes there, from before the first file until after the
// last.
#pragma once
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

#include "io/run/process_mark.hpp"

namespace thaw {

inline constexpr const char* lockName = "lock";

/// Who holds a folder. A lock that cannot be read has no process.
struct LockHolder {
  ProcessMark process;
  int ranks = 0;
  std::string since;  ///< UTC
  std::string text;   ///< content of the file
};

/// The holder of the lock in a run's folder; nothing where there is no lock.
std::optional<LockHolder> lockHolder(const std::string& out);
/// "process 12 on node3 (4 ranks, since 2030-01-02T03:04:05Z)".
std::string holderText(const LockHolder& holder);
/// The same with what is known of the process, and as JSON: of `thaw info`.
std::string lockText(const nlohmann::ordered_json& lock);
nlohmann::ordered_json lockJson(const LockHolder& holder);

struct LockRequest {
  std::string out;  ///< folder; made where it is missing
  int ranks = 1;
  bool force = false;   ///< take a lock of another host, or one that cannot be read
  double patience = 1;  ///< s for which a holder on this host may still be ending
};

/// The lock of this process on a folder. Of one process only: rank 0. A process that is killed leaves the
/// file. The file appears whole, by a hard link; where there are no hard links by O_EXCL. Both hold on NFS.
class RunLock {
 public:
  RunLock() = default;
  RunLock(const RunLock&) = delete;
  RunLock& operator=(const RunLock&) = delete;
  ~RunLock() { release(); }
  /// Takes the lock. Returns a line about the lock of a dead process, or a forced one, that it replaces; else
  /// nothing. IoError where another process holds it.
  std::string take(const LockRequest& request);
  /// Removes the file, unless another process has taken it by force.
  void release() noexcept;

 private:
  std::string path_, text_;
};

}  // namespace thaw
