#include "io/commands/scene_for_all.hpp"

#include "io/meshes/read_mesh.hpp"
#include "io/scene/read_scene.hpp"

namespace thaw {
namespace {

void broadcast(const Communicator& comm, std::string& text) {
  std::uint64_t n = text.size();
  MPI_Bcast(&n, 1, MPI_UINT64_T, 0, comm.handle());
  text.resize(n);
  MPI_Bcast(text.data(), static_cast<int>(n), MPI_CHAR, 0, comm.handle());
}

void broadcast(const Communicator& comm, std::map<std::string, std::string>& all) {
  std::uint64_t n = all.size();
  MPI_Bcast(&n, 1, MPI_UINT64_T, 0, comm.handle());
  std::map<std::string, std::string> copy;
  auto at = all.begin();
  for (std::uint64_t k = 0; k < n; k++) {
    std::string key = comm.rank() == 0 ? at->first : "", value = comm.rank() == 0 ? (at++)->second : "";
    broadcast(comm, key);
    broadcast(comm, value);
    copy[key] = std::move(value);
  }
  all = std::move(copy);
}

}  // namespace

Scene sceneForAll(const Communicator& comm, const std::string& path, const std::vector<std::string>& overrides) {
  SceneFiles files;
  if (comm.rank() == 0) files = loadSceneFiles(path);
  files.main = path;
  broadcast(comm, files.texts);
  broadcast(comm, files.problems);
  return readScene(files, overrides);
}

MeshLoader meshLoader() {
  return [](const std::string& path) { return readMesh(path); };
}

}  // namespace thaw
