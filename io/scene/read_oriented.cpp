#include <algorithm>

#include "core/geometry/builtin_meshes.hpp"
#include "io/scene/read_sections.hpp"
#include "io/scene/read_shape.hpp"

namespace thaw {
namespace {

/// A list of points: [[x, y, z], ...], each number with a unit or in m.
void readPoints(TableReader& r, const char* key, const char* unit, std::vector<Vec3d>& points,
                const char* about) {
  const toml::node* n = r.node(key, unit, "list of [x, y, z]", about);
  if (!n) return;
  const toml::array* list = n->as_array();
  if (!list) return r.fail(key, "expected a list of points [x, y, z]");
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

void readMotion(TableReader& r, std::vector<Keyframe>& motion) {
  r.tables("motion", "keyframes of what is held; linear in between", [&](TableReader& k) {
    Keyframe f;
    k.number("time", f.time, "s", notNegative(), "of the keyframe; must ascend");
    k.vector("move", f.move, "m", "away from the place at the start");
    k.vector("rotate", f.rotate, "rad", "about x, y, z through the origin");
    if (!motion.empty() && f.time <= motion.back().time) k.fail("time", "keyframes must ascend in time");
    motion.push_back(f);
  });
}

bool readsFile(const Shape& s) {
  return (s.kind == ShapeKind::Mesh && !namesBuiltin(s.mesh)) ||
         std::any_of(s.parts.begin(), s.parts.end(), [](const Shape& p) { return readsFile(p); });
}

void readAnchor(TableReader& r, OrientedBody& b) {
  OrientedAnchor a;
  a.where = r.place();
  readShape(r, a.region);
  r.flag("position", a.position, "holds their place");
  r.flag("normal", a.normal, "holds their orientation");
  r.number("until", a.until, "s", orNever(notNegative()), "lets go then");
  readMotion(r, a.motion);
  if (!r.describing() && !a.position && !a.normal)
    r.fail(r.place(), r.path() + ": it holds nothing: expected position = true, normal = true, or both");
  if (!r.describing()) b.anchors.push_back(std::move(a));
}

void readField(TableReader& r, OrientedBody& b) {
  OrientedField f;
  f.where = r.place();
  r.vector("push", f.push, "m/s^2", "uniform acceleration");
  r.vector("point", f.point, "m", "what pull is toward");
  r.number("pull", f.pull, "m/s^2", anyNumber(),
           "acceleration toward the point, below 0: away from it. With u = distance / radius it is 3.494 u "
           "(1 - u^2)^2 of this: the slope of an energy, largest at u = 0.447");
  r.number("radius", f.radius, "m", positive(), "of pull: where it ends");
  r.number("pressure", f.pressure, "Pa", anyNumber(), "along the normals");
  r.number("from", f.from, "s", notNegative(), "when it begins");
  r.number("until", f.until, "s", orNever(notNegative()), "when it ends");
  readInTime(r, "in_time", f.inTime, "factor of all of it, linear in between", anyNumber());
  if (r.describing() || hasShape(r)) {
    readShape(r, f.region);  // where it acts, as particles come and go; none: everywhere
    f.everywhere = false;
  } else if (r.has("place")) {
    r.fail("place", "is of a shape, and there is none: this field acts everywhere");
  }
  if (r.describing()) return;
  if (length(f.push) == 0 && f.pull == 0 && f.pressure == 0)
    r.fail(r.place(), r.path() + ": it does nothing: expected push, pull or pressure");
  if (f.pull != 0 && !r.has("point")) r.fail("pull", "needs the point that it is toward");
  if (f.pull != 0 && !r.has("radius")) r.fail("pull", "needs the radius at which it ends");
  for (const char* key : {"point", "radius"})
    if (r.has(key) && f.pull == 0) r.fail(key, "is of pull, which is missing", {"pull"});
  if (!(f.until > f.from)) r.fail("until", "must be after `from`", {"from"});
  b.fields.push_back(std::move(f));
}

/// Is each piece of the stroke along the direction that it is drawn in?
bool drawsNothing(const OrientedEvent& e) {
  for (std::size_t k = 0; k + 1 < e.path.size(); k++) {
    const Vec3d piece = e.path[k + 1] - e.path[k];
    if (length(cross(piece, e.direction)) > 1e-9 * length(piece) * length(e.direction)) return false;
  }
  return true;
}

void readEvent(TableReader& r, OrientedBody& b) {
  OrientedEvent e;
  e.where = r.place();
  r.choice("kind", e.kind, {"weld", "cut", "crease", "smooth"},
           "what is done: weld joins another body to this one, whose name later events take; cut ends all "
           "action across it; crease takes the orientation out of the forces along a line; smooth puts it "
           "back within its SHAPE");
  r.number("time", e.time, "s", notNegative(), "when; 0: at the start, after relaxation");
  r.text("other", e.other, "of weld: the body that becomes one with this", "name of an oriented body");
  r.table("plane", "of cut: the plane", [&](TableReader& t) {
    e.tool = CutTool::Plane;
    t.vector("point", e.point, "m", "a point of the plane");
    t.vector("normal", e.normal, "", "of any length but 0");
    if (length(e.normal) == 0) t.fail("normal", "must not be zero");
  });
  readPoints(r, "stroke", "m", e.path,
             "of cut: a line through points, drawn along `direction`; what lies beyond its ends is not cut");
  if (!e.path.empty()) e.tool = CutTool::Stroke;
  r.vector("direction", e.direction, "", "of the stroke's cut, of any length but 0");
  readPoints(r, "along", "m", e.path, "of crease: the line");
  r.number("radius", e.radius, "m", notNegative(),
           "of crease: particles so near to the line are in it, 0: a spacing; of a stroke: those so near are "
           "cut, 0: a support radius");
  const bool shaped = r.describing() || e.kind == OrientedEventKind::Smooth ||
                      (e.kind == OrientedEventKind::Cut && !r.has("plane") && e.path.empty());
  if (shaped) {
    readShape(r, e.region);  // of smooth; of cut: what is in it comes off
    e.tool = CutTool::Box;
    if (readsFile(e.region))
      r.fail(r.place(), r.path() +
                            ": regions of events are made of shapes, not of mesh files: expected a shape, "
                            "\"builtin:bust\" or \"builtin:head\"");
  }
  if (r.describing()) return;
  const bool cut = e.kind == OrientedEventKind::Cut;
  if (cut && r.has("plane") && r.has("stroke"))
    r.fail("stroke", "a second tool; expected one of plane, stroke and a shape, and two cuts for two");
  const auto only = [&](const char* key, bool takes, const char* of) {
    if (r.has(key) && !takes) r.fail(key, std::string("is of ") + of + " only");
  };
  only("other", e.kind == OrientedEventKind::Weld, "a weld");
  only("plane", cut, "a cut");
  only("stroke", cut, "a cut");
  only("along", e.kind == OrientedEventKind::Crease, "a crease");
  const bool stroke = cut && e.tool == CutTool::Stroke, crease = e.kind == OrientedEventKind::Crease;
  only("direction", stroke, "the cut by a stroke");
  only("radius", stroke || crease, "a crease and the cut by a stroke");
  for (std::size_t k = 0; k + 1 < e.path.size(); k++)
    if (length(e.path[k + 1] - e.path[k]) == 0)
      r.fail(crease ? "along" : "stroke", "two points that follow each other are the same; expected a line");
  if (e.kind == OrientedEventKind::Weld && e.other.empty())
    r.fail("other", "is missing: the body to weld to this one");
  if (e.kind == OrientedEventKind::Crease && e.path.size() < 2)
    r.fail("along", "expected at least two points");
  if (e.kind == OrientedEventKind::Cut && e.tool == CutTool::Stroke && e.path.size() < 2)
    r.fail("stroke", "expected at least two points");
  if (length(e.direction) == 0) r.fail("direction", "must not be zero");
  else if (cut && e.tool == CutTool::Stroke && e.path.size() > 1 && drawsNothing(e))
    r.fail("stroke",
           "runs along its `direction`, so it cuts along no plane: expected a direction across the stroke");
  b.events.push_back(std::move(e));
}

void readSource(TableReader& r, OrientedBody& b) {
  const auto place = [&] {
    r.table("place", "where the patch or disc stands", [&](TableReader& p) {
      p.number("scale", b.shape.scale, "", positive(), "factor of size");
      p.number("rotate_x", b.shape.rotate.x, "rad", anyNumber(), "angle about x");
      p.number("rotate_y", b.shape.rotate.y, "rad", anyNumber(), "angle about y, after x");
      p.number("rotate_z", b.shape.rotate.z, "rad", anyNumber(), "angle about z, last");
      p.vector("move", b.shape.move, "m", "where its middle comes to lie");
    });
  };
  r.table("patch", "flat rectangle in its own z = 0, normals along z", [&](TableReader& t) {
    b.source = OrientedSource::Patch;
    t.number("width", b.width, "m", positive(), "along x");
    t.number("depth", b.depth, "m", positive(), "along y");
  });
  r.table("disc", "flat disc in its own z = 0", [&](TableReader& t) {
    b.source = OrientedSource::Disc;
    t.number("radius", b.radius, "m", positive(), "radius");
  });
  r.table("curve", "2D: particles along a parabola in the plane y = constant; it stays in it (planar)",
          [&](TableReader& t) {
            b.source = OrientedSource::Curve;
            if (!t.describing()) b.planar = true;
            t.vector("from", b.from, "m", "first end");
            t.vector("to", b.to, "m", "last end");
            t.number("bulge", b.bulge, "m", anyNumber(), "height of its middle over the chord");
            if (!t.describing() && b.from.y != b.to.y) t.fail("to", "must have the y of from");
            if (!t.describing() && length(b.to - b.from) == 0) t.fail("to", "must differ from from");
          });
  readPoints(r, "points", "m", b.points,
             "a surface through these points; with growth = \"borders\" they are held and holes between them "
             "are filled");
  const bool points = r.has("points");
  readPoints(r, "normals", "", b.normals,
             "of `points`; none: of the plane of their neighbours, turned alike along a spanning tree");
  readPoints(r, "control", "m", b.points,
             "a thin plate through these few control points; what of it is within 2.2 spacings of one is "
             "held, place and normal, and the rest hangs from there");
  const int given = r.has("patch") + r.has("disc") + r.has("curve") + r.has("points") + r.has("control");
  if (points) b.source = OrientedSource::Points;
  else if (r.has("control")) b.source = OrientedSource::Control;
  if (points && b.points.empty()) r.fail("points", "expected at least one point [x, y, z]");
  if (r.has("control") && b.points.size() < 3)
    r.fail("control", "expected at least three points that do not lie on a line");
  if (r.has("place") && (points || r.has("control") || r.has("curve")))
    r.fail("place", "is of shapes, patches and discs only: points, control and curve are where they say");
  if (given > 1)
    r.fail(r.place(), r.path() + ": give one of patch, disc, curve, points, control and a shape");
  if (given > 0)
    refuseShape(r,
                "a second source of particles; give one of patch, disc, curve, points, control and a shape");
  if (r.has("normals") && !points) r.fail("normals", "is of points only");
  if (points && !b.normals.empty() && b.normals.size() != b.points.size())
    r.fail("normals", "there must be one for each point");
  for (const Vec3d& n : b.normals)
    if (length(n) == 0) r.fail("normals", "must not be zero");
  if (r.describing() || given == 0) readShape(r, b.shape);
  else place();
}

}  // namespace

void readOriented(TableReader& r, SceneReading& x) {
  OrientedBody b;
  b.where = r.place();
  r.text("name", b.name, "for messages and `--set`; none: \"oriented\" and its number");
  readSource(r, b);
  std::string colour;
  r.text(
      "colour", colour,
      "in pictures and exports; none: blue, green, turquoise, violet, orange, red by its place in the scene",
      "\"#rrggbb\"");
  if (std::uint32_t value = 0; !colour.empty()) {
    if (readColour(colour, value)) b.colour = value;
    else r.fail("colour", "expected six hexadecimal digits such as \"#e8c890\"");
  }
  r.number("thin", b.thin, "", between(1e-4, 1),
           "share of its particles that is kept, and held; with growth = \"borders\" the others grow again");
  r.number("spacing", b.spacing, "m", notNegative(),
           "wanted distance of its particles; 0: that of the scene");
  r.number("jitter", b.jitter, "", between(0, 1),
           "spacings, and radians, by which its particles are off at the start, at most along each axis, at "
           "random");
  r.vector("velocity", b.velocity, "m/s", "at the start");
  r.number("density", b.density, "kg/m^2", positive(),
           "of the surface: the mass of a patch or a disc is this times its area (of all of it, with thin "
           "below 1 less is there until it has grown), that of a particle of other sources this times the "
           "cell of a hexagonal lattice");
  r.number("inertia", b.inertia, "", positive(),
           "of a particle's rotation, over its mass and the square of the spacing");
  r.number("stiffness", b.stiffness, "N/m", positive(),
           "unit of its energies: weight times stiffness times the square of the spacing");
  r.number("attract", b.attract, "", notNegative(),
           "weight of the Lennard-Jones potential, which spaces particles evenly");
  r.number("coplanar", b.plane, "", notNegative(),
           "weight of co-planarity: neighbours in the plane of a particle");
  r.number("conormal", b.normal, "", notNegative(), "weight of co-normality: neighbours' normals alike");
  r.number("cocircular", b.circle, "", notNegative(),
           "weight of co-circularity: neighbours and their normals on a common sphere");
  r.whole("repel_power", b.repelPower, 2, 40, "power of Lennard-Jones' repulsion");
  r.whole("attract_power", b.attractPower, 1, 39, "power of its attraction, below that of the repulsion");
  r.number(
      "core", b.core, "", between(0.1, 0.95),
      "spacings below which Lennard-Jones goes on as a straight line, so that no force is without bound");
  r.number("across", b.across, "", positive(), "scale of the weighting function across the normal, spacings");
  r.number("along", b.along, "", positive(), "and along it, at most as long");
  r.number("support", b.support, "", between(1.5, 12),
           "radius within which particles act on each other, over their spacing");
  r.flag("facing", b.facing,
         "particles whose normals stand against each other do not act on each other, so that the sides of a "
         "thin body stay apart");
  r.flag("planar", b.planar, "moves and turns in its plane y = constant only; of a `curve` true by default");
  r.number("damping", b.damping, "1/s", notNegative(), "rate at which velocities decay");
  r.number("spin_damping", b.spinDamping, "1/s", notNegative(), "rate at which rotations decay");
  r.number("pressure", b.pressure, "Pa", anyNumber(),
           "along the normals; below 0: pulls the surface together around what it encloses");
  r.vector("push", b.push, "m/s^2", "uniform acceleration beside gravity");
  r.number(
      "contact", b.contact, "", positive(),
      "stiffness of contacts over `stiffness`; toward bodies and obstacles a barrier that follows from the "
      "scene's speeds and masses is beside it. There is no restitution: `damping` takes motion away");
  r.number("thickness", b.thickness, "", notNegative(), "distance kept from obstacles, spacings");
  r.number("friction", b.friction, "", between(0, 10),
           "Coulomb friction on obstacles, if theirs is not larger");
  r.choice("integrator", b.integrator, {"symplectic", "rk4", "semi-implicit"},
           "that of the first oriented body is for all: symplectic Euler, Runge-Kutta of fourth order, or "
           "linearised backward Euler, which takes far longer steps");
  r.number("cfl", b.cfl, "", between(1e-4, 10),
           "step over the longest that is stable for the stiffest particle (semi-implicit: over ten times "
           "that of symplectic Euler)");
  r.whole("relax", b.relax, 0, 10000000,
          "iterations of relaxation to rest before the start, at most; fewer, with a warning, where what "
          "grows or goes gets no nearer to it");
  r.choice("growth", b.growth, {"none", "gaps", "borders"},
           "where particles are made: nowhere, in gaps between neighbours, or at open borders as well; at "
           "these without end, unless \"thin\", \"points\" or \"most\" bound it; points of a surface with an "
           "open rim do not say where it ends, and want \"most\"");
  r.number("gap", b.gap, "", between(1.1, 2.1),
           "distance of neighbours, in spacings, from which one is put between them");
  r.number("crowd", b.crowd, "", between(0, 0.95),
           "distance, in spacings, below which one of two goes; 0: never");
  r.whole("every", b.every, 1, 100000, "steps between looks at gaps, borders and crowds");
  r.whole("most", b.most, 1, INT64_C(1) << 32, "particles of this body from which it grows no more");
  r.tables("anchor", "holds the particles that lie in its SHAPE at the start",
           [&](TableReader& a) { readAnchor(a, b); });
  r.tables("field",
           "what acts from outside, beside push and pressure, on the particles that are in its SHAPE (none: "
           "on all) at that time",
           [&](TableReader& f) { readField(f, b); });
  r.tables("event", "something that is done to the body", [&](TableReader& e) { readEvent(e, b); });
  if (r.describing()) return;
  if (b.attractPower >= b.repelPower) r.fail("attract_power", "must be below repel_power", {"repel_power"});
  if (b.growth == OrientedGrowth::Borders && b.thin == 1 && b.source != OrientedSource::Points &&
      !r.has("most"))
    r.fail("growth",
           "at open borders a body grows for as long as there is one, beyond its holes and without end, "
           "unless points of `thin` below 1 or `points` of a closed surface say where it is: expected one of "
           "these, \"gaps\", or `most`, the number of its particles at which it ends");
  if (b.along > b.across) r.fail("along", "must not be above across", {"across"});
  if (!x.scene->oriented.empty()) {
    const OrientedIntegrator first = x.scene->oriented.front().integrator;
    if (r.has("integrator") && b.integrator != first)
      r.fail("integrator",
             "differs from that of the first oriented body, which is for all: expected the same, or none");
    b.integrator = first;
  }
  if (b.name.empty()) b.name = "oriented " + std::to_string(x.scene->oriented.size());
  x.scene->oriented.push_back(std::move(b));
}

}  // namespace thaw
