// SPDX-License-Identifier: Apache-2.0
// Extensions whose parts are functions of a Python program.
#pragma once
#include <pybind11/pybind11.h>

#include <string>
#include <tuple>
#include <vector>

namespace thaw::python {

/// (name, unit, default, least, most, meaning)
using KeyNote = std::tuple<std::string, std::string, double, double, double, std::string>;

/// (name, unit, meaning, components, start value)
using AddedField = std::tuple<std::string, std::string, std::string, int, double>;

/// Functions of an extension, each None or made for the values of a scene. load(values) returns the function
/// of callLoad; update(values) a function of (rows, time, dt); step_limit(values) seconds.
struct ExtensionFunctions {
  pybind11::object load, update, stepLimit;
  bool heats = false;
};

/// Registers an extension with keys and fields. Exceptions of its functions end the call of the simulation
/// that called them.
void registerFunctions(const std::string& name, const std::string& about, const std::vector<KeyNote>& keys,
                       const std::vector<AddedField>& fields, const ExtensionFunctions& functions);

}  // namespace thaw::python
