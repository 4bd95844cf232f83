#include <fmt/format.h>

#include <cmath>

#include "io/scene/read_sections.hpp"
#include "io/scene/read_shape.hpp"

namespace thaw {
namespace {

Range factorRange(std::size_t f) {
  return static_cast<SheetFactor>(f) == SheetFactor::Wrap ? anyNumber() : notNegative();
}

const char* aboutInRegion(std::size_t f) {
  switch (static_cast<SheetFactor>(f)) {
    case SheetFactor::Warp:
    case SheetFactor::Weft:
    case SheetFactor::Shear:
    case SheetFactor::Bending:
    case SheetFactor::Push:
    case SheetFactor::Pull:
      return "times the sheet's; of what acts between two vertices the mean of both counts";
    case SheetFactor::Volume:
      return "times the sheet's; a closed piece has one pressure: the mean over its area counts";
    default: return "times the sheet's";
  }
}

void readSheetMesh(TableReader& r, SheetBody& b) {
  int given = 0;
  for (std::size_t k = 0; k < sheetMeshWords().size(); k++)
    if (const char* key = sheetMeshWords()[k].c_str(); r.has(key)) {
      b.mesh = static_cast<SheetMesh>(k);
      if (++given == 2) r.fail(key, "a second mesh; give one, and two sheets for two");
    }
  if (given == 0 && !r.describing())
    r.fail(r.place(), r.path() + ": its mesh is missing: grid, sphere, head, dome, forehead or mesh");
  r.table("grid", "rectangle in the plane z = 0 of threads along x and y", [&](TableReader& t) {
    t.number("width", b.width, "m", positive(), "along x");
    t.number("depth", b.depth, "m", positive(), "along y");
  });
  r.table("sphere", "closed, around its own origin",
          [&](TableReader& t) { t.number("radius", b.radius, "m", positive(), "radius"); });
  r.table("head", "closed, around its own origin, looking along -y",
          [&](TableReader& t) { t.number("height", b.height, "m", positive(), "from chin to crown"); });
  r.table("dome", "cap with its border in the plane z = 0", [&](TableReader& t) {
    std::int64_t ribs = b.ribs;
    t.number("radius", b.radius, "m", positive(), "of the border");
    t.number("height", b.height, "m", positive(), "of the middle");
    t.whole("ribs", ribs, 0, 1000, "radial ones, as a scallop's");
    t.number("rib_height", b.ribHeight, "m", notNegative(), "from groove to ridge");
    b.ribs = static_cast<int>(ribs);
  });
  r.table("forehead", "skin over a ball around its own origin, on its side towards +z, with furrows",
          [&](TableReader& t) {
            std::int64_t wrinkles = b.wrinkles;
            t.number("radius", b.radius, "m", positive(), "of the ball");
            t.number("width", b.width, "m", positive(), "along x, measured along the ball");
            t.number("height", b.height, "m", positive(), "along y, measured along the ball");
            t.whole("wrinkles", wrinkles, 0, 1000, "furrows along x");
            t.number("wrinkle_height", b.wrinkleHeight, "m", notNegative(), "above the ball");
            b.wrinkles = static_cast<int>(wrinkles);
            constexpr double pi = 3.14159265358979323846;
            if (t.describing()) return;
            if (!(b.width < 2 * pi * b.radius))
              t.fail("width", fmt::format("must be less than once around the ball, {:.4g} m, got {:g}",
                                          2 * pi * b.radius, b.width));
            if (!(b.height < pi * b.radius))
              t.fail("height",
                     fmt::format("must be less than from pole to pole of the ball, {:.4g} m, got {:g}",
                                 pi * b.radius, b.height));
          });
  r.text("mesh", b.shape.mesh,
         "triangles of an OBJ, PLY or STL file, open or closed, in one piece or several; or \"builtin:bust\" "
         "or \"builtin:head\"",
         "path or \"builtin:bust\"");
  if (!r.describing()) checkMeshPath(r, b.shape.mesh);
  r.number("spacing", b.spacing, "m", notNegative(),
           "distance of vertices of meshes that are made here; 0: that of the scene's particles");
  readPlace(r, b.shape);
}

void readExactStep(TableReader& r, SheetBody& b) {
  r.number("mass", b.mass, "kg/m^2", notNegative(), "per area; 0: it creeps, without inertia");
  r.number("damping", b.damping, "kg/(m^2 s)", notNegative(), "resistance against velocity, per area");
  r.number("stiffness", b.stiffness, "N/m^3", notNegative(),
           "of the springs that pull every vertex to its place of rest, per area");
  r.number("plasticity", b.plasticity, "", between(0, 1),
           "part of what goes beyond the elastic limit that stays; 0: elastic, 1: plastic");
  r.number("elastic_limit", b.elasticLimit, "m", orNever(positive()),
           "displacement from rest; \"never\": none");
  r.tables("region",
           "part of the sheet, where its vertices are in a SHAPE at the start, with other coefficients; "
           "where regions overlap the last one's factors hold, all of them",
           [&](TableReader& t) {
             SheetRegion g;
             g.where = t.place();
             readShape(t, g.shape);
             for (std::size_t f = 0; f < sheetFactors; f++)
               t.number(sheetCoefficients[f].key, g.factor[f], "", factorRange(f), aboutInRegion(f));
             if (!t.describing()) b.regions.push_back(std::move(g));
           });
}

void readInner(TableReader& r, SheetBody& b) {
  r.number("warp", b.warp, "N/m", notNegative(),
           "of the springs along edges in the direction of the warp: tension per width and strain");
  r.number("weft", b.weft, "N/m", notNegative(), "of those across it");
  r.number("shear", b.shear, "N/m", notNegative(), "of those between, both diagonals of a square");
  r.vector("warp_direction", b.warpDirection, "",
           "of the warp, in the mesh's own axes: `place` turns it along; edges within 25 degrees of it are "
           "warp, beyond 72 degrees weft");
  r.number("rest_length", b.restLength, "", positive(), "of the springs, over their length at the start");
  r.number("bending", b.bending, "N/m", notNegative(),
           "of springs between the vertices on both sides of each edge");
  r.number("stretch_limit", b.stretchLimit, "", orNever(atLeast(1)),
           "length over that at rest beyond which springs are nearly rigid");
  r.number("rigid", b.rigid, "", notNegative(), "by how much they are stiffer then; the step pays for it");
  r.number("volume_stiffness", b.volumeStiffness, "Pa", notNegative(),
           "of a closed mesh: pressure per relative change of its volume");
  r.number("push", b.push, "N/m", notNegative(), "between vertices nearer than the thickness");
  r.number("pull", b.pull, "N/m", notNegative(), "between vertices further than that, as far as pull_reach");
  r.number("pull_reach", b.pullReach, "m", notNegative(), "beyond the thickness");
}

void readOuter(TableReader& r, SheetBody& b) {
  r.vector("wind", b.wind, "m/s", "velocity of the air");
  r.number("wind_density", b.windDensity, "kg/m^3", notNegative(),
           "of the air, times a coefficient of drag: pressure over squared velocity along the normal; 0: no "
           "air; without `wind` the air is at rest, and drags");
  r.number("wrap", b.wrap, "Pa", anyNumber(),
           "pressure that shrinks the sheet: against its normal, or toward what wrap_to names");
  r.text("wrap_to", b.wrapTo,
         "what wrap is toward, and what is drawn toward the sheet as strongly, if it moves; none: against "
         "the normal",
         "name of an obstacle, a body, an emitter, an oriented body or another sheet");
  r.tables("brush", "pushes at a place", [&](TableReader& t) {
    SheetBrush g;
    g.where = t.place();
    t.vector("centre", g.centre, "m", "where it pushes most");
    t.number("radius", g.radius, "m", positive(), "where it ends: (1 - r^2/R^2)^2 in between");
    t.vector("pressure", g.pressure, "Pa", "force per area of sheet at the centre");
    readInTime(t, "in_time", g.inTime, "factor, linear in between", anyNumber());
    t.tables("motion",
             "keyframes of its centre, linear in between; it acts along its whole way, also in steps that "
             "are longer than its radius",
             [&](TableReader& k) {
               Keyframe f;
               k.number("time", f.time, "s", notNegative(), "when");
               k.vector("move", f.move, "m", "from its centre");
               if (k.describing()) return;
               if (!g.motion.empty() && f.time <= g.motion.back().time)
                 k.fail("time", "keyframes must ascend in time");
               g.motion.push_back(f);
             });
    if (!t.describing() && length(g.pressure) == 0)
      t.fail("pressure", "is missing or zero: expected what it pushes with, [x, y, z]");
    if (!t.describing()) b.brushes.push_back(std::move(g));
  });
  r.number("thickness", b.thickness, "m", notNegative(),
           "distance at which it touches; 0: 0.8 of its spacing");
  r.number("contact_rate", b.contactRate, "1/s", notNegative(),
           "of contact, a spring that swings with this rate; 0: from the speeds and pressures of the scene");
  r.number("friction", b.friction, "", between(0, 10), "Coulomb; of two that touch the larger counts");
  r.number("restitution", b.restitution, "", between(0, 1), "of two that touch the smaller counts");
  r.flag("self_contact", b.selfContact, "it touches itself");
}

/// Of all coefficients but the mass, which a vertex keeps.
void readCoefficientsInTime(TableReader& r, SheetBody& b) {
  for (std::size_t f = 0; f < sheetFactors; f++) {
    const auto& [coefficient, value] = sheetCoefficients[f];
    if (static_cast<SheetFactor>(f) == SheetFactor::Mass) continue;
    const std::string key = std::string(coefficient) + "_in_time";
    readInTime(r, key.c_str(), b.inTime[f],
               ("factor of " + std::string(coefficient) + ", linear in between").c_str(), factorRange(f));
    if (r.describing() || b.*value != 0) continue;
    if (r.has(key)) r.fail(key, "is a factor of " + std::string(coefficient) + ", which is 0", {coefficient});
  }
}

/// After the coefficients: a factor of nothing is nothing.
void checkRegions(TableReader& r, const SheetBody& b) {
  for (std::size_t k = 0; k < b.regions.size(); k++)
    for (std::size_t f = 0; f < sheetFactors; f++) {
      const auto& [coefficient, value] = sheetCoefficients[f];
      if (b.regions[k].factor[f] != 1 && b.*value == 0)
        r.fail(b.regions[k].where, fmt::format("{}.region.{}.{}: is a factor of {}, which is 0", r.path(), k,
                                               coefficient, coefficient));
    }
}

}  // namespace

const std::vector<std::string>& sheetMeshWords() {
  static const std::vector<std::string> words{"grid", "sphere", "head", "dome", "forehead", "mesh"};
  return words;
}

void readSheet(TableReader& r, SceneReading& x) {
  SheetBody b;
  std::string colour;
  b.where = r.place();
  b.shape.where = b.where;
  b.shape.kind = ShapeKind::Mesh;
  r.text("name", b.name, "for messages and `--set`; none: \"sheet\" and its number");
  readSheetMesh(r, b);
  readExactStep(r, b);
  readInner(r, b);
  readOuter(r, b);
  readCoefficientsInTime(r, b);
  r.vector("velocity", b.velocity, "m/s", "at the start");
  r.text("colour", colour, "in pictures and exports; a pale one", "\"#rrggbb\"");
  if (!colour.empty() && !readColour(colour, b.colour))
    r.fail("colour", "expected six hexadecimal digits such as \"#e8c890\"");
  r.number("temperature", b.temperature, "K", positive(), "at the start");
  r.number("heat_capacity", b.heatCapacity, "J/(m^2 K)", positive(), "per area");
  r.number("conductance", b.conductance, "W/(m^2 K)", notNegative(),
           "of heat to what it touches; 0: insulating");
  if (r.describing()) {
    r.node("clamp", "", "list of tables with a SHAPE each",
           "vertices that lie in one of these at the start are held where they are");
    return;
  }
  r.tables("clamp", "", [&](TableReader& c) {
    b.clamp.emplace_back();
    readShape(c, b.clamp.back());
  });
  b.massWhere = r.placeOf("mass");
  checkRegions(r, b);
  if (b.mass == 0 && b.windDensity > 0)
    r.fail("wind_density", "the air's drag on a sheet without mass has no stable step: expected mass > 0",
           {"mass"});
  if (b.pullReach > 0 && b.pull == 0)
    r.fail("pull_reach", "needs pull: without it nothing acts there", {"pull"});
  if (b.plasticity > 0 && b.stiffness == 0)
    r.fail("plasticity", "without stiffness there is no place of rest that could move", {"stiffness"});
  if (b.plasticity > 0 && !r.has("elastic_limit"))
    r.fail("plasticity", "needs elastic_limit: without one all is elastic");
  if (r.has("elastic_limit") && !r.has("plasticity"))
    r.fail("elastic_limit", "needs plasticity, which says what of what goes beyond it stays");
  if (length(b.wind) > 0 && b.windDensity == 0)
    r.fail("wind", "needs wind_density: air without mass does not push", {"wind_density"});
  if (b.pull > 0 && b.pullReach == 0) r.fail("pull_reach", "pull needs a reach", {"pull"});
  if (length(b.warpDirection) == 0) r.fail("warp_direction", "must not be zero");
  else if (b.mesh == SheetMesh::Grid && r.has("grid") &&
           std::hypot(b.warpDirection.x, b.warpDirection.y) < warpCosine * length(b.warpDirection))
    r.fail("warp_direction",
           "stands across the grid, which lies in its own plane z = 0: none of its edges would be warp");
  else if (!(b.warp > 0 || b.weft > 0 || b.shear > 0) && r.has("warp_direction"))
    r.fail("warp_direction", "is of springs along edges: expected warp, weft or shear as well",
           {"warp", "weft", "shear"});
  if (!b.wrapTo.empty() && b.wrap == 0)
    r.fail("wrap_to", "without wrap there is nothing to be wrapped", {"wrap"});
  if (b.name.empty()) b.name = "sheet " + std::to_string(x.scene->sheets.size());
  x.scene->sheets.push_back(std::move(b));
}

}  // namespace thaw
