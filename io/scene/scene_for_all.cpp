// SPDX-License-Identifier: Apache-2.0
#include "io/scene/scene_for_all.hpp"

#include <algorithm>

#include "core/geometry/basic/shape_error.hpp"
#include "io/hdf5/io_error.hpp"
#include "io/meshes/read_mesh.hpp"
#include "io/scene/read_scene.hpp"
#include "io/scene/text/path_names.hpp"

namespace thaw {

void broadcastText(const Communicator& comm, std::string& text) {
  std::uint64_t n = text.size();
  MPI_Bcast(&n, 1, MPI_UINT64_T, 0, comm.handle());
  text.resize(n);
  for (std::size_t done = 0; done < n; done += comm.chunk())  // in chunks, since MPI counts in 32 bits
    MPI_Bcast(text.data() + done, static_cast<int>(std::min(comm.chunk(), n - done)), MPI_CHAR, 0,
              comm.handle());
}

std::optional<Refusal> refusalOf(const std::exception& e) {
  if (const auto* shape = dynamic_cast<const ShapeError*>(&e); shape && shape->where.line > 0) {
    SceneProblems problem;
    problem.add(shape->where, e.what());
    return Refusal{withPaths(problem.lines().what()), exitUsage};
  }
  if (dynamic_cast<const SceneErrors*>(&e) || dynamic_cast<const ShapeError*>(&e))
    return Refusal{withPaths(e.what()), exitUsage};
  if (dynamic_cast<const IoError*>(&e)) return Refusal{std::string("error: ") + e.what(), exitInputOutput};
  return std::nullopt;
}

Scene sceneForAll(const Communicator& comm, const std::string& path,
                  const std::vector<std::string>& overrides) {
  std::string files;
  if (comm.rank() == 0) files = packSceneFiles(loadSceneFiles(path));
  broadcastText(comm, files);
  return readScene(unpackSceneFiles(files), overrides);
}

MeshLoader meshLoader() {
  return [](const std::string& path) { return readMesh(path); };
}

}  // namespace thaw
