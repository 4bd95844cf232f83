#include "core/surface/sample_mesh.hpp"

#include <algorithm>
#include <cmath>

#include "core/domain/emit.hpp"
#include "core/geometry/bust.hpp"
#include "core/geometry/placed_mesh.hpp"
#include "core/surface/blue_noise.hpp"
#include "core/surface/mesh_normals.hpp"
#include "core/surface/tangent.hpp"

namespace thaw {
namespace {

/// Moves a sample of the bust's mesh onto the sculpture. It stays where it is where the sculpture is not near.
void refineOnBust(const Placement& placed, SurfaceSample& s) {
  constexpr double step = 1e-4, near = 0.03;  // m, of the bust of 1 m
  const Mat3d back = transpose(placed.rotation);
  const Vec3d start = back * (s.position - placed.move) / placed.scale;
  Vec3d x = start, gradient;
  for (int k = 0; k < 4; k++) {
    for (int a = 0; a < 3; a++) {
      Vec3d up = x, down = x;
      up[a] += step, down[a] -= step;
      gradient[a] = (bustValue(up) - bustValue(down)) / (2 * step);
    }
    const double g2 = dot(gradient, gradient);
    if (!(g2 > 0.01)) return;
    const double value = bustValue(x);
    if (k == 3 || std::abs(value) < 1e-7) break;
    x -= gradient * (value / g2);
  }
  const Vec3d n = placed.rotation * normalized(gradient);
  if (length(x - start) > near || dot(n, s.normal) < 0) return;
  s.position = placed.move + placed.rotation * (placed.scale * x);
  s.normal = n;
}

}  // namespace

bool hasMesh(const Scene& scene, std::size_t body) {
  return scene.surface.source == SurfelSource::Automatic && body < scene.bodies.size() && scene.bodies[body].shape.kind == ShapeKind::Mesh;
}

std::vector<SurfaceSample> sampleShape(const Shape& shape, const MeshLoader& load, double spacing, std::uint64_t seed) {
  const PlacedMesh placed = makePlacedMesh(shape, load);
  const MeshNormals normals(placed.mesh);
  std::shared_ptr<const SignedDistance> solid;
  if (placed.report.closed && placed.report.shells > 1) solid = makeSignedDistance(shape, load);
  std::vector<SurfaceSample> samples;
  for (const MeshSample& m : blueNoise(placed.mesh, spacing, seed)) {
    SurfaceSample s{m.position, normals.at(m.position, m.triangle)};
    if (!placed.mesh.colours.empty()) s.colour = normals.colourAt(m.position, m.triangle), s.coloured = true;
    if (shape.mesh == builtinBust) refineOnBust(placed.placement, s);
    if (solid && solid->inside(s.position + s.normal * (1e-3 * spacing))) continue;
    samples.push_back(s);
  }
  return samples;
}

void sampleMeshes(const Scene& scene, Surface& surface, const MeshLoader& load, const Reducer& all) {
  Surfels& s = surface.surfels;
  for (std::size_t b = 0; b < scene.bodies.size(); b++) {
    if (!hasMesh(scene, b)) continue;
    const std::vector<SurfaceSample> samples = sampleShape(scene.bodies[b].shape, load, surface.spacing, scene.seed + b);
    for (std::size_t k = static_cast<std::size_t>(all.rank()); k < samples.size(); k += static_cast<std::size_t>(all.size())) {
      const std::size_t i = s.owned;
      s.resize(i + 1, 0);
      s.id[i] = surfelBit | particleId(b, k);
      s.position[i] = samples[k].position;
      s.normal[i] = samples[k].normal;
      s.tangent[i] = anyTangent(samples[k].normal);
      s.radius[i] = surface.spacing;
      s.component[i] = noComponent;
      s.colour[i] = samples[k].coloured ? samples[k].colour : surfaceColour(scene, b);
      s.detail[i] = 1;
      if (s.temperature.active) s.temperature[i] = static_cast<float>(scene.bodies[b].temperature);
    }
  }
}

}  // namespace thaw
