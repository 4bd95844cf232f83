// SPDX-License-Identifier: Apache-2.0
#include "io/meshes/texture_coordinates.hpp"

#include <fstream>
#include <sstream>

#include "io/meshes/read_mesh.hpp"

namespace thaw {

TexturedMesh readTexturedMesh(const std::string& path) {
  readMesh(path);  // reports files that are no meshes
  std::ifstream in(path, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  const std::string content = text.str();
  if (content.starts_with("ply\n") || content.starts_with("ply\r")) return parseTexturedPly(content, path);
  const bool isText = content.find('\0') == std::string::npos;
  if (isText && (content.starts_with("vt ") || content.find("\nvt ") != std::string::npos))
    return parseTexturedObj(content, path);
  return {};
}

TextureLookup::TextureLookup(TexturedMesh mesh) : textured_(std::move(mesh)), tree_(textured_.mesh) {}

Uv TextureLookup::at(const Vec3d& x) const {
  const ClosestPoint closest = tree_.closest(x);
  const auto& t = textured_.mesh.triangles[closest.triangle];
  const auto& corners = textured_.uv[closest.triangle];
  std::array<double, 3> share{};
  double sum = 0;
  for (std::size_t k = 0; k < 3; k++) {
    const Vec3d a = textured_.mesh.vertices[t[(k + 1) % 3]] - closest.point,
                b = textured_.mesh.vertices[t[(k + 2) % 3]] - closest.point;
    share[k] = length(cross(a, b));
    sum += share[k];
  }
  Uv uv{0, 0};
  for (std::size_t k = 0; k < 3; k++)
    for (std::size_t c = 0; c < 2; c++)
      uv[c] += static_cast<float>(sum > 0 ? share[k] / sum : 1.0 / 3) * corners[k][c];
  return uv;
}

}  // namespace thaw
