// SPDX-License-Identifier: Apache-2.0
// A frame in a page without a server: as framePacket, with all fields and ids, quantised and compressed.
#pragma once
#include <string>
#include <vector>

#include "io/surface_mesh/unwrap_component.hpp"
#include "io/view/frames/frame_packet.hpp"

namespace thaw {

struct BlockRequest {
  std::string path;
  PointType type = PointType::Particles;
  std::uint64_t most = 100000;  ///< as in FrameRequest
  double spacing = 0;           ///< m, of particles or surfels: positions are kept to 1/64 of it; 0: unknown
  bool tensors = true;          ///< with fields of six components
};

struct FrameBlock {
  std::string stream;  ///< compressed packet
  std::uint64_t points = 0;
  double level = 0;                  ///< one of 2^level points is in the block
  std::vector<std::string> tensors;  ///< names of the tensors of the frame
};

/// Returns the mesh of a surface (mesh_packet.hpp), quantised and compressed. Uses only path, most and
/// spacing of the request. Throws IoError.
std::string meshBlock(const BlockRequest& request, const PeriodicSides& sides);

/// poses: those of the obstacles at the time of the frame, for the header. Throws IoError.
FrameBlock frameBlock(const BlockRequest& request, const nlohmann::ordered_json& poses);

}  // namespace thaw
