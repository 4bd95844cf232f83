// SPDX-License-Identifier: Apache-2.0
// Replies of `thaw view`. Addresses begin with the token; behind it are the files of the page and
//   api/run       state of the run; its frames if `frames` is not their revision
//   api/scene     camera, colours, domain        api/obstacles  their triangles (packet)
//   api/marks     lines of emitters, clamps and the camera (packet)
//   api/frame     `number`, `type`, `field`, `part`, `most`: a packet (frame_packet.hpp)
//   api/mesh      `number`, `type`, `most`: a surface as triangles (packet, mesh_packet.hpp)
//   api/point     as api/frame, and `index` or `id`: all fields of one point
//   api/log       `file`, `columns`, `rows`, `known`: a CSV file (log_rows.hpp)
//   api/stop      POST: stops a live run with a checkpoint
#pragma once
#include <filesystem>
#include <mutex>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/scene/scene.hpp"
#include "io/view/server/mesh_cache.hpp"
#include "io/view/server/request.hpp"

namespace thaw {

struct ViewState {
  std::filesystem::path run;
  std::string token;
  /// The address /open/ONCE leads to the page one time. Arguments of a started browser are visible to all
  /// users of a machine, and so have no token.
  std::string once = {};

  std::mutex mutex = {};  ///< HDF5 is not thread-safe
  std::optional<Scene> scene = {};
  std::string sceneFrom = {};  ///< frame and time of its file
  MeshCache meshes = {};       ///< made without the mutex, so that other requests go on
};

/// Returns the reply to a request. Refuses requests of other sites (request_origin.hpp) and without the
/// token. Never throws: problems of files are replies with status 422 and a text in JSON.
ViewReply answer(ViewState& state, const ViewRequest& request);

/// Headers of all replies: no other site may embed, read or cache them.
const std::vector<std::pair<std::string, std::string>>& replyHeaders();

}  // namespace thaw
