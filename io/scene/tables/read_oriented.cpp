// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "core/geometry/builtin/builtin_meshes.hpp"
#include "io/scene/tables/read_sections.hpp"
#include "io/scene/tables/read_shape.hpp"
#include "io/scene/text/value_text.hpp"

namespace thaw {
namespace {

/// A list of points [[x, y, z], ...], each number with a unit or in the default one. there: whether a
/// recorded list is that of this key.
struct PointsKey {
  const char *key, *unit, *about;
  bool there = true;
};
void readPoints(TableReader& r, const PointsKey& k, std::vector<Vec3d>& points) {
  std::vector<std::string> texts;
  if (k.there) std::ranges::transform(points, std::back_inserter(texts), vectorText);
  const auto& [key, unit, about, there] = k;
  const toml::node* n = r.node(key, unit, "list of [x, y, z]", about, listText(texts));
  if (!n) return;
  const toml::array* list = n->as_array();
  if (!list) return r.refuseValue(key, "expected a list of points [x, y, z]");
  for (const toml::node& e : *list) {
    const toml::array* p = e.as_array();
    if (!p || p->size() != 3)
      return r.fail(placeOfNode(e), r.path() + "." + key + ": expected points [x, y, z]");
    Vec3d x;
    bool good = true;
    for (std::size_t a = 0; a < 3; a++)
      good = r.quantity(*p->get(a), key, unit, anyNumber(), x[static_cast<int>(a)]) && good;
    if (good) points.push_back(x);
  }
}

bool readsFile(const Shape& s) {
  return (s.kind == ShapeKind::Mesh && !namesBuiltin(s.mesh)) ||
         std::any_of(s.parts.begin(), s.parts.end(), [](const Shape& p) { return readsFile(p); });
}

void readConstraint(TableReader& r, OrientedConstraint& a) {
  r.restart(Restart::State);  // particles refer to constraints by their places in the list
  readShape(r, a.region);
  r.flag("position", a.position, "fixes particle positions");
  r.flag("normal", a.normal, "fixes particle orientations");
  r.restart(Restart::Coefficient);
  r.number("until", a.until, "s", orNever(notNegative()), "time at which the particles are released");
  readMotion(r,
             "keyframes of the constrained particles; linear in between, and constant before the first and "
             "after the last",
             a.motion);
  if (!a.position && !a.normal)
    r.fail(r.place(), r.path() + ": has no effect: set `position = true`, `normal = true`, or both");
}

void readField(TableReader& r, OrientedField& f) {
  r.restart(Restart::Coefficient);
  r.vector("acceleration", f.acceleration, "m/s^2", "uniform acceleration");
  r.vector("point", f.point, "m", "target point of the attraction");
  r.number("attraction", f.attraction, "m/s^2", anyNumber(),
           "largest acceleration toward the point; below 0: away from it. At u = distance / radius it is "
           "3.494 u (1 - u^2)^2 times this, with its maximum at u = 0.447. It is the gradient of an energy");
  r.number("radius", f.radius, "m", positive(), "radius at which the attraction ends");
  r.number("pressure", f.pressure, "Pa", anyNumber(), "pressure along the normals");
  r.number("from", f.from, "s", notNegative(), "start time");
  r.number("until", f.until, "s", orNever(notNegative()), "end time");
  readInTime(r, "in_time", f.inTime, "factor of the whole field, linear in between", anyNumber());
  if (r.describing() || hasShape(r) || !f.everywhere) {
    readShape(r, f.region);  // region of the field; none: everywhere
    f.everywhere = false;
  } else if (r.has("place")) {
    r.fail("place", "needs a shape: without one this field acts everywhere");
  }
  if (!r.reading()) return;
  if (length(f.acceleration) == 0 && f.attraction == 0 && f.pressure == 0)
    r.fail(r.place(),
           r.path() + ": this field has no effect: set `acceleration`, `attraction` or `pressure`");
  if (f.attraction != 0 && !r.has("point")) r.fail("attraction", "needs `point`, its target");
  if (f.attraction != 0 && !r.has("radius")) r.fail("attraction", "needs `radius`, at which it ends");
  for (const char* key : {"point", "radius"})
    if (r.has(key) && f.attraction == 0)
      r.fail(key, "belongs to `attraction`, which is missing", {"attraction"});
  if (!(f.until > f.from)) r.fail("until", "must be after `from`", {"from"});
}

/// Returns whether each segment of the line is parallel to its direction.
bool isParallelLine(const OrientedEvent& e) {
  for (std::size_t k = 0; k + 1 < e.path.size(); k++) {
    const Vec3d piece = e.path[k + 1] - e.path[k];
    if (length(cross(piece, e.direction)) > 1e-9 * length(piece) * length(e.direction)) return false;
  }
  return true;
}

void readEvent(TableReader& r, OrientedEvent& e) {
  r.restart(Restart::Setting);
  r.choice("kind", e.kind, {"weld", "cut", "crease", "smooth"},
           "weld: joins another body to this one, whose name later events use. cut: ends all interaction "
           "across it. crease: along a line, forces no longer depend on orientations. smooth: removes "
           "creases within its SHAPE");
  r.number("time", e.time, "s", notNegative(), "time of the event; 0: at the start, after relaxation");
  r.text("other", e.other, "weld: the body that is joined to this one", "name of an oriented body");
  const bool cut = e.kind == OrientedEventKind::Cut;
  r.table("plane", "cut: the plane", cut && e.tool == CutTool::Plane, [&](TableReader& t) {
    t.vector("point", e.point, "m", "a point of the plane");
    t.vector("normal", e.normal, "", "normal of the plane; any length but 0");
    if (length(e.normal) == 0) t.fail("normal", "must not be zero: expected a direction");
  });
  readPoints(r,
             {"line", "m",
              "cut: a line through points, extruded along `direction`; nothing beyond its ends is cut", cut},
             e.path);
  if (r.reading() && !e.path.empty()) e.tool = CutTool::Line;
  r.vector("direction", e.direction, "", "cut along a line: direction of extrusion; any length but 0");
  readPoints(r, {"along", "m", "crease: the line", !cut}, e.path);
  r.number("radius", e.radius, "m", notNegative(),
           "crease: distance from the line within which particles are creased; 0: a spacing. line: "
           "distance within which particles are cut; 0: a support radius");
  const bool smooth = e.kind == OrientedEventKind::Smooth;
  const bool shaped = smooth || (cut && !r.has("plane") && e.path.empty());
  if (r.reading() && cut && shaped && !hasShape(r))
    r.fail(r.place(),
           r.path() +
               ": this cut has no tool; expected `plane`, `line`, or the shape of the part that comes "
               "off (box, sphere, ...)");
  else if (r.reading() ? shaped : r.describing() || e.tool == CutTool::Box) {
    readShape(r, e.region);  // smooth: the region; cut: the part that comes off
    e.tool = CutTool::Box;
    if (readsFile(e.region))
      r.fail(r.place(), r.path() +
                            ": the region of an event cannot be a mesh file: expected a shape, "
                            "\"builtin:bust\" or \"builtin:head\"");
  }
  if (!r.reading()) return;
  if (cut && r.has("plane") && r.has("line"))
    r.fail("line", "a second tool; expected one of `plane`, `line` and a shape: use one cut for each tool");
  const auto only = [&](const char* key, bool takes, const char* of) {
    if (r.has(key) && !takes) r.fail(key, std::string("is for ") + of + " only");
  };
  only("other", e.kind == OrientedEventKind::Weld, "a weld");
  only("plane", cut, "a cut");
  only("line", cut, "a cut");
  only("along", e.kind == OrientedEventKind::Crease, "a crease");
  const bool line = cut && e.tool == CutTool::Line, crease = e.kind == OrientedEventKind::Crease;
  only("direction", line, "the cut along a line");
  only("radius", line || crease, "a crease and the cut along a line");
  for (std::size_t k = 0; k + 1 < e.path.size(); k++)
    if (length(e.path[k + 1] - e.path[k]) == 0)
      r.fail(crease ? "along" : "line", "two successive points are equal; expected a line");
  if (e.kind == OrientedEventKind::Weld && e.other.empty())
    r.fail("other", "is missing: expected the name of the body to weld to this one");
  if (e.kind == OrientedEventKind::Crease && e.path.size() < 2)
    r.fail("along", "expected at least two points");
  if (e.kind == OrientedEventKind::Cut && e.tool == CutTool::Line && e.path.size() < 2)
    r.fail("line", "expected at least two points");
  if (length(e.direction) == 0) r.fail("direction", "must not be zero: expected a direction");
  else if (cut && e.tool == CutTool::Line && e.path.size() > 1 && isParallelLine(e))
    r.fail("line",
           "is parallel to its `direction` and defines no plane: expected a direction across the line");
}

void readSource(TableReader& r, OrientedBody& b) {
  const auto place = [&] {
    r.table("place", "position of the patch or disc", [&](TableReader& p) {
      p.number("scale", b.shape.scale, "", positive(), "scale factor");
      p.number("rotate_x", b.shape.rotate.x, "rad", anyNumber(), "angle about x");
      p.number("rotate_y", b.shape.rotate.y, "rad", anyNumber(), "angle about y, after x");
      p.number("rotate_z", b.shape.rotate.z, "rad", anyNumber(), "angle about z, last");
      p.vector("move", b.shape.move, "m", "position of its middle");
    });
  };
  const auto from = [&](OrientedSource source) { return b.source == source; };
  r.table("patch", "flat rectangle in its own z = 0, normals along z", from(OrientedSource::Patch),
          [&](TableReader& t) {
            b.source = OrientedSource::Patch;
            t.number("width", b.width, "m", positive(), "along x");
            t.number("depth", b.depth, "m", positive(), "along y");
          });
  r.table("disc", "flat disc in its own z = 0", from(OrientedSource::Disc), [&](TableReader& t) {
    b.source = OrientedSource::Disc;
    t.number("radius", b.radius, "m", positive(), "radius of the disc");
  });
  r.table("curve", "2D: particles along a parabola in the plane y = constant, in which they stay (planar)",
          from(OrientedSource::Curve), [&](TableReader& t) {
            b.source = OrientedSource::Curve;
            if (t.reading()) b.planar = true;
            t.vector("from", b.from, "m", "first end");
            t.vector("to", b.to, "m", "last end");
            t.number("bulge", b.bulge, "m", anyNumber(), "height of its middle above the chord");
            if (b.from.y != b.to.y) t.fail("to", "must have the same y as `from`");
            if (length(b.to - b.from) == 0) t.fail("to", "must differ from `from`");
          });
  readPoints(r,
             {"points", "m",
              "a surface through these points; growth = \"borders\" fixes them and fills holes between them",
              from(OrientedSource::Points)},
             b.points);
  const bool points = r.has("points");
  readPoints(r,
             {"normals", "",
              "normals of `points`; none: those of a plane through their neighbours, oriented consistently "
              "along a spanning tree"},
             b.normals);
  readPoints(r,
             {"control", "m",
              "a thin plate through a few control points. Particles within 2.2 spacings of one are fixed in "
              "position and normal; the others are free",
              from(OrientedSource::Control)},
             b.points);
  const int given = r.has("patch") + r.has("disc") + r.has("curve") + r.has("points") + r.has("control");
  if (points) b.source = OrientedSource::Points;
  else if (r.has("control")) b.source = OrientedSource::Control;
  if (points && b.points.empty()) r.fail("points", "expected at least one point [x, y, z]");
  if (r.has("control") && b.points.size() < 3)
    r.fail("control", "expected at least three points that do not lie on a line");
  if (r.has("place") && (points || r.has("control") || r.has("curve")))
    r.fail("place", "is for shapes, `patch` and `disc` only: the others have their own positions");
  if (given > 1)
    r.fail(r.place(), r.path() + ": give one of `patch`, `disc`, `curve`, `points`, `control` and a shape");
  if (given > 0) refuseShape(r, "a second source of particles; expected one");
  if (r.has("normals") && !points) r.fail("normals", "is for `points` only");
  if (points && !b.normals.empty() && b.normals.size() != b.points.size())
    r.fail("normals", "expected one for each of `points`, " + std::to_string(b.points.size()) + ", got " +
                          std::to_string(b.normals.size()));
  for (const Vec3d& n : b.normals)
    if (length(n) == 0) r.fail("normals", "must not be zero: expected directions");
  if (r.recording() ? b.source == OrientedSource::Surface : given == 0) readShape(r, b.shape);
  else place();
}

}  // namespace

void readOriented(TableReader& r, OrientedBody& b, SceneReading& x) {
  r.as(Restart::Free).text("name", b.name, "for messages and `--set`; none: \"oriented\" and its number");
  // A restart finds constraints and given points by their positions at the start.
  r.restart(Restart::State);
  readSource(r, b);
  std::string colour;
  r.as(Restart::Free)
      .text(
          "colour", colour,
          "colour in pictures and exports; none: blue, green, turquoise, violet, orange, red in the order of "
          "the scene",
          "\"#rrggbb\"");
  if (std::uint32_t value = 0; !colour.empty()) {
    if (readColour(colour, value)) b.colour = value;
    else r.refuseValue("colour", "expected six hexadecimal digits such as \"#e8c890\"");
  }
  r.number("thin", b.thin, "", between(1e-4, 1),
           "fraction of its particles that is kept and fixed; growth = \"borders\" adds the others again");
  r.number("spacing", b.spacing, "m", notNegative(), "particle spacing; 0: that of the scene");
  r.restart(Restart::Start);
  r.number("jitter", b.jitter, "", between(0, 1),
           "largest random displacement (spacings) and rotation (radians) of its particles at the start, "
           "along each axis");
  r.vector("velocity", b.velocity, "m/s", "velocity at the start");
  r.restart(Restart::State);  // particles keep their mass and inertia
  r.number("density", b.density, "kg/m^2", positive(),
           "mass per area. The mass of a patch or a disc is this times its full area; with thin below 1 it "
           "is less until the body has grown. A particle of another source has this times the cell of a "
           "hexagonal lattice");
  r.number("inertia", b.inertia, "", positive(),
           "moment of inertia of a particle, divided by its mass and the square of the spacing");
  r.restart(Restart::Coefficient);
  r.number("stiffness", b.stiffness, "N/m", positive(),
           "scale of its energies: each is its weight times this times the square of the spacing");
  r.number("attract", b.attract, "", notNegative(),
           "weight of the Lennard-Jones potential, which spaces particles evenly");
  r.number("coplanar", b.plane, "", notNegative(),
           "weight of co-planarity: neighbours in the plane of a particle");
  r.number("conormal", b.normal, "", notNegative(), "weight of co-normality: neighbours' normals alike");
  r.number("cocircular", b.circle, "", notNegative(),
           "weight of co-circularity: neighbours and their normals on a common sphere");
  r.whole("repel_power", b.repelPower, 2, 40, "exponent of Lennard-Jones' repulsion");
  r.whole("attract_power", b.attractPower, 1, 39, "exponent of its attraction, below that of the repulsion");
  r.number("core", b.core, "", between(0.1, 0.95),
           "distance (spacings) below which the Lennard-Jones potential continues as a straight line, so "
           "that forces are bounded");
  r.number("across", b.across, "", positive(), "scale of the weighting function across the normal, spacings");
  r.number("along", b.along, "", positive(), "scale along the normal, at most `across`");
  r.number("support", b.support, "", between(1.5, 12),
           "radius within which particles act on each other, in spacings");
  r.flag("facing", b.facing,
         "particles with opposite normals do not interact, so that the sides of a thin body stay apart");
  r.flag("planar", b.planar,
         "moves and rotates only in its plane y = constant; true by default for a `curve`");
  r.number("damping", b.damping, "1/s", notNegative(), "rate at which velocities decay");
  r.number("spin_damping", b.spinDamping, "1/s", notNegative(), "rate at which rotations decay");
  r.number("pressure", b.pressure, "Pa", anyNumber(),
           "pressure along the normals; below 0: contracts the surface around its content");
  r.vector("acceleration", b.acceleration, "m/s^2", "uniform acceleration in addition to gravity");
  r.number("contact", b.contact, "", positive(),
           "stiffness of contacts as a multiple of `stiffness`. Contacts with bodies and obstacles also have "
           "a barrier, which follows from the scene's speeds and masses. There is no restitution; `damping` "
           "dissipates motion");
  r.number("thickness", b.thickness, "", notNegative(), "distance kept from obstacles, spacings");
  r.number("friction", b.friction, "", between(0, 10),
           "Coulomb friction on obstacles; the larger of this and theirs applies");
  r.choice(
      "integrator", b.integrator, {"symplectic", "rk4", "semi-implicit"},
      "integrator of all oriented bodies, set by the first one. symplectic: symplectic Euler. rk4: "
      "Runge-Kutta of fourth order. semi-implicit: linearised backward Euler, which takes far longer steps");
  r.restart(Restart::Setting);
  r.number("cfl", b.cfl, "", between(1e-4, 10),
           "step as a fraction of the stability limit of the stiffest particle (semi-implicit: of ten times "
           "the limit of symplectic Euler)");
  r.as(Restart::Start)
      .whole(
          "relax", b.relax, 0, 10000000,
          "largest number of relaxation iterations before the start; fewer, with a warning, if they make no "
          "progress");
  r.choice("growth", b.growth, {"none", "gaps", "borders"},
           "where particles are added: nowhere, in gaps between neighbours, or also at open borders. Growth "
           "at borders is unbounded unless \"thin\", \"points\" or \"most\" limits it; points of a surface "
           "with an open rim need \"most\"");
  r.number("gap", b.gap, "", between(1.1, 2.1),
           "distance of neighbours (spacings) above which a particle is added between them");
  r.number("removal_distance", b.removalDistance, "", between(0, 0.95),
           "distance (spacings) below which one of two particles is removed; 0: never");
  r.whole("every", b.every, 1, 100000, "steps between checks of gaps, borders and surplus particles");
  r.whole("most", b.most, 1, INT64_C(1) << 32, "number of particles at which this body stops growing");
  r.tables("constraint", "constrains the particles that are in its SHAPE at the start", b.constraints,
           readConstraint);
  r.tables("field",
           "external field, in addition to `acceleration` and `pressure`, on the particles that are in its "
           "SHAPE (none: "
           "on all) at that time",
           b.fields, readField);
  r.tables("event", "weld, cut, crease or smoothing at a time", b.events, readEvent);
  if (!r.reading()) return;
  if (b.attractPower >= b.repelPower) r.fail("attract_power", "must be below `repel_power`", {"repel_power"});
  if (b.growth == OrientedGrowth::Borders && b.thin == 1 && b.source != OrientedSource::Points &&
      !r.has("most"))
    r.fail("growth",
           "growth at open borders is unbounded unless `thin` below 1 or the `points` of a closed surface "
           "define the body: expected one of these, \"gaps\", or `most`, the number of particles at which it "
           "stops");
  if (b.along > b.across) r.fail("along", "must not be above `across`", {"across"});
  if (!x.scene->oriented.empty()) {
    const OrientedIntegrator first = x.scene->oriented.front().integrator;
    if (r.has("integrator") && b.integrator != first)
      r.fail(
          "integrator",
          "differs from that of the first oriented body, which sets it for all: expected the same, or none");
    b.integrator = first;
  }
  if (b.name.empty()) b.name = "oriented " + std::to_string(x.scene->oriented.size());
}

}  // namespace thaw
