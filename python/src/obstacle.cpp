// SPDX-License-Identifier: Apache-2.0
#include "python/src/obstacle.hpp"

#include <pybind11/stl.h>

#include <array>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "io/simulation/driven_obstacle.hpp"
#include "python/src/python_simulation.hpp"

namespace py = pybind11;

namespace thaw::python {
namespace {

using Three = std::array<double, 3>;

Vec3d vectorOf(const Three& v) { return {v[0], v[1], v[2]}; }
Three threeOf(const Vec3d& v) { return {v.x, v.y, v.z}; }

/// An obstacle and its simulation, which outlives it.
struct ObstacleOfProgram {
  PythonSimulation& sim;
  DrivenObstacle obstacle;
};

/// Force, then torque. Collective.
std::pair<Three, Three> loadOf(const ObstacleOfProgram& o) {
  const ObstacleLoad load = o.sim.loadOf(o.obstacle);
  return {threeOf(load.force), threeOf(load.torque)};
}

void move(ObstacleOfProgram& o, const Three& position, const Three& velocity, const Three& rotation,
          const Three& rotationRate) {
  o.obstacle.move({vectorOf(position), vectorOf(velocity), vectorOf(rotation), vectorOf(rotationRate)});
}

/// Names of the obstacles of the scene.
std::vector<std::string> obstacleNames(PythonSimulation& sim) {
  std::vector<std::string> names;
  for (const Obstacle& o : sim.simulation().scene().obstacles) names.push_back(o.name);
  return names;
}

}  // namespace

void defineObstacle(py::module_& m) {
  m.def("obstacle_names", &obstacleNames);
  py::class_<ObstacleOfProgram>(m, "Obstacle")
      .def(py::init([](PythonSimulation& sim, const std::string& name) {
             return std::unique_ptr<ObstacleOfProgram>(
                 new ObstacleOfProgram{sim, DrivenObstacle(sim.simulation(), name)});
           }),
           py::keep_alive<1, 2>())
      .def("move", &move, py::arg("position"), py::arg("velocity"), py::arg("rotation"),
           py::arg("rotation_rate"))
      .def_property_readonly("position",
                             [](const ObstacleOfProgram& o) { return threeOf(o.obstacle.pose().move); })
      .def_property_readonly("rotation",
                             [](const ObstacleOfProgram& o) { return threeOf(o.obstacle.pose().rotate); })
      .def_property_readonly("velocity",
                             [](const ObstacleOfProgram& o) { return threeOf(o.obstacle.pose().velocity); })
      .def("load", &loadOf);
}

}  // namespace thaw::python
