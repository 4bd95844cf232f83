// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>

#include "core/terms/extensions.hpp"
#include "io/scene/read_scene.hpp"
#include "io/scene/tables/read_sections.hpp"
#include "io/scene/text/expression.hpp"

namespace thaw {
namespace {

/// Escapes "|", which ends a table cell.
std::string cell(const std::string& s) {
  std::string t;
  for (const char c : s) {
    if (c == '|') t += '\\';
    t += c;
  }
  return t;
}

const char* wordOf(const KeyDescription& k) {
  if (!k.restart) return "";
  switch (*k.restart) {
    case Restart::State: return "refused";
    case Restart::Coefficient:
    case Restart::Setting: return "reported";
    case Restart::Start: return "no effect";
    case Restart::Free: return "free";
  }
  return "";
}

constexpr const char* introduction =
    "# Keys of a scene file\n"
    "\n"
    "Generated from the table of keys in `io/scene` by `thaw docs`; a test compares the two.\n"
    "\n"
    "A scene is a TOML file. It needs a `[[body]]` or an `[[emitter]]` with its `[material.NAME]`, an "
    "`[[oriented]]` or a `[[sheet]]`; all other keys have defaults.\n"
    "A quantity is a number in the unit of the table below or a text with a unit: `\"15 cm\"`, `\"2 "
    "kJ/kg\"`, `\"0.25 W/(m K)\"`, `\"56 degC\"`, `\"30 deg\"`.\n"
    "Temperatures without a unit are in kelvin.\n"
    "Keys whose range ends with `{ solid = ..., liquid = ... }` take one value or one for each phase. Two "
    "values are "
    "blended linearly by the liquid fraction.\n"
    "NaN and infinity are refused: for no limit, use `\"never\"`.\n"
    "An unknown key is an error. All errors in keys and values are reported at once, then those of "
    "positions, with file, line and column.\n"
    "A line has at most 16384 characters, and a file 16 MiB: split long lists over several lines.\n"
    "\n"
    "The column *restart* says whether a key may change at a restart:\n"
    "\n"
    "- refused: the run does not continue.\n"
    "- reported: the run continues with the new value. It does not continue if the value needs data that the "
    "checkpoint lacks, such as plastic strains.\n"
    "- no effect: the change is reported and ignored.\n"
    "- free: the change is not reported.\n"
    "\n"
    "Keys of shapes follow the table that has the shape. A list marked refused must keep the names and the "
    "order of its tables.\n"
    "\n"
    "`--set key=value` on the command line overrides a key; the value is checked in the same way. Examples: "
    "`--set spacing=\"1 mm\"`, `--set material.wax.young=\"1 MPa\"`, `--set body.bust.velocity=\"[0, 0, "
    "-1]\"`.\n"
    "A body, emitter or obstacle is given by its name or its number from 0. Each setting needs its own "
    "`--set`.\n"
    "`--set` can also add a table: `--set material.oil.density=900 --set body.drop.material=oil`.\n"
    "An unused material gives a warning; an unknown body, emitter or obstacle is an error.\n"
    "`thaw check SCENE` describes the simulation.\n"
    "\n"
    "Particles lie on a lattice. Along each axis, the nearest whole number of equal cells fills the bounding "
    "box of a body: a box 7.4 spacings wide has 7 layers, each 1.057 spacings thick. The mass of a particle "
    "is "
    "the density times the volume of its cell, so that of a box is exact. The lattice of a box or a rigid "
    "body rotates with its `place`.\n"
    "Cells are from 0.75 to 1.3 spacings long. Bodies too thin for this have cells of one spacing; solids "
    "round the number of layers up, liquids down.\n"
    "Bodies that overlap and give way to each other (`numerics.overlap`) share one lattice, whose cells end "
    "at the faces of their bounding boxes. Rotated boxes and relaxed packings have their own.\n"
    "A box of liquid may fill its container; leave half a spacing around round liquid bodies.\n"
    "`thaw check` reports where the mass is off by more than 1 %, and the density that compensates for it.\n"
    "Liquid in a space too small for its particles starts compressed and bursts; a warning reports it.\n"
    "A solid body can contain liquid if its walls are at least two spacings thick; a warning names thinner "
    "ones.\n"
    "\n"
    "`jelly.toml` is a complete scene: a block falls on a floor, bounces and wobbles. `thaw run jelly.toml` "
    "simulates it:\n"
    "\n"
    "```toml\n";
constexpr const char* afterExample =
    "```\n"
    "\n"
    "A paste, such as concrete, mud or toothpaste, is modelled as a solid that yields (a Bingham solid). In "
    "shear at a rate `rate` its stress is tau_y + mu `rate`, with a yield stress tau_y and a plastic "
    "viscosity mu:\n"
    "\n"
    "- Choose a shear modulus G of about 20 tau_y or more, so that little of the flow is elastic. `young` = "
    "2 (1 + `poisson`) G.\n"
    "- `yield_strain` = tau_y / (sqrt(2) G). In uniaxial tests it then yields at sqrt(3/2) 2 G "
    "`yield_strain` = sqrt(3) tau_y.\n"
    "- `creep_rate` = G / mu. Without it the excess stress vanishes at once (mu = 0).\n"
    "- The static limit is sqrt(3) tau_y / (density g) = 9.8 mm, with gravity g. Gravity acts suddenly at "
    "the start, and the stress overshoots, so a block of the paste below yields at a height of 8 to 9 mm.\n"
    "- A larger G means shorter steps. `viscosity` has no effect, since it belongs to the liquid.\n"
    "\n"
    "tau_y = 100 Pa and mu = 20 Pa s:\n"
    "\n"
    "```toml\n"
    "[material.paste]\n"
    "density = 1800\n"
    "young = 5800               # G = 2000 Pa with poisson = 0.45\n"
    "poisson = 0.45\n"
    "law = \"neo-hookean\"\n"
    "yield_strain = 0.0354      # 100 / (sqrt(2) 2000)\n"
    "creep_rate = 100           # 2000 / 20\n"
    "```\n"
    "\n"
    "Use a liquid with `flow.law = \"bingham\"` instead for a paste that flows far or mixes. Below "
    "its yield stress it creeps slowly, while a solid stays at rest.\n"
    "\n"
    "## Expressions\n"
    "\n"
    "`velocity` and `temperature` of a body or an emitter may depend on position:\n"
    "`velocity = { x = \"-100*x\", y = \"100*y\" }`, `temperature = \"300 + 20*z\"`.\n"
    "`x`, `y`, `z` are in m, in the frame of the scene; the value is in m/s or K. Expressions have no units. "
    "Operators and functions: ";
constexpr const char* afterWords =
    ".\n"
    "Expressions of a body use the position before periodic wrapping, those of an emitter the position in "
    "the opening.\n"
    "A velocity component above 299792458 m/s, a temperature outside (0, 1e32] K, or NaN, at a particle is "
    "an "
    "error.\n"
    "A temperature that depends on position switches heat on where something conducts heat or melts.\n";

/// Lists the terms of the library (core/terms/terms.hpp).
std::string termsDocumentation() {
  std::string text =
      "\n## Terms of the model\n"
      "\n"
      "The library has these terms in one registry with elastic laws and with extensions of programs. A "
      "scene "
      "without the keys of a term has none of its cost.\n"
      "\n"
      "| term | keys | modules in `thaw check` | limit of the step | in `ledger.csv` | meaning "
      "|\n|---|---|---|---|---|---|\n";
  const auto listed = [](const auto& names, const char* quote) {
    std::string list;
    for (const auto& name : names) list += fmt::format("{0}{1}{2}{1}", list.empty() ? "" : ", ", quote, name);
    return list;
  };
  const auto moduleNames = [](const Extension& term) {
    std::vector<std::string> names;
    for (const TermModule& own : term.model->modules) names.push_back(own.name);
    return names;
  };
  for (const Extension* term : modelTerms())
    text += fmt::format("| {} | {} | {} | {} | {} | {} |\n", term->name, listed(keysOf(*term->model), "`"),
                        listed(moduleNames(*term), ""), listed(term->model->limits, ""),
                        listed(term->model->energies, "`"), cell(term->about));
  return text;
}

}  // namespace

const char* exampleScene() {
  return "title = \"A block of jelly falls on a floor\"\n"
         "spacing = \"1 cm\"                        # particle spacing: the only setting of the resolution\n"
         "end = \"0.5 s\"\n"
         "\n"
         "[domain]\n"
         "min = [\"-30 cm\", \"-30 cm\", \"-2 cm\"]\n"
         "max = [ \"30 cm\",  \"30 cm\", \"50 cm\"]\n"
         "\n"
         "[material.jelly]\n"
         "density = \"1000 kg/m^3\"\n"
         "young = \"20 kPa\"                       # above 0: it can be solid\n"
         "law = \"neo-hookean\"\n"
         "\n"
         "[[body]]\n"
         "name = \"block\"\n"
         "box = { size = [\"10 cm\", \"10 cm\", \"10 cm\"] }\n"
         "material = \"jelly\"\n"
         "place = { bottom = [0, 0, \"10 cm\"], rotate_x = \"20 deg\" }\n"
         "\n"
         "[[obstacle]]\n"
         "name = \"floor\"\n"
         "plane = { point = [0, 0, 0], normal = [0, 0, 1] }\n"
         "\n"
         "[output]\n"
         "every = \"20 ms\"\n";
}

std::string sceneDocumentation() {
  const std::vector<KeyDescription> keys = sceneKeys();
  std::string text(introduction);
  text += exampleScene();
  text += afterExample + std::string(expressionWords) + afterWords;
  text += termsDocumentation();
  std::vector<std::string> tables;
  for (const KeyDescription& k : keys)
    if (std::find(tables.begin(), tables.end(), k.table) == tables.end()) tables.push_back(k.table);
  for (const std::string& t : tables) {
    text += t.empty() ? "\n## Top level\n\n" : "\n## `" + t + "`\n\n";
    text += "| key | unit | range | default | restart | meaning |\n|---|---|---|---|---|---|\n";
    for (const KeyDescription& k : keys)
      if (k.table == t)
        text += fmt::format("| `{}` | {} | {} | {} | {} | {} |\n", k.key, cell(k.unit), cell(k.range),
                            cell(k.standard), wordOf(k), cell(k.about));
  }
  return text;
}

}  // namespace thaw
