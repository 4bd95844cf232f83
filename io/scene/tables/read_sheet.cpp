// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "io/scene/tables/read_sections.hpp"
#include "io/scene/tables/read_shape.hpp"

namespace thaw {
namespace {

Range factorRange(std::size_t f) {
  return static_cast<SheetFactor>(f) == SheetFactor::ShrinkWrap ? anyNumber() : notNegative();
}

const char* aboutInRegion(std::size_t f) {
  switch (static_cast<SheetFactor>(f)) {
    case SheetFactor::Warp:
    case SheetFactor::Weft:
    case SheetFactor::Shear:
    case SheetFactor::Bending:
    case SheetFactor::Repulsion:
    case SheetFactor::Attraction:
      return "factor of the sheet's value; forces between two vertices use the mean of both";
    case SheetFactor::Volume:
      return "factor of the sheet's value; a closed piece has one pressure and uses the mean over its area";
    default: return "factor of the sheet's value";
  }
}

/// Keys of a sheet's mesh, by SheetMesh.
constexpr const char* meshKeys[] = {"grid", "sphere", "head", "dome", "forehead", "mesh"};

void readSheetMesh(TableReader& r, SheetBody& b) {
  int given = 0;
  for (std::size_t k = 0; k < std::size(meshKeys); k++)
    if (const char* key = meshKeys[k]; r.has(key)) {
      b.mesh = static_cast<SheetMesh>(k);
      if (++given == 2) r.fail(key, "a sheet takes one mesh; use another [[sheet]] for the second");
    }
  if (given == 0)
    r.fail(
        r.place(),
        r.path() + ": has no mesh; expected one of `grid`, `sphere`, `head`, `dome`, `forehead` or `mesh`");
  const auto is = [&](SheetMesh mesh) { return b.mesh == mesh; };
  r.table("grid", "rectangle in the plane z = 0 of threads along x and y", is(SheetMesh::Grid),
          [&](TableReader& t) {
            t.number("width", b.width, "m", positive(), "along x");
            t.number("depth", b.depth, "m", positive(), "along y");
          });
  r.table("sphere", "closed sphere around its own origin", is(SheetMesh::Sphere),
          [&](TableReader& t) { t.number("radius", b.radius, "m", positive(), "radius of the sphere"); });
  r.table(
      "head", "closed head around its own origin, looking along -y", is(SheetMesh::Head),
      [&](TableReader& t) { t.number("height", b.height, "m", positive(), "height from chin to crown"); });
  r.table("dome", "cap with its border in the plane z = 0", is(SheetMesh::Dome), [&](TableReader& t) {
    std::int64_t ribs = b.ribs;
    t.number("radius", b.radius, "m", positive(), "radius of the border");
    t.number("height", b.height, "m", positive(), "height of the middle");
    t.whole("ribs", ribs, 0, 1000, "radial ribs, such as those of a scallop");
    t.number("rib_height", b.ribHeight, "m", notNegative(), "height from groove to ridge");
    b.ribs = static_cast<int>(ribs);
  });
  r.table("forehead", "skin over a ball around its own origin, on its side towards +z, with furrows",
          is(SheetMesh::Forehead), [&](TableReader& t) {
            std::int64_t wrinkles = b.wrinkles;
            t.number("radius", b.radius, "m", positive(), "radius of the ball");
            t.number("width", b.width, "m", positive(), "along x, measured along the ball");
            t.number("height", b.height, "m", positive(), "along y, measured along the ball");
            t.whole("wrinkles", wrinkles, 0, 1000, "furrows along x");
            t.number("wrinkle_height", b.wrinkleHeight, "m", notNegative(), "height above the ball");
            b.wrinkles = static_cast<int>(wrinkles);
            using std::numbers::pi;
            if (!t.reading()) return;
            if (!(b.width < 2 * pi * b.radius))
              t.fail("width",
                     fmt::format("must be less than the circumference of the ball, {:.4g} m, got {:g}",
                                 2 * pi * b.radius, b.width));
            if (!(b.height < pi * b.radius))
              t.fail("height",
                     fmt::format("must be less than half the circumference of the ball, {:.4g} m, got {:g}",
                                 pi * b.radius, b.height));
          });
  readMesh(r, b.shape,
           "triangles of an OBJ, PLY or STL file, open or closed, in one piece or several; or "
           "\"builtin:bust\" or \"builtin:head\"");
  r.number("spacing", b.spacing, "m", notNegative(),
           "vertex spacing of generated meshes; 0: the scene's particle spacing");
  readPlace(r, b.shape);
}

void readExactStep(TableReader& r, SheetBody& b) {
  r.as(Restart::State)
      .number("mass", b.mass, "kg/m^2", notNegative(), "mass per area; 0: the sheet creeps without inertia");
  r.number("damping", b.damping, "kg/(m^2 s)", notNegative(), "viscous damping per area");
  r.number("stiffness", b.stiffness, "N/m^3", notNegative(),
           "stiffness per area of the springs that pull each vertex to its rest position");
  r.number("plasticity", b.plasticity, "", between(0, 1),
           "permanent fraction of the displacement beyond the elastic limit; 0: elastic, 1: plastic");
  r.number("elastic_limit", b.elasticLimit, "m", orNever(positive()),
           "largest elastic displacement from rest; \"never\": no limit");
  r.tables("region",
           "part of the sheet with other coefficients: its vertices in a SHAPE at the start. Where regions "
           "overlap, all factors are those of the last one",
           b.regions, [&](TableReader& t, SheetRegion& g) {
             t.restart(Restart::State);  // vertices refer to their region by its place in the list
             readShape(t, g.shape);
             for (std::size_t f = 0; f < sheetFactors; f++) {
               t.restart(f == placeOf(SheetFactor::Mass) ? Restart::State : Restart::Coefficient);
               t.number(sheetCoefficients[f].key, g.factor[f], "", factorRange(f), aboutInRegion(f));
             }
           });
}

void readInner(TableReader& r, SheetBody& b) {
  r.number("warp", b.warp, "N/m", notNegative(),
           "stiffness of springs along edges in the direction of the warp: tension per width and strain; "
           "strains are relative to the lengths at the start");
  r.number("weft", b.weft, "N/m", notNegative(), "stiffness of springs along edges across the warp");
  r.number("shear", b.shear, "N/m", notNegative(),
           "stiffness of springs along edges in other directions, and along both diagonals of a square");
  r.as(Restart::State)
      .vector("warp_direction", b.warpDirection, "",
              "direction of the warp in the mesh's own axes, which `place` rotates; edges within 25 degrees "
              "of it are warp, those at more than 72 degrees are weft");
  r.number("rest_length", b.restLength, "", positive(),
           "rest length of the springs as a multiple of their length at the start");
  r.number("bending", b.bending, "N/m", notNegative(),
           "stiffness of springs between the vertices on both sides of each edge");
  r.number("stretch_limit", b.stretchLimit, "", orNever(atLeast(1)),
           "length, as a multiple of the rest length, beyond which springs are nearly rigid");
  r.number("rigid", b.rigid, "", notNegative(),
           "additional stiffness beyond `stretch_limit`, as a multiple of the springs' stiffness; it "
           "shortens the step");
  r.number("volume_stiffness", b.volumeStiffness, "Pa", notNegative(),
           "pressure of a closed mesh per relative change of its volume");
  r.number("repulsion", b.repulsion, "N/m", notNegative(),
           "repulsion between vertices closer than the thickness");
  r.number("attraction", b.attraction, "N/m", notNegative(),
           "attraction between vertices beyond the thickness, up to `attraction_range`");
  r.number("attraction_range", b.attractionRange, "m", notNegative(),
           "range of the attraction beyond the thickness");
}

void readOuter(TableReader& r, SheetBody& b) {
  r.vector("wind", b.wind, "m/s", "velocity of the air");
  r.number("wind_density", b.windDensity, "kg/m^3", notNegative(),
           "density of the air times a drag coefficient: pressure divided by the squared normal velocity. 0: "
           "no air. Without `wind`, the drag is that of air at rest");
  r.number("shrink_wrap", b.shrinkWrap, "Pa", anyNumber(),
           "pressure that shrinks the sheet: against its normal, or toward `shrink_wrap_to`");
  r.text("shrink_wrap_to", b.shrinkWrapTo,
         "target of the shrink-wrap; if it can move, it gets the opposite force; none: against the normal",
         "name of an obstacle, a body, an emitter, an oriented body or another sheet");
  r.tables("pressure_brush", "a local pressure", b.pressureBrushes, [&](TableReader& t, PressureBrush& g) {
    t.vector("centre", g.centre, "m", "centre of the pressure");
    t.number("radius", g.radius, "m", positive(),
             "radius R at which it ends; the profile is (1 - r^2/R^2)^2");
    t.vector("pressure", g.pressure, "Pa", "force per area of the sheet at the centre");
    readInTime(t, "in_time", g.inTime, "factor, linear in between", anyNumber());
    readMotion(
        t,
        "keyframes of its centre, linear in between, and constant before the first and after the last; "
        "it acts along its whole path, also in steps longer than its radius",
        g.motion, false);
    if (length(g.pressure) == 0) t.fail("pressure", "is missing or zero: expected a pressure [x, y, z]");
  });
  r.number("thickness", b.thickness, "m", notNegative(),
           "distance at which contact begins; 0: 0.8 of its spacing");
  r.number("contact_rate", b.contactRate, "1/s", notNegative(),
           "angular frequency of the contact spring; 0: from the speeds and pressures of the scene");
  r.number("friction", b.friction, "", between(0, 10),
           "Coulomb friction; the larger of two in contact applies");
  r.number("restitution", b.restitution, "", between(0, 1),
           "restitution; the smaller of two in contact applies");
  r.flag("self_contact", b.selfContact, "contact of the sheet with itself");
}

/// Reads the factors in time of all coefficients but the mass, which a vertex keeps.
void readCoefficientsInTime(TableReader& r, SheetBody& b) {
  for (std::size_t f = 0; f < sheetFactors; f++) {
    const auto& [coefficient, value] = sheetCoefficients[f];
    if (static_cast<SheetFactor>(f) == SheetFactor::Mass) continue;
    const std::string key = std::string(coefficient) + "_in_time";
    readInTime(r, key.c_str(), b.inTime[f],
               ("factor of " + std::string(coefficient) + ", linear in between").c_str(), factorRange(f));
    if (r.has(key) && b.*value == 0)
      r.fail(key,
             fmt::format("is a factor of {0}, which is 0: set `{0}` of the sheet, or remove the factor",
                         coefficient),
             {coefficient});
  }
}

/// Refuses factors of coefficients that are 0. Called after the coefficients are read.
void checkRegions(TableReader& r, const SheetBody& b) {
  for (std::size_t k = 0; k < b.regions.size(); k++)
    for (std::size_t f = 0; f < sheetFactors; f++) {
      const auto& [coefficient, value] = sheetCoefficients[f];
      if (b.regions[k].factor[f] != 1 && b.*value == 0)
        r.fail(b.regions[k].where,
               fmt::format("{0}.region.{1}.{2}: is a factor of {2}, which is 0: set `{2}` of the sheet, or "
                           "remove the factor",
                           r.path(), k, coefficient));
    }
}

}  // namespace

void readSheet(TableReader& r, SheetBody& b, SceneReading& x) {
  std::string colour;
  b.shape.where = b.where;
  b.shape.kind = ShapeKind::Mesh;
  r.as(Restart::Free).text("name", b.name, "for messages and `--set`; none: \"sheet\" and its number");
  r.restart(Restart::State);  // a restart makes edges, triangles and rest positions again from its mesh
  readSheetMesh(r, b);
  r.restart(Restart::Coefficient);
  readExactStep(r, b);
  readInner(r, b);
  readOuter(r, b);
  readCoefficientsInTime(r, b);
  r.as(Restart::Start).vector("velocity", b.velocity, "m/s", "velocity at the start");
  r.as(Restart::Free)
      .text("colour", colour, "colour in pictures and exports; default: a pale one", "\"#rrggbb\"");
  if (!colour.empty() && !readColour(colour, b.colour))
    r.refuseValue("colour", "expected six hexadecimal digits such as \"#e8c890\"");
  r.as(Restart::Start).number("temperature", b.temperature, "K", positive(), "temperature at the start");
  r.number("heat_capacity", b.heatCapacity, "J/(m^2 K)", positive(), "heat capacity per area");
  r.number("conductance", b.conductance, "W/(m^2 K)", notNegative(),
           "heat conductance to bodies in contact; 0: insulating");
  r.restart(Restart::State);
  readClamps(r, b.clamp, "vertices in one of these at the start are fixed");
  if (!r.reading()) return;
  b.massWhere = r.placeOf("mass");
  checkRegions(r, b);
  if (b.mass == 0 && b.windDensity > 0)
    r.fail("wind_density", "the air's drag on a sheet without mass has no stable step: expected `mass` > 0",
           {"mass"});
  if (b.attractionRange > 0 && b.attraction == 0)
    r.fail("attraction_range", "needs `attraction`: without it nothing acts within this range",
           {"attraction"});
  if (b.plasticity > 0 && b.stiffness == 0)
    r.fail("plasticity", "needs `stiffness`: without it a vertex has no rest position", {"stiffness"});
  if (b.plasticity > 0 && !r.has("elastic_limit"))
    r.fail("plasticity", "needs `elastic_limit`: without one everything is elastic");
  if (r.has("elastic_limit") && !r.has("plasticity"))
    r.fail("elastic_limit", "has no effect without `plasticity` above 0");
  if (length(b.wind) > 0 && b.windDensity == 0)
    r.fail("wind", "needs `wind_density`: air without density exerts no force", {"wind_density"});
  if (b.attraction > 0 && b.attractionRange == 0)
    r.fail("attraction_range", "must be above 0 with `attraction`", {"attraction"});
  if (length(b.warpDirection) == 0) r.fail("warp_direction", "must not be zero: expected a direction");
  else if (b.mesh == SheetMesh::Grid && r.has("grid") &&
           std::hypot(b.warpDirection.x, b.warpDirection.y) < warpCosine * length(b.warpDirection))
    r.fail("warp_direction",
           "is normal to the grid, which lies in its own plane z = 0: none of its edges would be warp");
  else if (!(b.warp > 0 || b.weft > 0 || b.shear > 0) && r.has("warp_direction"))
    r.fail("warp_direction", "is for springs along edges: set `warp`, `weft` or `shear`, too",
           {"warp", "weft", "shear"});
  if (!b.shrinkWrapTo.empty() && b.shrinkWrap == 0)
    r.fail("shrink_wrap_to", "needs `shrink_wrap`: without it nothing acts", {"shrink_wrap"});
  if (b.name.empty()) b.name = "sheet " + std::to_string(x.scene->sheets.size());
}

}  // namespace thaw
