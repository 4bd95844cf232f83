// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "core/geometry/basic/extension_shape.hpp"
#include "core/geometry/basic/shape_error.hpp"
#include "core/geometry/builtin/builtin_meshes.hpp"
#include "core/geometry/shapes/combined.hpp"
#include "core/geometry/shapes/mesh_distance.hpp"
#include "core/geometry/shapes/primitives.hpp"
#include "core/math/digits.hpp"

namespace thaw {
namespace {

void needPositive(const Shape& s, const char* what, double value) {
  if (!(value > 0 && std::isfinite(value)))
    throw ShapeError(std::string(what) + " is " + inDigits(value) + " m; expected a positive length",
                     s.where);
}

ShapePart makeMesh(const Shape& s, const MeshLoader& load) {
  try {
    if (isBuiltin(s.mesh)) return std::make_shared<MeshDistance>(builtinMesh(s.mesh), s.mesh);
    if (namesBuiltin(s.mesh))
      throw ShapeError("unknown built-in mesh '" + s.mesh + "'; expected " + builtinList);
    if (!load) throw ShapeError("mesh '" + s.mesh + "': no mesh reader is available");
    return std::make_shared<MeshDistance>(load(s.mesh), s.mesh);
  } catch (const ShapeError& e) {
    const std::string message = e.what();
    throw ShapeError(message.find(s.mesh) == std::string::npos ? s.mesh + ": " + message : message, s.where);
  } catch (const std::exception& e) { throw ShapeError(e.what(), s.where); }
}

ShapePart makeCombined(const Shape& s, CombinedDistance::Kind kind, const MeshLoader& load) {
  if (s.parts.empty()) throw ShapeError("a union, difference or intersection has no parts", s.where);
  std::vector<ShapePart> parts;
  for (const Shape& p : s.parts) parts.push_back(makeSignedDistance(p, load));
  return std::make_shared<CombinedDistance>(kind, std::move(parts));
}

ShapePart makeExtension(const Shape& s) {
  const ShapeMaker* make = findExtensionShape(s.extension.name);
  if (!make) throw ShapeError("this program has no shape '" + s.extension.name + "'", s.where);
  try {
    ShapePart part = (*make)(s.extension);
    if (!part) throw std::invalid_argument("it made no shape");
    return part;
  } catch (const ShapeError& e) {
    if (e.where.line > 0) throw;
    throw ShapeError(e.what(), s.where);
  } catch (const std::exception& e) {
    throw ShapeError("the shape '" + s.extension.name + "': " + e.what(), s.where);
  }
}

ShapePart makeUnplaced(const Shape& s, const MeshLoader& load) {
  switch (s.kind) {
    case ShapeKind::Box:
      needPositive(s, "an edge of a box", std::min({s.size.x, s.size.y, s.size.z}));
      if (!isFinite(s.size)) throw ShapeError("the size of a box is not finite", s.where);
      return std::make_shared<BoxDistance>(s.size);
    case ShapeKind::Sphere:
      needPositive(s, "the radius of a sphere", s.radius);
      return std::make_shared<SphereDistance>(s.radius);
    case ShapeKind::Cylinder:
      needPositive(s, "the radius of a cylinder", s.radius);
      needPositive(s, "the height of a cylinder", s.height);
      return std::make_shared<RevolvedDistance>(cylinderOutline(s.radius, s.height));
    case ShapeKind::Torus:
      needPositive(s, "the radius of a torus", s.radius);
      needPositive(s, "the tube radius of a torus", s.radius2);
      return std::make_shared<TorusDistance>(s.radius, s.radius2);
    case ShapeKind::HalfSpace:
      if (!isFinite(s.point) || !isFinite(s.normal) || !(length(s.normal) > 0))
        throw ShapeError("a half-space needs a finite point and a normal that is not zero", s.where);
      return std::make_shared<HalfSpaceDistance>(s.point, s.normal);
    case ShapeKind::Glass:
      needPositive(s, "the radius of a glass", s.radius);
      needPositive(s, "the height of a glass", s.height);
      needPositive(s, "the thickness of a glass", s.thickness);
      if (s.thickness >= s.radius || s.thickness >= s.height)
        throw ShapeError("the thickness of a glass is " + inDigits(s.thickness) +
                             " m; expected less than its radius and its height",
                         s.where);
      return std::make_shared<RevolvedDistance>(glassOutline(s.radius, s.height, s.thickness));
    case ShapeKind::Mesh: return makeMesh(s, load);
    case ShapeKind::Union: return makeCombined(s, CombinedDistance::Kind::Union, load);
    case ShapeKind::Difference: return makeCombined(s, CombinedDistance::Kind::Difference, load);
    case ShapeKind::Intersection: return makeCombined(s, CombinedDistance::Kind::Intersection, load);
    case ShapeKind::Extension: return makeExtension(s);
  }
  throw ShapeError("unknown kind of shape", s.where);
}

}  // namespace

Placement placementOf(const Shape& s, const ShapePart& part) {
  if (!isFinite(s.rotate) || !isFinite(s.move))
    throw ShapeError("the placement of a shape is not finite", s.where);
  Placement p;
  if (!(s.rotate == Vec3d{})) p.rotation = rotationXyz(s.rotate);
  if (s.fitHeight) {
    needPositive(s, "the height of a shape's placement", *s.fitHeight);
    const Bounds b = PlacedDistance(part, p).bounds();
    const double height = b.max.z - b.min.z;
    if (!(height > 0 && std::isfinite(height)))
      throw ShapeError("a shape of infinite height cannot be scaled to a height", s.where);
    p.scale = *s.fitHeight / height;
  } else {
    needPositive(s, "the scale of a shape", s.scale);
    p.scale = s.scale;
  }
  p.move = s.move;
  if (s.bottom) {
    if (!isFinite(*s.bottom)) throw ShapeError("the bottom of a shape is not finite", s.where);
    p.move = {};
    const Bounds b = PlacedDistance(part, p).bounds();
    p.move = *s.bottom - Vec3d{0.5 * (b.min.x + b.max.x), 0.5 * (b.min.y + b.max.y), b.min.z};
    if (!isFinite(p.move)) throw ShapeError("place.bottom: the shape is infinite; use place.move", s.where);
  }
  return p;
}

std::shared_ptr<const SignedDistance> makeSignedDistance(const Shape& s, const MeshLoader& load) {
  ShapePart part = makeUnplaced(s, load);
  const Placement p = placementOf(s, part);
  if (p.scale == 1 && p.move == Vec3d{} && s.rotate == Vec3d{}) return part;
  return std::make_shared<PlacedDistance>(part, p);
}

std::shared_ptr<const SignedDistance> makeSignedDistance(const Shape& shape, const MeshLoader& load,
                                                         const std::string& whose, SceneProblems& problems) {
  try {
    return makeSignedDistance(shape, load);
  } catch (const ShapeError& e) {
    problems.add(e.where.line > 0 ? e.where : shape.where, whose + ": " + e.what());
    return nullptr;
  }
}

}  // namespace thaw
