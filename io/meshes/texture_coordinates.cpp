// SPDX-License-Identifier: Apache-2.0
#include "io/meshes/texture_coordinates.hpp"

#include "io/meshes/read_mesh.hpp"

namespace thaw {

namespace {

TexturedMesh parseTextured(std::string_view content, const std::string& file) {
  content = withoutByteOrderMark(content);
  const MeshFormat format = meshFormatOf(content, file);
  if (format == MeshFormat::Ply) return parseTexturedPly(content, file);
  const bool hasUv = content.starts_with("vt ") || content.find("\nvt ") != std::string_view::npos;
  if (format == MeshFormat::Obj && hasUv) return parseTexturedObj(content, file);
  return {parseMesh(content, file), {}};
}

}  // namespace

TexturedMesh readTexturedMesh(const std::string& path) {
  TexturedMesh mesh;
  readMeshFile(path, [&](std::string_view content) { mesh = parseTextured(content, path); });
  return mesh;
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
