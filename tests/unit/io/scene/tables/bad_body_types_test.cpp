// SPDX-License-Identifier: Apache-2.0
// Invalid oriented bodies and sheets are refused with their place; ineffective settings give a warning.
#include <gtest/gtest.h>

#include "io/scene/read_scene.hpp"
#include "io/scene/scene_files.hpp"
#include "io/scene/scene_warnings.hpp"

namespace thaw {
namespace {

const std::string head = "spacing = 0.05\nend = 1\n[domain]\nmin = [-1, -1, -1]\nmax = [1, 1, 1]\n";
const std::string patch = "[[oriented]]\nname = \"a\"\npatch = { width = 0.5, depth = 0.5 }\n";
const std::string cloth = "[[sheet]]\ngrid = { width = 0.5, depth = 0.5 }\n";

std::string errorOf(const std::string& text) {
  try {
    readScene(sceneFilesOf("s.toml", head + text));
  } catch (const SceneErrors& e) { return e.what(); }
  return "";
}

TEST(BadBodyTypes, FormerKeysAreRefusedWithTheirNewNames) {
  const struct {
    std::string text, key, name;
  } table[] = {{cloth + "wrap = 1\n", "wrap", "shrink_wrap"},
               {cloth + "wrap_in_time = [[0, 1], [1, 2]]\n", "wrap_in_time", "shrink_wrap_in_time"},
               {cloth + "[[sheet.brush]]\n", "brush", "pressure_brush"},
               {cloth + "push = 1\n", "push", "repulsion"},
               {cloth + "pull_reach = 1\n", "pull_reach", "attraction_range"},
               {patch + "push = [0, 0, 1]\n", "push", "acceleration"},
               {patch + "[[oriented.anchor]]\n", "anchor", "constraint"},
               {patch + "crowd = 0.6\n", "crowd", "removal_distance"},
               {patch + "[surface]\nkeep_volume = 0\n", "keep_volume", "enforce_volume"},
               {patch + "[[oriented.event]]\nkind = \"cut\"\nstroke = [[0, 0, 0]]\n", "stroke", "line"}};
  for (const auto& [text, key, name] : table) {
    const std::string said = errorOf(text);
    EXPECT_NE(said.find("unknown key '" + key + "'"), std::string::npos) << said;
    EXPECT_NE(said.find("; its new name is '" + name + "'"), std::string::npos) << said;
  }
}

TEST(BadBodyTypes, InvalidSettingsAreRefusedWithTheirPlace) {
  const struct {
    std::string text, line;
  } table[] = {
      {"[[oriented]]\npoints = []\n",
       "s.toml:7:10: error: oriented.0.points: expected at least one point [x, y, z]"},
      {"[[oriented]]\ncontrol = [[0, 0, 0]]\n",
       "s.toml:7:11: error: oriented.0.control: expected at least three points that do not lie on a line"},
      {"[[oriented]]\ncurve = { from = [0, 0, 0], to = [0.5, 0, 0] }\nplace = { move = [0, 0, 0.5] }\n",
       "s.toml:8:9: error: oriented.0.place: is for shapes, `patch` and `disc` only: the others have "
       "their own positions"},
      {patch + "[[oriented.constraint]]\nsphere = { radius = 0.1 }\nposition = false\n",
       "s.toml:9:1: error: oriented.a.constraint.0: has no effect: set `position = true`, `normal = true`, "
       "or both"},
      {patch + "[[oriented.event]]\nkind = \"weld\"\nother = \"a\"\n",
       "s.toml:9:1: error: oriented body 'a': it cannot be welded to itself: expected the name of another "
       "oriented body"},
      {patch + "[[oriented.event]]\nkind = \"cut\"\nplane = { point = [0, 0, 0] }\nline = [[0, 0, 0], "
               "[0.1, 0, 0]]\n",
       "s.toml:12:8: error: oriented.a.event.0.line: a second tool; expected one of `plane`, `line` and "
       "a shape: use one cut for each tool"},
      {patch + "[[oriented.event]]\nkind = \"crease\"\nalong = [[0, 0, 0], [0.1, 0, 0]]\nplane = { point = "
               "[0, 0, 0] }\n",
       "s.toml:12:9: error: oriented.a.event.0.plane: is for a cut only"},
      {patch + "[[oriented.event]]\nkind = \"smooth\"\n",
       "s.toml:9:1: error: oriented.a.event.0: has no shape; expected one of mesh, box, sphere, cylinder, "
       "torus, glass, plane, union, difference or intersection"},
      {patch + "[[oriented.event]]\nkind = \"cut\"\n",
       "s.toml:9:1: error: oriented.a.event.0: this cut has no tool; expected `plane`, `line`, or the shape "
       "of "
       "the part that comes off (box, sphere, ...)"},
      {"[[sheet]]\ngrid = { height = 1 }\n",
       "s.toml:7:10: error: unknown key 'height' in sheet.0.grid; expected one of `depth`, `width`"},
      {cloth + "[sheet.clamp]\n",
       "s.toml:8:1: error: sheet.0.clamp.0: has no shape; expected one of mesh, box, sphere, cylinder, "
       "torus, "
       "glass, plane, union, difference or intersection"},
      {cloth + "[[sheet.pressure_brush]]\nradius = 0.1\n",
       "s.toml:8:1: error: sheet.0.pressure_brush.0.pressure: is missing or zero: expected a pressure [x, y, "
       "z]"},
      {patch + "[[oriented.event]]\nkind = \"cut\"\nmesh = \"cube.obj\"\n",
       "s.toml:9:1: error: oriented.a.event.0: the region of an event cannot be a mesh file: expected a "
       "shape, \"builtin:bust\" or \"builtin:head\""},
      {patch + "[[oriented.event]]\nkind = \"cut\"\nline = [[0, 0, 0], [0, 0, 0.1], [0, 0, "
               "0.3]]\ndirection = [0, 0, 2]\n",
       "s.toml:11:8: error: oriented.a.event.0.line: is parallel to its `direction` and defines no plane: "
       "expected a direction across the line"},
      {patch + "[[oriented]]\npatch = { width = 0.5, depth = 0.5 }\nintegrator = \"rk4\"\n",
       "s.toml:11:14: error: oriented.1.integrator: differs from that of the first oriented body, which sets "
       "it for all: expected the same, or none"},
      {cloth + "stretch_limit = 0.9\n",
       "s.toml:8:17: error: sheet.0.stretch_limit: must be >= 1 or \"never\", got 0.9"},
      {cloth + "stiffness = 1\nplasticity = 0.5\n",
       "s.toml:9:14: error: sheet.0.plasticity: needs `elastic_limit`: without one everything is elastic"},
      {cloth + "stiffness = 1\nelastic_limit = 0.01\n",
       "s.toml:9:17: error: sheet.0.elastic_limit: has no effect without `plasticity` above 0"},
      {patch + "normals = [[0, 0, 1]]\n", "s.toml:9:11: error: oriented.a.normals: is for `points` only"},
      {patch + "sphere = { radius = 0.2 }\n",
       "s.toml:9:10: error: oriented.a.sphere: a second source of particles; expected one"},
      {patch + "[[oriented.event]]\nkind = \"cut\"\nplane = { point = [0, 0, 0] }\nradius = 0.1\n",
       "s.toml:12:10: error: oriented.a.event.0.radius: is for a crease and the cut along a line only"},
      {patch + "[[oriented.event]]\nkind = \"cut\"\nsphere = { radius = 0.1 }\ndirection = [0, 0, 1]\n",
       "s.toml:12:13: error: oriented.a.event.0.direction: is for the cut along a line only"},
      {patch + "[[oriented.event]]\nkind = \"crease\"\nalong = [[0, 0, 0], [0, 0, 0]]\n",
       "s.toml:11:9: error: oriented.a.event.0.along: two successive points are equal; expected a line"},
      {cloth + "warp = 10\nwarp_direction = [0.1, 0, 2]\n",
       "s.toml:9:18: error: sheet.0.warp_direction: is normal to the grid, which lies in its own plane z = "
       "0: none of its edges would be warp"},
      {cloth + "warp_direction = [0, 1, 0]\n",
       "s.toml:8:18: error: sheet.0.warp_direction: is for springs along edges: set `warp`, `weft` or "
       "`shear`, too"},
      {"[[sheet]]\nforehead = { radius = 0.1, width = 0.7, height = 0.1 }\n",
       "s.toml:7:36: error: sheet.0.forehead.width: must be less than the circumference of the ball, 0.6283 "
       "m, "
       "got 0.7"},
      {cloth + "warp = \"3 kg\"\n",
       "s.toml:8:8: error: sheet.0.warp: expected a force per length such as \"0.03 N/m\", got \"3 kg\""},
      {cloth + "mass = \"3 N/m\"\n",
       "s.toml:8:8: error: sheet.0.mass: expected a quantity in kg/m^2, got \"3 N/m\""},
      {cloth + "shrink_wrap = 1\nshrink_wrap_to = \"bal\"\n[[obstacle]]\nname = \"ball\"\nsphere = { radius "
               "= 0.1 }\n",
       "s.toml:6:1: error: sheet.0: shrink_wrap_to: unknown obstacle or body 'bal'; did you mean "
       "'ball'?"},
      {cloth + "name = \"b\"\nshrink_wrap = 1\nshrink_wrap_to = \"b\"\n",
       "s.toml:6:1: error: sheet 'b': shrink_wrap_to: a sheet cannot wrap around itself; omit "
       "`shrink_wrap_to` to shrink "
       "against "
       "its own normals"},
      {cloth + "shrink_wrap = 1\nshrink_wrap_to = \"a\"\n" + patch +
           "[[obstacle]]\nname = \"a\"\nsphere = { radius = 0.1 }\n",
       "s.toml:6:1: error: sheet.0: shrink_wrap_to: 'a' is the name of several objects of the scene; "
       "expected "
       "a unique name"},
      {cloth + "shrink_wrap = 1\nshrink_wrap_in_time = [[0, 1]]\n",
       "s.toml:9:23: error: sheet.0.shrink_wrap_in_time: expected a list of at least two pairs [s, number], "
       "such as [[300, 0.5], [400, 0.7]]"},
      {cloth + "warp_in_time = [[0, 1], [1, 2]]\n",
       "s.toml:8:16: error: sheet.0.warp_in_time: is a factor of warp, which is 0: set `warp` of the "
       "sheet, or remove the factor"},
      {cloth + "damping = 1\n[[sheet.region]]\nsphere = { radius = 0.1 }\nbending = 3\n",
       "s.toml:9:1: error: sheet.0.region.0.bending: is a factor of bending, which is 0: set "
       "`bending` of the sheet, or remove the factor"},
      {cloth + "warp = 1\nwarp_in_time = [[0, 1], [1, -2]]\n",
       "s.toml:9:29: error: sheet.0.warp_in_time: must be >= 0, got -2"},
      {cloth + "mass = 0\nstiffness = 1\n[[sheet.pressure_brush]]\npressure = [0, 0, 1]\n",
       "s.toml:8:8: error: sheet.0: mass: a massless, undamped vertex has no stable step under "
       "the pressure of a pressure brush: expected mass, or damping at all times"},
      {cloth + "mass = 0\nstiffness = 1\n[[obstacle]]\nsphere = { radius = 0.1 }\n",
       "s.toml:8:8: error: sheet.0: mass: a massless, undamped vertex has no stable step under "
       "contact with obstacles: expected mass, or damping at all times"},
      {cloth + "mass = 0\ndamping = 1\nwarp = 1\ndamping_in_time = [[0, 1], [1, 0]]\n",
       "s.toml:8:8: error: sheet.0: mass: must not be zero while damping and stiffness are: set one "
       "of the three"},
      {cloth + "stiffness = 1\nwarp = 2\n[[sheet.region]]\nsphere = { radius = 0.1 }\nmass = 0\n",
       "s.toml:10:1: error: sheet.0: this region: a massless, undamped vertex has no stable step "
       "under forces of its neighbours: expected mass, or damping at all times"},
      {cloth + "damping = 1\nwind_density = 1\n[[sheet.region]]\nsphere = { radius = 0.1 }\nmass = 0\n",
       "s.toml:10:1: error: sheet.0: this region: the air's drag on vertices without mass has no "
       "stable step: expected mass > 0, or `wind_density = 0` there"},
      {patch + "[[oriented.event]]\nkind = \"weld\"\n",
       "s.toml:9:1: error: oriented.a.event.0.other: is missing: expected the name of the body to weld "
       "to this one"},
      {patch + "growth = \"borders\"\n",
       "s.toml:9:10: error: oriented.a.growth: growth at open borders is unbounded unless `thin` below 1 or "
       "the `points` of a closed surface define the body: expected one of these, \"gaps\", or `most`, the "
       "number of particles at which it stops"},
      {"[[oriented]]\ncontrol = [[0, 0, 0], [0.4, 0, 0], [0, 0.4, 0]]\ngrowth = \"borders\"\n",
       "s.toml:8:10: error: oriented.0.growth: growth at open borders is unbounded unless `thin` below 1 or "
       "the `points` of a closed surface define the body: expected one of these, \"gaps\", or `most`, the "
       "number of particles at which it stops"},
      {patch + "[[oriented.field]]\nfrom = 1\n",
       "s.toml:9:1: error: oriented.a.field.0: this field has no effect: set `acceleration`, `attraction` or "
       "`pressure`"},
      {patch + "[[oriented.field]]\nattraction = 3\nradius = 1\n",
       "s.toml:10:14: error: oriented.a.field.0.attraction: needs `point`, its target"},
      {patch + "[[oriented.field]]\npressure = 3\nfrom = 1\nuntil = 1\n",
       "s.toml:12:9: error: oriented.a.field.0.until: must be after `from`"},
      {"[[sheet]]\nmesh = \"builtin:cat\"\n",
       "s.toml:7:8: error: sheet.0.mesh: unknown built-in mesh 'cat'; expected \"builtin:bust\" or "
       "\"builtin:head\""},
      {cloth + "wind = [1, 0, 0]\n",
       "s.toml:8:8: error: sheet.0.wind: needs `wind_density`: air without density exerts no force"},
  };
  for (const auto& t : table) EXPECT_EQ(errorOf(t.text), t.line);
  EXPECT_EQ(
      errorOf("[[sheet]]\nmesh = \"bowl.xyz\"\n")
          .rfind("s.toml:7:8: error: sheet.0.mesh: expected a file that ends in .obj, .ply or .stl, got ", 0),
      0u);
  EXPECT_EQ(errorOf(patch + "colour = \"blue\"\n"),
            "s.toml:9:10: error: oriented.a.colour: expected six hexadecimal digits such as \"#e8c890\"");
  EXPECT_EQ(errorOf(patch + "growth = \"borders\"\nmost = 500\n"), "");
  EXPECT_EQ(errorOf(patch + "growth = \"borders\"\nthin = 0.1\n"), "");
  EXPECT_EQ(errorOf("[[oriented]]\ncontrol = [[0, 0, 0], [0.4, 0, 0], [0, 0.4, 0]]\ngrowth = "
                    "\"borders\"\nmost = 500\n"),
            "")
      << "control points do not bound the growth";
  EXPECT_EQ(errorOf(patch + cloth), "");
  EXPECT_EQ(errorOf(cloth + "warp = 10\nwarp_direction = [1, 1, 0]\n"), "")
      << "a direction on the bias is valid";
  EXPECT_EQ(errorOf(cloth + "wind_density = 1\n"), "") << "air at rest has drag";
  EXPECT_EQ(errorOf(cloth + "mass = 0\nstiffness = 1\n"), "") << "springs alone are valid";
  EXPECT_EQ(errorOf(cloth + "damping = 1\n[[sheet.region]]\nsphere = { radius = 0.1 }\nmass = "
                            "0\n[[obstacle]]\nsphere = { radius = 0.1 }\n"),
            "")
      << "overdamped motion is valid";
  EXPECT_EQ(errorOf(cloth + "stiffness = 1\nelastic_limit = 0.01\nplasticity = 0\n"), "")
      << "a variation of scenes/sheet/shell.toml";
}

TEST(OrientedColours, ComeFromTheSceneOrTheBodyNumber) {
  const Scene s = readScene(sceneFilesOf("s.toml", head + patch +
                                                       "[[oriented]]\nname = \"b\"\ncurve = { from = [0, 0, "
                                                       "0.5], to = [0.5, 0, 0.5] }\ncolour = \"#102030\"\n"));
  EXPECT_EQ(colourOf(s.oriented[0], 0), orientedColours[0]);
  EXPECT_EQ(colourOf(s.oriented[1], 1), 0x302010u);
  EXPECT_NE(colourOf(s.oriented[0], 0), colourOf(s.oriented[0], 1));
}

TEST(OrientedFields, WarnWhenTheyBeginAtTheEnd) {
  const std::string field = "[[oriented.field]]\nacceleration = [1, 0, 0]\nfrom = ";
  EXPECT_TRUE(sceneWarnings(readScene(sceneFilesOf("s.toml", head + patch + field + "0.9\n"))).empty());
  EXPECT_EQ(sceneWarnings(readScene(sceneFilesOf("s.toml", head + patch + field + "1\n"))),
            std::vector<std::string>{"s.toml:9:1: oriented body 'a': this field begins at 1 s, but the scene "
                                     "ends at 1 s: it has no effect"});
}

TEST(Planar, IsForCurves) {
  EXPECT_EQ(sceneWarnings(readScene(sceneFilesOf("s.toml", head + patch + "planar = true\n"))).size(), 1u);
  const std::string flat =
      "[[oriented]]\nname = \"a\"\nplanar = true\npoints = [[0, 0.1, 0], [0.05, 0.1, 0], [0.1, 0.1, "
      "0.01]]\nnormals = [[0, 0, 1], [0, 0, 1], [0, 0, 1]]\n";
  EXPECT_TRUE(sceneWarnings(readScene(sceneFilesOf("s.toml", head + flat))).empty());
  const std::string doc = sceneDocumentation();
  EXPECT_NE(doc.find("| `planar` |  | true, false | false |"), std::string::npos);
}

TEST(BadBodyTypes, IneffectiveSettingsAreWarnings) {
  const Scene s = readScene(
      sceneFilesOf("s.toml", head + patch +
                                 "[[oriented.event]]\nkind = \"cut\"\ntime = 3\nplane = { point = [0, 0, 0] "
                                 "}\n[output]\nfields = [\"liquid\"]\n"));
  const std::vector<std::string> lines = sceneWarnings(s);
  ASSERT_EQ(lines.size(), 2u);
  EXPECT_EQ(
      lines[0],
      "s.toml:9:1: oriented body 'a': this event is at 3 s, but the scene ends at 1 s: it has no effect");
  EXPECT_EQ(lines[1].rfind("s.toml:14:10: `output.fields` (liquid) apply to bodies and emitters", 0), 0u);
  EXPECT_TRUE(sceneWarnings(readScene(sceneFilesOf("s.toml", head + patch + cloth))).empty());
}

}  // namespace
}  // namespace thaw
