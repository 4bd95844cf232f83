// SPDX-License-Identifier: Apache-2.0
// Frames of oriented particles.
#pragma once
#include "core/oriented/mesh/triangulate.hpp"
#include "io/frames/frame.hpp"

namespace thaw {

/// A frame of oriented particles in the memory of one process, in the order of their ids. All vectors have
/// one element per particle.
struct OrientedFrame {
  double time = 0;  ///< s
  std::int64_t step = 0;
  std::vector<Vec3d> positions, normals;  ///< m; unit
  std::vector<Vec3d> tangents;            ///< image of e_x under the orientation
  std::vector<double> spacings;           ///< m
  std::vector<std::uint32_t> groups, bodies;
  std::vector<std::array<std::uint8_t, 3>> colours;  ///< sRGB
  std::vector<std::uint64_t> cutSides;
  std::vector<std::uint8_t> flags;
  std::vector<std::uint64_t> ids;  ///< empty if the frame has none
  OrientedPoints points() const { return {positions, normals, spacings, groups, cutSides}; }
};

bool isOrientedFrame(const FrameInfo& info);

/// Reads a frame. Throws IoError as readFrame, and for other frames.
OrientedFrame readOrientedFrame(const std::string& path);
/// Converts a frame in its own order of rows. Sort them by id first (io/frames/rows_by_id.hpp) for an order
/// that does not depend on ranks.
OrientedFrame orientedFrameOf(FrameData data, const std::string& path);

}  // namespace thaw
