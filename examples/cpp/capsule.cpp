// SPDX-License-Identifier: Apache-2.0
// A shape of the program's own: an exact capsule. It is an obstacle on which a jelly ball comes to rest, and
// a body.
// capsule [FOLDER]: with a folder, it writes frames.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <numbers>
#include <string>

#include "core/terms/extensions.hpp"
#include "io/simulation/simulation.hpp"
#include "parallel/communicator.hpp"

namespace {

/// All points within a radius of a segment on the z axis, centred on the origin.
class Capsule final : public thaw::SignedDistance {
 public:
  Capsule(double radius, double length) : radius_(radius), half_(0.5 * length) {}
  double distance(const thaw::Vec3d& x, thaw::Vec3d* gradient) const override {
    const thaw::Vec3d d{x.x, x.y, x.z - std::clamp(x.z, -half_, half_)};
    const double r = thaw::length(d);
    if (gradient) *gradient = r > 0 ? d / r : thaw::Vec3d{1, 0, 0};
    return r - radius_;
  }
  thaw::Bounds bounds() const override {
    return {{-radius_, -radius_, -half_ - radius_}, {radius_, radius_, half_ + radius_}};
  }
  bool convex() const override { return true; }

 private:
  double radius_, half_;
};

thaw::Extension capsule() {
  return {
      .name = "capsule",
      .about = "a cylinder with round ends, along z",
      .keys = {{"radius", "m", 0.1, 1e-6, 1e3, "radius"}, {"length", "m", 0.2, 0, 1e3, "without the ends"}},
      .shape =
          [](const thaw::ExtensionSettings& s) {
            return std::make_shared<Capsule>(s.values.at("radius"), s.values.at("length"));
          },
  };
}

constexpr const char* scene = R"(
spacing = "3 cm"
end = 0.3
[domain]
min = [-1, -1, -1]
max = [1, 1, 1]
[material.jelly]
density = 1000
young = "500 kPa"
damping = "20 1/s"
[[body]]
name = "bean"
capsule = { radius = "12 cm", length = "20 cm" }
place = { rotate_y = "90 deg", move = [0, 0, 0.3] }
material = "jelly"
[[obstacle]]
name = "bar"
capsule = { radius = "10 cm", length = "1 m" }
place = { rotate_x = "90 deg" }
)";

}  // namespace

int main(int argc, char** argv) {
  thaw::MpiSession mpi(&argc, &argv);
  thaw::registerExtension(capsule());
  const std::string out = argc > 1 ? argv[1] : "";
  thaw::Simulation sim = thaw::Simulation::fromText(scene, {.scene = "capsule", .out = out}, MPI_COMM_SELF);
  const thaw::Continuum& p = sim.particles();
  const double spacing = sim.scene().spacing, pi = std::numbers::pi;
  const double volume = static_cast<double>(p.owned) * spacing * spacing * spacing,
               exact = pi * 0.12 * 0.12 * (0.2 + 4.0 / 3 * 0.12);
  double nearest = 1;
  sim.onStep([&] {
    for (std::size_t i = 0; i < p.owned; i++)
      nearest = std::min(nearest, std::hypot(p.position[i].x, p.position[i].z) - 0.1);
  });
  sim.run();
  sim.finish();
  std::printf("%zu particles fill %.3f of the volume; nearest to the bar: %.3f spacings\n", p.owned,
              volume / exact, nearest / spacing);
  return std::abs(volume / exact - 1) < 0.1 && nearest > 0 && nearest < spacing ? 0 : 1;
}
