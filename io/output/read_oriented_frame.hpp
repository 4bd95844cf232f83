// Frames of oriented particles.
#pragma once
#include "core/oriented/triangulate.hpp"
#include "io/output/frame.hpp"

namespace thaw {

/// A frame of oriented particles in memory of one process, in the order of their ids. All vectors have one
/// element a particle.
struct OrientedFrame {
  double time = 0;  ///< s
  std::int64_t step = 0;
  std::vector<Vec3d> positions, normals;  ///< m; unit
  std::vector<Vec3d> tangents;            ///< where its orientation turns e_x
  std::vector<double> spacings;           ///< m
  std::vector<std::uint32_t> groups, bodies;
  std::vector<std::array<std::uint8_t, 3>> colours;  ///< sRGB
  std::vector<std::uint64_t> cutSides;
  std::vector<std::uint8_t> flags;
  std::vector<std::uint64_t> ids;  ///< empty where the frame has none
  OrientedPoints points() const { return {positions, normals, spacings, groups, cutSides}; }
};

bool isOrientedFrame(const FrameInfo& info);

/// IoError as readFrame, and for frames of something else.
OrientedFrame readOrientedFrame(const std::string& path);
/// Of a frame's rows as they stand: order them by id (io/output/rows_by_id.hpp) before where the order has to
/// be the same on any ranks.
OrientedFrame orientedFrameOf(FrameData data, const std::string& path);

}  // namespace thaw
