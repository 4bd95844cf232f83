// SPDX-License-Identifier: Apache-2.0
// Obstacles that a Python program moves.
#pragma once
#include <pybind11/pybind11.h>

namespace thaw::python {

/// Defines the class Obstacle of the module.
void defineObstacle(pybind11::module_& module);

}  // namespace thaw::python
