// SPDX-License-Identifier: Apache-2.0
#include "io/commands/starting_scenes.hpp"

namespace thaw {
namespace {

constexpr const char* melt = R"toml(
spacing = "6 mm"          # particle spacing: finer looks better and takes longer
end     = "2 s"           # simulated time

[domain]                  # particles that leave this box are removed and counted
min     = ["-20 cm", "-20 cm", "-2 cm"]
max     = [ "20 cm",  "20 cm", "30 cm"]
gravity = [0, 0, -9.81]

[material.wax]
density         = "900 kg/m^3"
colour          = "#efe3c8"
young           = "100 kPa"            # stiffness of the solid
viscosity       = "2 Pa s"             # viscosity of the liquid
sound_speed     = "20 m/s"             # about ten times the fastest flow
surface_tension = "0.03 N/m"
conductivity    = "300 W/(m K)"        # a thousand times that of wax: an hour passes in seconds
heat_capacity   = "2 kJ/(kg K)"
latent_heat     = "30 kJ/kg"
melts           = ["40 degC", "60 degC"]

[[body]]
name        = "ball"
sphere      = { radius = "5 cm" }      # or: mesh = "model.ply", a closed OBJ, PLY or STL file
material    = "wax"
temperature = "20 degC"
place       = { bottom = [0, 0, "2 cm"] }

[[obstacle]]
name        = "plate"
plane       = { point = [0, 0, 0], normal = [0, 0, 1] }
temperature = "250 degC"
friction    = 0.8

[surface]                 # a surface for pictures and exports; leave it out to draw particles
every_move = 0            # one update per frame: enough for thick liquids

[output]
every  = "40 ms"          # simulated time between frames
camera = { from = [0.16, -0.42, 0.26], at = [0, 0, 0.04], field_of_view = "32 deg" }
)toml";

constexpr const char* drop = R"toml(
spacing = "0.8 mm"        # particle spacing: finer looks better and takes longer
end     = "60 ms"         # simulated time

[domain]
min   = ["-12.8 mm", "-12.8 mm", 0]
max   = [ "12.8 mm",  "12.8 mm", "32 mm"]
sides = { x = "periodic", y = "periodic", z = ["wall", "open"] }   # the pool repeats beyond its sides

[material.milk]
density         = "1030 kg/m^3"
colour          = "#f4f1e6"
viscosity       = "2 mPa s"
surface_tension = "0.05 N/m"

[[body]]
name     = "pool"
box      = { size = ["25.6 mm", "25.6 mm", "4.8 mm"] }   # multiples of the spacing: starts at rest
material = "milk"
place    = { move = [0, 0, "2.4 mm"] }

[[body]]
name     = "drop"
sphere   = { radius = "2.6 mm" }
material = "milk"
velocity = [0, 0, "-1.6 m/s"]
place    = { move = [0, 0, "8.2 mm"] }

[output]
every  = "1 ms"           # simulated time between frames
fields = ["velocity", "pressure", "density"]
colour = "speed"          # field that colours the particles in pictures
camera = { from = [0.02, -0.035, 0.022], at = [0, 0, 0.004], field_of_view = "36 deg" }
)toml";

constexpr const char* dam = R"toml(
spacing = "3 cm"          # particle spacing: finer looks better and takes longer
end     = "2 s"           # simulated time

[domain]
min   = [0, 0, 0]         # m; a text such as "20 cm" has a unit
max   = [1.6, 0.6, 2.0]
sides = { x = "wall", y = "wall", z = ["wall", "open"] }   # a tank that is open at the top

[material.water]
density              = "1000 kg/m^3"
viscosity            = "0.02 Pa s"
artificial_viscosity = 0.05            # damps sound waves

[[body]]
name     = "column"
box      = { size = ["0.42 m", "0.57 m", "0.51 m"] }
material = "water"
place    = { move = ["0.225 m", "0.3 m", "0.27 m"] }

[[obstacle]]
name  = "post"
box   = { size = ["8 cm", "12 cm", "60 cm"] }
place = { move = ["1 m", "0.3 m", "0.3 m"] }
slip  = true              # liquid slips along it

[output]
every      = "25 ms"      # simulated time between frames
fields     = ["velocity", "pressure", "density"]
colour     = "speed"      # field that colours the particles in pictures
colour_min = 0
colour_max = 3
camera     = { from = [2.9, -1.9, 1.7], at = [0.8, 0.3, 0.25], field_of_view = "30 deg" }
)toml";

constexpr const char* sheet = R"toml(
spacing = "4 mm"          # particle spacing; sheets have their own spacing
end     = "1.5 s"         # simulated time

[domain]
min     = ["-50 cm", "-50 cm", "-1 cm"]
max     = [ "50 cm",  "50 cm",  "60 cm"]
gravity = [0, 0, -9.81]

[[obstacle]]
name     = "ball"
sphere   = { radius = "14 cm" }
place    = { move = [0, 0, "22 cm"] }
friction = 0.4

[[obstacle]]
name  = "floor"
plane = { point = [0, 0, 0], normal = [0, 0, 1] }

[[sheet]]
name         = "cloth"
grid         = { width = "60 cm", depth = "60 cm" }
spacing      = "15 mm"                 # vertex spacing: a finer one gives finer folds and longer runs
place        = { move = [0, 0, "38 cm"], rotate_z = "12 deg" }
mass         = "0.25 kg/m^2"
damping      = "0.5 kg/(m^2 s)"
warp         = "400 N/m"               # stiffness along x, along y, in shear and in bending
weft         = "200 N/m"
shear        = "15 N/m"
bending      = "0.15 N/m"
self_contact = true
thickness    = "7 mm"
friction     = 0.3
colour       = "#8fa8c9"

[output]
every  = "50 ms"          # simulated time between frames
colour = "surface"        # the colour of the cloth
camera = { from = [0.60, -1.05, 0.66], at = [-0.02, 0, 0.19], field_of_view = "36 deg" }
)toml";

constexpr const char* oriented = R"toml(
spacing = "3 cm"          # spacing of the oriented particles
end     = "2 s"           # simulated time

[domain]
min     = [-0.8, -0.6, -0.4]
max     = [0.8, 0.6, 0.8]
gravity = [0, 0, 0]

[[oriented]]              # a surface without fixed topology: it can be cut, welded, creased and grown
name         = "patch"
patch        = { width = "60 cm", depth = "40 cm" }
density      = 20
inertia      = 1
cfl          = 0.5        # step length relative to the limit
damping      = 12
spin_damping = 12

[[oriented.constraint]]       # fixes the particles inside this box
box    = { size = [0.05, 1, 0.2] }
place  = { move = [-0.3, 0, 0] }
normal = true

[[oriented.constraint]]       # lifts the other end
box    = { size = [0.05, 1, 0.2] }
place  = { move = [0.3, 0, 0] }
motion = [ { time = 0 }, { time = "1.5 s", move = [-0.1, 0, 0.3] } ]

[output]
every  = "50 ms"          # simulated time between frames
camera = { from = [0.5, -1.3, 0.75], at = [0, 0, 0.1], field_of_view = "33 deg" }
)toml";

constexpr StartingScene scenes[] = {{"melt", "a ball of wax melts on a hot plate", melt},
                                    {"drop", "a drop falls into a pool", drop},
                                    {"dam", "a column of water collapses in a tank", dam},
                                    {"sheet", "a cloth drapes over a ball", sheet},
                                    {"oriented", "a surface of oriented particles is bent", oriented}};

}  // namespace

std::span<const StartingScene> startingScenes() { return scenes; }

std::vector<std::string> startingKinds() {
  std::vector<std::string> names;
  for (const StartingScene& s : scenes) names.emplace_back(s.kind);
  return names;
}

}  // namespace thaw
