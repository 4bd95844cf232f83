// SPDX-License-Identifier: Apache-2.0
// Frames of a run by number: each has files of up to four types of points.
#pragma once
#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace thaw {

enum class PointType { Particles, Surface, Sheet, Oriented };
inline constexpr std::array<const char*, 4> pointTypeNames{"particles", "surface", "sheet", "oriented"};
std::optional<PointType> pointTypeNamed(const std::string& name);

struct ListedFrame {
  std::int64_t number = 0;
  double time = 0;            ///< s
  std::array<bool, 4> has{};  ///< by PointType
};

struct FrameList {
  std::string scene;                ///< name in the files; empty without frames
  std::vector<ListedFrame> frames;  ///< ascending by number
  std::uint64_t revision = 0;       ///< differs after each change of an index
  const ListedFrame* find(std::int64_t number) const;
};

/// Reads the indices of a run's frames. An index that is being replaced or is damaged counts as empty.
/// Entries that are not plain file names of this run's frames are skipped. Throws IoError if the folder has
/// frames of several scenes.
FrameList readFrameList(const std::filesystem::path& run);

/// Returns the file of a frame. It is made of scene, type and number alone.
std::filesystem::path framePath(const std::filesystem::path& run, const std::string& scene, PointType type,
                                std::int64_t number);

}  // namespace thaw
