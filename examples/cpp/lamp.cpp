// SPDX-License-Identifier: Apache-2.0
// A source of heat with a field of its own. A lamp heats everything above a height, and each particle keeps
// the dose that it absorbed. The dose moves with the particles, is in checkpoints and in frames.
// lamp [FOLDER]: with a folder, it writes frames, and continues from its checkpoint.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

#include "core/terms/extensions.hpp"
#include "io/simulation/simulation.hpp"
#include "parallel/communicator.hpp"

namespace {

constexpr const char* scene = R"toml(
spacing = "4 cm"
end = 0.2
[domain]
min = [-1, -1, 0]
max = [1, 1, 1]
sides = { x = "wall", y = "wall", z = "wall" }
[material.wax]
density = 900
young = "1 MPa"
conductivity = "0.2 W/(m K)"
heat_capacity = "2000 J/(kg K)"
[[body]]
name = "block"
box = { size = [0.4, 0.4, 0.4] }
place = { bottom = [0, 0, 0] }
material = "wax"
temperature = 300
[extension.lamp]
power = "500 W/kg"
height = "20 cm"
[output]
every = 0.1
fields = ["temperature", "dose"]
)toml";

double powerAt(const thaw::ExtensionSettings& lamp, const thaw::Vec3d& x) {
  return x.z > lamp.values.at("height") ? lamp.values.at("power") : 0;
}

thaw::Extension lamp() {
  return {
      .name = "lamp",
      .about = "heat above a height",
      .keys = {{"power", "W/kg", 100, 0, 1e6, "power per mass"}, {"height", "m", 0, -1e3, 1e3, "lower end"}},
      .load =
          [](const thaw::ExtensionSettings& settings) {
            return [settings](const thaw::OutsideLoad& load) {
              const thaw::Continuum& p = load.particles;
              for (std::size_t i = 0; i < p.owned; i++)
                load.heat[i] += powerAt(settings, p.position[i]) * p.mass[i];
            };
          },
      .fields = {{"dose", "J/kg", "heat absorbed from the lamp"}},
      .update =
          [](const thaw::ExtensionSettings& settings) {
            return [settings](const thaw::FieldStep& step) {
              thaw::AddedColumn& dose = *step.particles.addedField("dose");
              for (std::size_t i = 0; i < step.particles.owned; i++)
                dose.row(i)[0] += powerAt(settings, step.particles.position[i]) * step.dt;
            };
          },
      .heats = true,
  };
}

}  // namespace

int main(int argc, char** argv) {
  thaw::MpiSession mpi(&argc, &argv);
  thaw::registerExtension(lamp());
  const std::string out = argc > 1 ? argv[1] : "";
  thaw::Simulation sim = thaw::Simulation::fromText(scene, {.scene = "lamp", .out = out, .resume = argc > 1});
  sim.run();
  const thaw::Continuum& p = sim.particles();
  const thaw::AddedColumn& dose = *p.addedField("dose");
  double absorbed = 0, most = 0;
  for (std::size_t i = 0; i < p.owned; i++) {
    absorbed += dose.row(i)[0] * p.mass[i];
    most = std::max(most, dose.row(i)[0]);
  }
  double sum = 0;
  MPI_Allreduce(&absorbed, &sum, 1, MPI_DOUBLE, MPI_SUM, sim.communicator());
  MPI_Allreduce(MPI_IN_PLACE, &most, 1, MPI_DOUBLE, MPI_MAX, sim.communicator());
  const double heat = sim.ledger().heatIn;
  if (sim.rank() == 0)
    std::printf("absorbed %.9g J, ledger %.9g J, largest dose %.6g J/kg\n", sum, heat, most);
  sim.finish();
  return std::abs(sum - heat) < 1e-9 * heat && heat > 0 ? 0 : 1;
}
