// SPDX-License-Identifier: Apache-2.0
// A frame for the page: positions, what its points look like, and one field.
#pragma once
#include <string>

#include "io/view/frames/field_values.hpp"
#include "io/view/frames/frame_list.hpp"
#include "io/view/frames/packet.hpp"

namespace thaw {

struct FrameRequest {
  std::string path;  ///< the file
  PointType type = PointType::Particles;
  FieldChoice field;            ///< left out if the frame lacks it
  std::uint64_t most = 100000;  ///< approximate number of drawn points; four times as many vertices of sheets
};

/// Returns the packet: `position`, and `normal`, `radius`, `colour`, `triangles`, `lines`, `value` or `label`
/// where the type has them. Its header has time, step, count and level (one of 2^level points is drawn). It
/// also has the points without finite position, the fields of the file and the range of the values. Requires
/// a file trailer: its checksum detects damage before HDF5 parses it. Throws IoError.
Packet framePacket(const FrameRequest& request);

/// A frame as read, without rows of non-finite positions. rows: the rows that framePacket draws, in its
/// order: one of 2^level.
struct ThinnedFrame {
  FrameData frame;
  std::vector<std::uint32_t> rows;
  double level = 0;
};

/// wanted: as for readFrame; the ids are read as well. Throws IoError.
ThinnedFrame readThinned(const FrameRequest& request, const std::function<bool(const std::string&)>& wanted);

}  // namespace thaw
