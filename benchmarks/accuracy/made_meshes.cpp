#include "benchmarks/accuracy/made_meshes.hpp"

#include <cmath>

#include "core/geometry/polygonise.hpp"
#include "io/commands/scene_for_all.hpp"

namespace thaw::accuracy {
namespace {

TriangleMesh cube() {
  TriangleMesh m;
  for (int c = 0; c < 8; c++) m.vertices.push_back({c & 1 ? 1.0 : -1.0, c & 2 ? 1.0 : -1.0, c & 4 ? 1.0 : -1.0});
  m.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4}, {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  return m;
}

TriangleMesh ball(double bumps) {
  const auto outside = [bumps](const Vec3d& x) {
    const double r = length(x);
    const Vec3d u = r > 0 ? x / r : Vec3d{};
    return r - 1 - bumps * std::cos(9 * u.x) * std::cos(9 * u.y) * std::cos(9 * u.z);
  };
  return polygonise(outside, {{-1.2, -1.2, -1.2}, {1.2, 1.2, 1.2}}, 0.025);
}

}  // namespace

MeshLoader suiteMeshes() {
  return [files = meshLoader()](const std::string& path) {
    const std::string name = path.substr(path.rfind('/') + 1);  // scenes give files their folder
    if (name == "made_ball.obj") return ball(0);
    if (name == "made_bumps.obj") return ball(0.04);
    if (name == "made_cube.obj") return cube();
    return files(path);
  };
}

}  // namespace thaw::accuracy
