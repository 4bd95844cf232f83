// SPDX-License-Identifier: Apache-2.0
#include "core/surface/seeding/sample_mesh.hpp"

#include <algorithm>
#include <cmath>

#include "core/domain/emit.hpp"
#include "core/geometry/builtin/bust.hpp"
#include "core/geometry/meshes/mesh_normals.hpp"
#include "core/geometry/sampling/blue_noise.hpp"
#include "core/geometry/shapes/overlap.hpp"
#include "core/geometry/shapes/placed_mesh.hpp"
#include "core/geometry/shapes/shape_mesh.hpp"
#include "core/geometry/trees/triangle_bvh.hpp"
#include "core/materials/enthalpy.hpp"
#include "core/math/tangent.hpp"
#include "core/solid/bonds/weight.hpp"

namespace thaw {
namespace {

/// Projects a sample of the bust's mesh onto the sculpture. Samples far from the sculpture remain.
void refineOnBust(const Placement& placed, SurfaceSample& s) {
  // m, for the bust of 1 m
  constexpr double step = 1e-4, near = 0.03;
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

// Largest distance of triangles from curved faces, in spacings.
constexpr double chord = 0.01;
// Spacings. At this distance from a face, one side is inside the body and the other outside.
constexpr double beside = 0.05;

/// Returns the unit normal of a mesh's triangle.
Vec3d outwardOf(const TriangleMesh& m, std::uint32_t triangle) {
  const auto& t = m.triangles[triangle];
  return normalized(cross(m.vertices[t[1]] - m.vertices[t[0]], m.vertices[t[2]] - m.vertices[t[0]]));
}

/// Samples in the mesh's own frame, so samples do not depend on the placement.
std::vector<SurfaceSample> sampleMesh(const Shape& shape, const MeshLoader& load, double spacing,
                                      std::uint64_t seed) {
  const PlacedMesh own = makePlacedMesh(withoutPlacement(shape), load);
  const Placement to = placementOfMesh(shape, own.mesh);
  const MeshNormals normals(own.mesh);
  std::shared_ptr<const SignedDistance> solid;
  if (own.report.closed && own.report.shells > 1) solid = makeSignedDistance(shape, load);
  std::vector<SurfaceSample> samples;
  for (const MeshSample& m : blueNoise(own.mesh, spacing / to.scale, seed)) {
    SurfaceSample s{to.move + to.rotation * (to.scale * m.position),
                    to.rotation * normals.at(m.position, m.triangle)};
    if (!own.mesh.colours.empty()) s.colour = normals.colourAt(m.position, m.triangle), s.coloured = true;
    if (shape.mesh == builtinBust) refineOnBust(to, s);
    if (solid && solid->inside(s.position + s.normal * (1e-3 * spacing))) continue;
    samples.push_back(s);
  }
  return samples;
}

/// The same for other shapes, in their own frames.
std::vector<SurfaceSample> sampleExact(const Shape& placed, const MeshLoader& load, double apart,
                                       std::uint64_t seed) {
  const Shape shape = withoutPlacement(placed);
  const std::shared_ptr<const SignedDistance> solid = makeSignedDistance(shape, load);
  const Placement to = placementOf(placed, solid);
  const double spacing = apart / to.scale, off = beside * spacing;
  const TriangleMesh mesh = shapeMesh(shape, chord * spacing, load);
  const MeshNormals normals(mesh);
  const MeshPart shown{[&](const Vec3d& middle, double reach) {
                         return std::abs(solid->distanceWithin(middle, reach + off)) <= reach + off;
                       },
                       [&](const Vec3d& x, std::uint32_t triangle) {
                         const Vec3d n = off * outwardOf(mesh, triangle);
                         return solid->inside(x - n) && !solid->inside(x + n);
                       }};
  const bool combined = !shape.parts.empty();
  std::vector<SurfaceSample> samples;
  for (const MeshSample& m : blueNoise(mesh, spacing, seed, combined ? &shown : nullptr)) {
    Vec3d x = m.position, gradient;
    const double d = solid->distanceWithin(x, 2 * off, &gradient);
    if (std::abs(d) < off) x -= d * gradient;
    samples.push_back(
        {to.move + to.rotation * (to.scale * x), to.rotation * normals.at(m.position, m.triangle)});
  }
  return samples;
}

/// Drops samples of faces that continue across a periodic side.
void dropBuried(const OverlapTest& body, double off, std::vector<SurfaceSample>& samples) {
  std::erase_if(samples,
                [&](const SurfaceSample& s) { return body.meetsItself(0, s.position + off * s.normal); });
}

}  // namespace

std::vector<SurfaceSample> sampleShape(const Shape& shape, const MeshLoader& load, double spacing,
                                       std::uint64_t seed) {
  return shape.kind == ShapeKind::Mesh ? sampleMesh(shape, load, spacing, seed)
                                       : sampleExact(shape, load, spacing, seed);
}

std::vector<SurfaceSample> sampleBody(const Scene& scene, std::size_t body, const MeshLoader& load,
                                      const Vec3d& period) {
  const double spacing = surfelSpacing(scene);
  const Shape& shape = scene.bodies[body].shape;
  std::vector<SurfaceSample> samples = sampleShape(shape, load, spacing, scene.seed + body);
  if (!(period == Vec3d{}))
    dropBuried(OverlapTest({makeSignedDistance(shape, load)}, period), beside * spacing, samples);
  return samples;
}

void sampleMeshes(const Scene& scene, Surface& surface, const MeshLoader& load, const Reducer& all) {
  Surfels& s = surface.surfels;
  const Vec3d period = periodsOf(surface.grid).length;
  for (std::size_t b = 0; b < scene.bodies.size(); b++) {
    if (!isSampled(scene, b)) continue;
    const std::vector<SurfaceSample> samples = sampleBody(scene, b, load, period);
    for (std::size_t k = static_cast<std::size_t>(all.rank()); k < samples.size();
         k += static_cast<std::size_t>(all.size())) {
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
      const PositionField& field = scene.bodies[b].temperatureField;
      if (s.temperature.active)
        s.temperature[i] = static_cast<float>(field ? field.value(samples[k].position)
                                                    : scene.bodies[b].temperature);
    }
  }
}

namespace {

/// Surface of a sampled body for projected births, loaded on first use.
struct BirthShape {
  std::shared_ptr<const SignedDistance> shape;
  std::unique_ptr<TriangleBvh> mesh;
  void load(const Body& b, const MeshLoader& load) {
    if (shape || mesh) return;
    if (b.shape.kind == ShapeKind::Mesh)
      mesh = std::make_unique<TriangleBvh>(makePlacedMesh(b.shape, load).mesh);
    else shape = makeSignedDistance(b.shape, load);
  }
};

/// Projects a surfel onto a mesh. On smooth faces it keeps its normal, interpolated from the neighbours.
/// Beside an edge, it takes the normal of the nearest face.
void putOnMesh(const TriangleBvh& mesh, double near, Surfels& s, std::size_t i) {
  constexpr double smooth = 0.95;
  const ClosestPoint at = mesh.closest(s.position[i], near);
  const double facing = dot(at.normal, s.normal[i]);
  if (!(at.distance2 < near * near) || facing < -0.5) return;
  s.position[i] = at.point;
  if (facing < smooth) s.normal[i] = at.normal, s.tangent[i] = anyTangent(at.normal);
}

void putOnShape(const SignedDistance& shape, double near, double off, Surfels& s, std::size_t i) {
  Vec3d gradient;
  const double d = shape.distanceWithin(s.position[i], near, &gradient);
  if (!(std::abs(d) < near) || dot(gradient, s.normal[i]) < -0.5) return;
  s.position[i] -= d * gradient;
  // Beyond an edge, the gradient belongs to neither face.
  shape.distanceWithin(s.position[i] - off * gradient, near, &s.normal[i]);
  s.tangent[i] = anyTangent(s.normal[i]);
}

}  // namespace

void putBirthsOnShapes(const Scene& scene, Surface& surface, const MeshLoader& load) {
  std::vector<BirthShape> shapes(scene.bodies.size());
  Surfels& s = surface.surfels;
  const double near = 0.5 * surface.spacing, off = beside * surface.spacing;
  for (std::size_t i = 0; i < s.owned; i++) {
    // The label of a component contains the id of a particle.
    const std::uint64_t body = sourceOf(s.component[i] - 1);
    if (!(s.id[i] & birthBit) || body >= shapes.size() || !isSampled(scene, body) ||
        scene.bodies[body].shape.mesh == builtinBust)
      continue;
    BirthShape& to = shapes[body];
    to.load(scene.bodies[body], load);
    if (to.mesh) putOnMesh(*to.mesh, near, s, i);
    else putOnShape(*to.shape, near, off, s, i);
  }
}

}  // namespace thaw
