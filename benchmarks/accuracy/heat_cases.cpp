// Heat conduction against exact solutions (accuracy.md A, heat and phase change).
#include <cmath>

#include "benchmarks/accuracy/trial.hpp"

namespace thaw::accuracy {
namespace {

/// Two half-spaces brought into contact at z = 0: the interface is at once at (e1 T1 + e2 T2)/(e1 + e2), e = sqrt(k rho c), with error
/// functions on both sides (Carslaw & Jaeger 1959, 2.8).
struct Slabs {
  const Scene& s;
  double effusivity(int m) const { return std::sqrt(k(m) * material(m).density * material(m).heatCapacity.at(1)); }
  double k(int m) const { return material(m).conductivity.at(1); }
  double diffusivity(int m) const { return k(m) / (material(m).density * material(m).heatCapacity.at(1)); }
  const Material& material(int m) const { return s.materials[static_cast<std::size_t>(s.bodies[static_cast<std::size_t>(m)].material)]; }
  double operator()(double z, double t) const {
    const double T[2] = {s.bodies[0].temperature, s.bodies[1].temperature}, e[2] = {effusivity(0), effusivity(1)};
    const double middle = (e[0] * T[0] + e[1] * T[1]) / (e[0] + e[1]);
    const int side = z > 0;
    return middle + (T[side] - middle) * std::erf(std::abs(z) / (2 * std::sqrt(diffusivity(side) * t)));
  }
};

std::vector<Figure> measureSlabs(Trial& r) {
  const Slabs exact{r.world.scene};
  const double scale = std::abs(r.world.scene.bodies[1].temperature - r.world.scene.bodies[0].temperature);
  const auto error = [&](const World& w, std::size_t i) { return (w.particles.temperature[i] - exact(w.particles.position[i].z, w.clock.time)) / scale; };
  const LedgerReport books = reportLedger(r.world, r.all);
  return {{"L2(T)", rootMeanSquare(r, error)},
          {"Linf(T)", largest(r, [&](const World& w, std::size_t i) { return std::abs(error(w, i)); }), 0.005},
          {"heat residual", std::abs(books.heatResidual) / (scale * books.now.mass * r.world.scene.materials[0].heatCapacity.at(1)), 1e-12}};
}

}  // namespace

std::vector<Case> heatCases() {
  return {{"slabs", "slabs of two conductivities in contact; error functions (Carslaw & Jaeger 1959)", nullptr, {}, {}, {}, measureSlabs}};
}

}  // namespace thaw::accuracy
