#pragma once
#include "io/scene/table_reader.hpp"

namespace thaw {

/// Reads the one shape key of a table (mesh, box, sphere, ..., union) and its `place`. required: an error where there is none.
void readShape(TableReader& reader, Shape& shape, const std::string& folder, bool required);

}  // namespace thaw
