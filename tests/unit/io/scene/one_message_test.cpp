// SPDX-License-Identifier: Apache-2.0
// An error has one message. Each value of a scene with many keys is replaced by an invalid one. Only that
// value is reported, not its consequences.
#include <gtest/gtest.h>

#include <toml++/toml.h>

#include "io/scene/read_scene.hpp"

namespace thaw {
namespace {

const std::string rich = R"(title = "of everything something"
spacing = "2 cm"
end = "0.1 s"
seed = 3
[domain]
min = [-0.5, -0.5, -0.1]
max = [0.5, 0.5, 0.6]
[domain.sides]
x = "wall"
[numerics]
support = 2.0
fixed_step = 1e-4
[material.wax]
density = 900
young = { solid = "200 kPa", liquid = 0 }
viscosity = 2
heat_capacity = 2000
latent_heat = 30000
melts = ["30 degC", "36 degC"]
hysteresis = 0.1
yield_strain = 0.2
creep_rate = 3
[material.water]
viscosity = [[300, 0.001], [400, 0.0005]]
[material.steel]
young = 1e6
phase = "solid"
[[body]]
name = "pat"
box = { size = [0.1, 0.1, 0.1] }
material = "wax"
temperature = 280
place = { move = [0, 0, 0.1] }
[[body]]
name = "ring"
torus = { radius = 0.08, tube = 0.03 }
material = "steel"
place = { bottom = [-0.2, 0.2, 0.1], scale = 1.1 }
[[emitter]]
name = "tap"
material = "water"
disc = { radius = 0.05 }
centre = [0, 0.3, 0.5]
start = 0.01
end = 0.05
[[obstacle]]
name = "floor"
plane = { point = [0, 0, 0], normal = [0, 0, 1] }
temperature = 400
conductance = 50
[[obstacle]]
name = "cup"
glass = { radius = 0.05, height = 0.1, thickness = 0.02 }
place = { move = [0.3, 0.3, 0] }
[[thermostat]]
material = "wax"
temperature = 300
[[lamp]]
name = "bulb"
power = "20 W"
position = [0, 0, 0.5]
[[lamp]]
name = "window"
kind = "area"
power = "20 W"
position = [0, 0, 0.5]
direction = [0, 0, -1]
width = 0.2
depth = 0.3
[[laser]]
power = 20
radius = 0.01
position = [0, 0, 0]
absorption_depth = 0.01
start = 0.01
end = 0.02
[[heated_region]]
name = "coil"
power = 20
sphere = { radius = 0.1 }
material = "wax"
[surface]
iso_level = 0.5
least_level = 0.2
[[sheet]]
name = "cloth"
grid = { width = 0.2, depth = 0.2 }
mass = 0.2
damping = 3
warp = 1
attraction = 1
attraction_range = 0.1
wind = [1, 0, 0]
wind_density = 1.2
place = { move = [0, -0.3, 0.4] }
[[oriented]]
name = "film"
patch = { width = 0.2, depth = 0.2 }
attract_power = 2
repel_power = 3
[output]
every = "20 ms"
colour = "speed"
fields = ["velocity", "id"]
)";

/// All keys of a scene in the form of `--set`.
void collectKeys(const toml::table& t, const std::string& before, std::vector<std::string>& keys) {
  for (const auto& [key, node] : t) {
    const std::string path = before + std::string(key.str());
    if (const toml::table* inner = node.as_table()) collectKeys(*inner, path + ".", keys);
    if (const toml::array* list = node.as_array(); list && !list->empty() && list->get(0)->is_table()) {
      for (std::size_t k = 0; k < list->size(); k++)
        collectKeys(*list->get(k)->as_table(), path + "." + std::to_string(k) + ".", keys);
    } else {
      keys.push_back(path);
    }
  }
}

TEST(OneMessage, ForEachInvalidValue) {
  const SceneFiles files = sceneFilesOf("rich.toml", rich);
  ASSERT_NO_THROW(readScene(files));
  std::vector<std::string> keys;
  collectKeys(toml::parse(rich), "", keys);
  ASSERT_GT(keys.size(), 80u);
  std::size_t refused = 0;
  for (const std::string& key : keys)
    for (const char* wrong : {"{ wrong = 1 }", "2020-01-01", "\"5 parsec\"", "-7e300"}) {
      try {
        readScene(files, {key + "=" + wrong});
      } catch (const SceneErrors& e) {
        refused++;
        EXPECT_EQ(e.lines.size(), 1u) << e.what();
        // the place of the value, not of a consequence
        EXPECT_EQ(e.lines[0].find("--set " + key), 0u) << e.lines[0];
      }
    }
  EXPECT_GT(refused, 3 * keys.size());
}

}  // namespace
}  // namespace thaw
