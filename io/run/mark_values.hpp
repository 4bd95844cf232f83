// What marks of a scene (scene_marks.hpp) are made of: numbers by the key that sets them.
#pragma once
#include <initializer_list>
#include <string>
#include <utility>
#include <vector>

#include "core/scene/factor_in_time.hpp"
#include "core/scene/motion.hpp"
#include "core/scene/position_field.hpp"
#include "core/scene/shape.hpp"
#include "io/output/checkpoint.hpp"

namespace thaw {

using MarkNumbers = std::initializer_list<std::pair<const char*, double>>;

void addNumbers(CheckpointValues& marks, const std::string& at, MarkNumbers numbers);

/// Keys "key.x", "key.y", "key.z".
void addVector(CheckpointValues& marks, const std::string& key, const Vec3d& value);

/// What a shape is made and placed by, and its parts'; a mesh by what is in its file, wherever that is.
void addShape(CheckpointValues& marks, const std::string& at, const Shape& shape);

void addInTime(CheckpointValues& marks, const std::string& key, const FactorInTime& factor);
void addMotion(CheckpointValues& marks, const std::string& at, const std::vector<Keyframe>& motion);

/// Fields of the start: expressions by a checksum of their text. Nothing of a field that is not given.
void addField(CheckpointValues& marks, const std::string& key, const PositionField& field);
void addField(CheckpointValues& marks, const std::string& at, const VelocityField& field);

/// Of keys and values.
double checksumOf(const CheckpointValues& marks);

}  // namespace thaw
