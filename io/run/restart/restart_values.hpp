// SPDX-License-Identifier: Apache-2.0
// Values of the restart record (restart_record.hpp): numbers by the key that sets them.
#pragma once
#include <initializer_list>
#include <string>
#include <utility>
#include <vector>

#include "core/scene/factor_in_time.hpp"
#include "core/scene/motion.hpp"
#include "core/scene/position_field.hpp"
#include "core/scene/shape.hpp"
#include "io/checkpoint/checkpoint.hpp"

namespace thaw {

using RecordNumbers = std::initializer_list<std::pair<const char*, double>>;

void addNumbers(CheckpointValues& record, const std::string& at, RecordNumbers numbers);

/// Adds the keys "key.x", "key.y", "key.z".
void addVector(CheckpointValues& record, const std::string& key, const Vec3d& value);

/// Adds the geometry and the place of a shape and its parts. A mesh counts by the content of its file, not by
/// its path.
void addShape(CheckpointValues& record, const std::string& at, const Shape& shape);

void addInTime(CheckpointValues& record, const std::string& key, const FactorInTime& factor);
void addMotion(CheckpointValues& record, const std::string& at, const std::vector<Keyframe>& motion);

/// Adds a field of the start; an expression counts by a checksum of its text. Adds nothing for an unset
/// field.
void addField(CheckpointValues& record, const std::string& key, const PositionField& field);
void addField(CheckpointValues& record, const std::string& at, const VelocityField& field);

/// Returns a checksum of keys and values.
double checksumOf(const CheckpointValues& record);

}  // namespace thaw
