// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "io/scene/tables/table_reader.hpp"

namespace thaw {

/// Reads the one shape key of a table (mesh, box, sphere, ..., union) and its `place`; a missing one is an
/// error. Describes it by a single line that points to describeShape. Does not resolve paths of meshes.
void readShape(TableReader& reader, Shape& shape);
/// Returns the keys of shapes, by ShapeKind.
std::vector<std::string> shapeWords();

/// Returns whether a table has a key of a shape.
bool hasShape(const TableReader& reader);

/// Refuses all keys of shapes.
void refuseShape(TableReader& reader, const char* why);

/// Checks the path of the key `mesh` of a table: a file that ends in .obj, .ply or .stl, or a built-in mesh.
void checkMeshPath(TableReader& reader, const std::string& path);

/// Reads the key `place` alone, for bodies without a shape.
void readPlace(TableReader& reader, Shape& shape);
/// Describes the keys of all shapes.
void describeShape(TableReader& reader);

}  // namespace thaw
