// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "io/scene/tables/table_reader.hpp"

namespace thaw {

/// Reads the one shape key of a table (mesh, box, sphere, ..., union) and its `place`. A missing one is an
/// error. Describes it by a single line that points to describeShape. Does not resolve paths of meshes.
void readShape(TableReader& reader, Shape& shape);
/// Returns whether a table has a key of a shape.
bool hasShape(const TableReader& reader);

/// Refuses all keys of shapes.
void refuseShape(TableReader& reader, const char* why);

/// Reads the key `mesh`: a file that ends in .obj, .ply or .stl, or a built-in mesh. Records its fingerprint.
void readMesh(TableReader& reader, Shape& shape, const char* about);

/// Reads the key `place` alone, for bodies without a shape.
void readPlace(TableReader& reader, Shape& shape);
/// Reads the key `clamp`: a list of tables with a shape each.
void readClamps(TableReader& reader, std::vector<Shape>& clamps, const char* about);
/// Describes the keys of all shapes.
void describeShapes(TableReader& reader);

}  // namespace thaw
