#include "io/scene/read_shape.hpp"

#include <filesystem>

namespace thaw {
namespace {

void readPlace(TableReader& r, Shape& s) {
  r.table("place", "where the shape stands: scaled, then turned about x, y and z, then moved", [&](TableReader& p) {
    p.number("scale", s.scale, "", positive(), "factor of size");
    p.number("rotate_x", s.rotate.x, "rad", anyNumber(), "angle about x");
    p.number("rotate_y", s.rotate.y, "rad", anyNumber(), "angle about y, after x");
    p.number("rotate_z", s.rotate.z, "rad", anyNumber(), "angle about z, last");
    p.vector("move", s.move, "m", "where the shape's own origin comes to lie");
    p.number("height", s.fitHeight, "m", positive(), "scales the turned shape to this height (its extent along z), in place of scale");
    p.vector("bottom", s.bottom, "m", "puts the middle of the lowest face of the bounding box here, in place of move");
  });
}

void readParts(TableReader& r, const char* key, ShapeKind kind, Shape& s, const std::string& folder, const char* about) {
  if (r.describing()) {
    r.node(key, "list of shapes", about);
    return;
  }
  if (!r.has(key)) return;
  s.kind = kind;
  r.tables(key, about, [&](TableReader& part) {
    s.parts.emplace_back();
    readShape(part, s.parts.back(), folder, true);
  });
  if (s.parts.empty() || (kind == ShapeKind::Difference && s.parts.size() < 2)) r.fail(key, "expected at least " + std::string(kind == ShapeKind::Difference ? "two shapes" : "one shape"));
}

}  // namespace

void readShape(TableReader& r, Shape& s, const std::string& folder, bool required) {
  s.where = r.place();
  int given = 0;
  const auto one = [&](const char* key, ShapeKind kind) {
    if (!r.has(key)) return;
    s.kind = kind;
    if (++given == 2) r.fail(key, "a second shape; a body has one, unions and differences hold several");
  };
  one("mesh", ShapeKind::Mesh);
  one("box", ShapeKind::Box);
  one("sphere", ShapeKind::Sphere);
  one("cylinder", ShapeKind::Cylinder);
  one("torus", ShapeKind::Torus);
  one("glass", ShapeKind::Glass);
  one("plane", ShapeKind::HalfSpace);
  one("union", ShapeKind::Union);
  one("difference", ShapeKind::Difference);
  one("intersection", ShapeKind::Intersection);
  if (given == 0 && required) r.fail(r.place(), r.path() + ": a shape is missing: one of mesh, box, sphere, cylinder, torus, glass, plane, union, difference, intersection");

  std::string mesh;
  r.text("mesh", mesh, "closed mesh (OBJ, PLY or STL; relative to this file), or \"builtin:bust\"");
  if (!mesh.empty()) s.mesh = mesh.rfind("builtin:", 0) == 0 ? mesh : (std::filesystem::path(folder) / mesh).lexically_normal().string();
  r.table("box", "box around its own origin", [&](TableReader& t) {
    t.vector("size", s.size, "m", "edge lengths");
    if (!t.describing() && !(s.size.x > 0 && s.size.y > 0 && s.size.z > 0)) t.fail("size", "edge lengths must be > 0");
  });
  r.table("sphere", "ball around its own origin", [&](TableReader& t) { t.number("radius", s.radius, "m", positive(), "radius"); });
  r.table("cylinder", "cylinder around its own origin, along z", [&](TableReader& t) {
    t.number("radius", s.radius, "m", positive(), "radius");
    t.number("height", s.height, "m", positive(), "length along z");
  });
  r.table("torus", "ring around its own origin, in the plane z = 0", [&](TableReader& t) {
    t.number("radius", s.radius, "m", positive(), "of the ring");
    t.number("tube", s.radius2, "m", positive(), "of the tube");
    if (!t.describing() && s.radius2 >= s.radius) t.fail("tube", "must be less than the radius of the ring");
  });
  r.table("glass", "drinking glass standing on its own z = 0, open at the top", [&](TableReader& t) {
    t.number("radius", s.radius, "m", positive(), "outer radius");
    t.number("height", s.height, "m", positive(), "height");
    t.number("thickness", s.thickness, "m", positive(), "of wall and floor");
    if (!t.describing() && (s.thickness >= s.radius || s.thickness >= s.height)) t.fail("thickness", "must be less than radius and height");
  });
  r.table("plane", "half-space; solid on the side that the normal points away from", [&](TableReader& t) {
    t.vector("point", s.point, "m", "a point of the plane");
    t.vector("normal", s.normal, "", "out of the solid, of any length");
    if (!t.describing() && length(s.normal) == 0) t.fail("normal", "must not be zero");
  });
  readParts(r, "union", ShapeKind::Union, s, folder, "shapes joined");
  readParts(r, "difference", ShapeKind::Difference, s, folder, "the first shape less all the others");
  readParts(r, "intersection", ShapeKind::Intersection, s, folder, "what all shapes share");
  readPlace(r, s);
}

}  // namespace thaw
