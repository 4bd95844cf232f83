// SPDX-License-Identifier: Apache-2.0
#include "io/scene/tables/read_shape.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "core/geometry/builtin/builtin_meshes.hpp"
#include "io/scene/tables/read_extension.hpp"

namespace thaw {

void readPlace(TableReader& r, Shape& s) {
  r.table("place", "position of the shape: scaled, then rotated about x, y and z, then moved",
          [&](TableReader& p) {
            p.number("scale", s.scale, "", positive(), "scale factor");
            p.number("height", s.fitHeight, "m", positive(),
                     "scales the rotated shape to this extent along z; instead of scale");
            p.number("rotate_x", s.rotate.x, "rad", anyNumber(), "angle about x");
            p.number("rotate_y", s.rotate.y, "rad", anyNumber(), "angle about y, after x");
            p.number("rotate_z", s.rotate.z, "rad", anyNumber(), "angle about z, last");
            p.vector("move", s.move, "m", "position of the shape's own origin");
            p.vector("bottom", s.bottom, "m",
                     "position of the middle of the lowest face of the bounding box; instead of move");
            if (p.has("scale") && p.has("height")) p.fail("height", "give `scale` or `height`, not both");
            if (p.has("move") && p.has("bottom")) p.fail("bottom", "give `move` or `bottom`, not both");
          });
}

namespace {

constexpr const char* allShapes =
    "mesh, box, sphere, cylinder, torus, glass, plane, union, difference or intersection";
/// Names of all shapes, with those of extensions.
std::string shapeNames() {
  std::string names = allShapes;
  for (const std::string& name : extensionShapes()) names += ", or " + name;
  return names;
}

constexpr std::size_t deepest = 500;  // longest path in messages: limits nesting long before the stack
                                      // overflows

bool meshEnding(std::string path) {
  std::transform(path.begin(), path.end(), path.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  for (const char* ending : {".obj", ".ply", ".stl"})
    if (path.size() > 4 && path.compare(path.size() - 4, 4, ending) == 0) return true;
  return false;
}

constexpr const char* aboutMesh =
    "closed mesh: OBJ, PLY or STL, relative to the file that names it; or \"builtin:bust\" or "
    "\"builtin:head\", both 1 m tall. Its surfels have the normals of the file (PLY nx ny nz, OBJ vn). "
    "Smooth normals from the triangles replace missing ones, and those that are 0 or point to the other side "
    "of their triangle. The run reports how many";

void checkMeshPath(TableReader& r, const std::string& path) {
  if (path.empty()) {
    if (r.has("mesh"))
      r.fail("mesh", "expected the path of an OBJ, PLY or STL file, or " + std::string(builtinList));
  } else if (namesBuiltin(path)) {
    if (!isBuiltin(path))
      r.fail("mesh", "unknown built-in mesh '" + path.substr(8) + "'; expected " + builtinList);
  } else if (!meshEnding(path)) {
    r.fail("mesh", "expected a file that ends in .obj, .ply or .stl, got \"" + path + "\"");
  }
}

void readSolids(TableReader& r, Shape& s) {
  r.table("box", "box around its own origin", s.kind == ShapeKind::Box, [&](TableReader& t) {
    t.vector("size", s.size, "m", "edge lengths, > 0");
    if (t.reading() && !(s.size.x > 0 && s.size.y > 0 && s.size.z > 0))
      t.fail("size", "edge lengths must be > 0 m");
  });
  r.table("sphere", "ball around its own origin", s.kind == ShapeKind::Sphere,
          [&](TableReader& t) { t.number("radius", s.radius, "m", positive(), "radius of the sphere"); });
  r.table("cylinder", "cylinder around its own origin, along z", s.kind == ShapeKind::Cylinder,
          [&](TableReader& t) {
            t.number("radius", s.radius, "m", positive(), "radius of the cylinder");
            t.number("height", s.height, "m", positive(), "length along z");
          });
  r.table("torus", "ring around its own origin, in the plane z = 0", s.kind == ShapeKind::Torus,
          [&](TableReader& t) {
            t.number("radius", s.radius, "m", positive(), "radius of the ring");
            t.number("tube", s.radius2, "m", positive(), "radius of the tube, less than that of the ring");
            if (s.radius2 >= s.radius) t.fail("tube", "must be less than the radius of the ring");
          });
  r.table("glass", "drinking glass standing on its own z = 0, open at the top", s.kind == ShapeKind::Glass,
          [&](TableReader& t) {
            t.number("radius", s.radius, "m", positive(), "outer radius of the glass");
            t.number("height", s.height, "m", positive(), "height of the glass");
            t.number("thickness", s.thickness, "m", positive(), "thickness of wall and floor");
            if (s.thickness >= std::min(s.radius, s.height))
              t.fail("thickness", "must be less than `radius` and `height`");
          });
  r.table("plane", "half-space: solid on the side that the normal points away from",
          s.kind == ShapeKind::HalfSpace, [&](TableReader& t) {
            t.vector("point", s.point, "m", "a point of the plane");
            t.vector("normal", s.normal, "", "normal out of the solid; any length but 0");
            if (length(s.normal) == 0) t.fail("normal", "must not be zero: expected a direction");
          });
}

void readParts(TableReader& r, const char* key, ShapeKind kind, Shape& s) {
  if (r.recording() ? s.kind != kind : !r.has(key)) return;
  if (r.reading() && r.path().size() > deepest)
    return r.fail(r.place(), "shapes are nested too deeply: expected fewer levels of nesting");
  if (r.reading()) s.parts.clear();
  r.tables(key, "", s.parts, readShape);
  const std::size_t least = kind == ShapeKind::Union ? 1 : 2;
  if (s.parts.size() < least)
    r.fail(key,
           least == 1 ? "expected a list of at least one shape" : "expected a list of at least two shapes");
}

struct Key {
  const char* key;
  ShapeKind kind;
  const char* about;
};
constexpr Key parts[] = {{"union", ShapeKind::Union, "shapes joined"},
                         {"difference", ShapeKind::Difference, "the first shape without all the others"},
                         {"intersection", ShapeKind::Intersection, "the common part of all shapes"}};
constexpr Key solids[] = {{"mesh", ShapeKind::Mesh, ""},      {"box", ShapeKind::Box, ""},
                          {"sphere", ShapeKind::Sphere, ""},  {"cylinder", ShapeKind::Cylinder, ""},
                          {"torus", ShapeKind::Torus, ""},    {"glass", ShapeKind::Glass, ""},
                          {"plane", ShapeKind::HalfSpace, ""}};

}  // namespace

void readShape(TableReader& r, Shape& s) {
  if (r.describing()) {
    r.node("SHAPE", "", allShapes, "its shape, one key, and `place`: see `SHAPE` below");
    return;
  }
  if (r.reading()) s.where = r.place();
  int given = 0;
  const auto one = [&](const Key& k) {
    if (!r.has(k.key)) return;
    s.kind = k.kind;
    if (++given == 2) r.fail(k.key, "a second shape; expected one, or a union of several");
  };
  for (const Key& k : solids) one(k);
  for (const Key& k : parts) one(k);
  for (const std::string& name : extensionShapes()) {
    one({name.c_str(), ShapeKind::Extension, ""});
    if (r.has(name)) s.extension.name = name;
  }
  // Errors of a file are reported where it is named.
  if (s.kind == ShapeKind::Mesh && r.has("mesh")) s.where = r.placeOf("mesh");
  if (given == 0) r.fail(r.place(), r.path() + ": has no shape; expected one of " + shapeNames());
  readMesh(r, s, aboutMesh);
  readSolids(r, s);
  readExtensionShape(r, s);
  for (const Key& k : parts) {
    r.node(k.key, "", "", k.about);
    readParts(r, k.key, k.kind, s);
  }
  readPlace(r, s);
}

void readMesh(TableReader& r, Shape& s, const char* about) {
  const MeshFingerprint& f = s.meshFingerprint;
  if (r.recording() && !s.mesh.empty())
    r.node("mesh", "", "", "",
           fmt::format("{} vertices and {} triangles with checksum {}", f.vertices, f.triangles, f.checksum));
  if (r.recording()) return;
  r.text("mesh", s.mesh, about, "path or \"builtin:bust\"");
  if (r.reading()) checkMeshPath(r, s.mesh);
}

void readClamps(TableReader& r, std::vector<Shape>& clamps, const char* about) {
  // The description of a shape has a section of its own.
  if (r.describing()) r.node("clamp", "", "list of tables with a SHAPE each", about);
  else r.tables("clamp", "", clamps, readShape);
}

bool hasShape(const TableReader& r) {
  const auto there = [&](const Key& k) { return r.has(k.key); };
  return std::any_of(std::begin(solids), std::end(solids), there) ||
         std::any_of(std::begin(parts), std::end(parts), there) ||
         std::ranges::any_of(extensionShapes(), [&](const std::string& name) { return r.has(name); });
}

void refuseShape(TableReader& r, const char* why) {
  const auto refuse = [&](const Key& k) {
    if (!r.has(k.key)) return;
    r.node(k.key, "", "", "");
    r.fail(k.key, why);
  };
  for (const Key& k : solids) refuse(k);
  for (const Key& k : parts) refuse(k);
  for (const std::string& name : extensionShapes()) refuse({name.c_str(), ShapeKind::Extension, ""});
}

void describeShapes(TableReader& r) {
  Shape s;
  readMesh(r, s, aboutMesh);
  readSolids(r, s);
  readExtensionShape(r, s);
  for (const Key& k : parts) r.node(k.key, "", "list of tables with a SHAPE each", k.about);
  readPlace(r, s);
}

}  // namespace thaw
