// SPDX-License-Identifier: Apache-2.0
// Keys of the initial state that are numbers or fields of position.
#pragma once
#include "io/scene/tables/table_reader.hpp"

namespace thaw {

/// Reads three quantities, or a table of x, y and z with quantities or expressions.
void readVelocity(TableReader& reader, Vec3d& velocity, VelocityField& field, const char* about);
/// Reads a table of expressions alone.
void readVelocityField(TableReader& reader, VelocityField& field, const char* about);
/// Reads the key `velocity_gradient`: three lists of three.
void readVelocityGradient(TableReader& reader, VelocityField& field, const char* about);
/// Reads the key `temperature`: a quantity, or a text with an expression.
void readTemperature(TableReader& reader, double& temperature, PositionField& field, const char* about);

}  // namespace thaw
