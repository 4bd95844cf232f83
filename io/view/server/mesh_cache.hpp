// SPDX-License-Identifier: Apache-2.0
// Meshes of surfaces, made in a thread of their own and kept by frame.
#pragma once
#include <cstdint>
#include <deque>
#include <functional>
#include <mutex>
#include <string>
#include <utility>

#include "io/view/frames/mesh_packet.hpp"

namespace thaw {

class MeshCache {
 public:
  static constexpr std::size_t mostBytes = 100'000'000;

  /// Returns the meshPacket stored under a key. If there is none, a thread makes it, one packet at a time.
  /// read: reads the surface, in the thread of the caller. idle: the thread has the lowest priority, so that
  /// it does not slow a run on this machine. Throws as `read` and meshPacket do.
  std::string packet(const std::string& key, const std::function<SurfaceToMesh()>& read,
                     const PeriodicSides& sides, bool idle);
  std::mutex& making() { return making_; }

 private:
  const std::string* find(const std::string& key) const;
  std::mutex making_, list_;
  std::deque<std::pair<std::string, std::string>> packets_;  // oldest first
  std::size_t bytes_ = 0;
};

}  // namespace thaw
