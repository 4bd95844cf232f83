// SPDX-License-Identifier: Apache-2.0
#include "io/view/server/mesh_cache.hpp"

#include <sys/resource.h>
#include <unistd.h>

#include <future>
#include <optional>

namespace thaw {
namespace {

constexpr int lowestPriority = 19;

/// Lowers the priority of this thread alone: Linux has one for each thread.
void giveWay() { setpriority(PRIO_PROCESS, static_cast<id_t>(gettid()), lowestPriority); }

}  // namespace

const std::string* MeshCache::find(const std::string& key) const {
  for (const auto& [name, bytes] : packets_)
    if (name == key) return &bytes;
  return nullptr;
}

std::string MeshCache::packet(const std::string& key, const std::function<SurfaceToMesh()>& read,
                              const PeriodicSides& sides, bool idle) {
  const auto known = [&]() -> std::optional<std::string> {
    const std::lock_guard lock(list_);
    const std::string* bytes = find(key);
    return bytes ? std::optional(*bytes) : std::nullopt;
  };
  if (auto bytes = known()) return *bytes;
  const std::lock_guard one(making_);
  if (auto bytes = known()) return *bytes;  // made while this request waited
  const SurfaceToMesh surface = read();
  std::string bytes = std::async(std::launch::async, [&] {
                        if (idle) giveWay();
                        return meshPacket(surface, sides).bytes();
                      }).get();
  const std::lock_guard lock(list_);
  bytes_ += bytes.size();
  packets_.emplace_back(key, bytes);
  while (bytes_ > mostBytes && packets_.size() > 1) {
    bytes_ -= packets_.front().second.size();
    packets_.pop_front();
  }
  return bytes;
}

}  // namespace thaw
