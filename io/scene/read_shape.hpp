#pragma once
#include "io/scene/table_reader.hpp"

namespace thaw {

/// Reads the one shape key of a table (mesh, box, sphere, ..., union) and its `place`; none is an error.
/// Describes it by a single line that points to describeShape. Mesh paths are taken as they stand.
void readShape(TableReader& reader, Shape& shape);
/// The keys of shapes, by ShapeKind.
std::vector<std::string> shapeWords();

/// Is there a key of a shape?
bool hasShape(const TableReader& reader);

/// Refuses all keys of shapes, where none is meant.
void refuseShape(TableReader& reader, const char* why);

/// Says what is wrong with the path of a mesh that the key `mesh` of a table has, if anything is: it is to be
/// a file that ends in .obj, .ply or .stl, or one that is built in.
void checkMeshPath(TableReader& reader, const std::string& path);

/// The key `place` alone, of things that are no shapes but stand somewhere.
void readPlace(TableReader& reader, Shape& shape);
/// Describes the keys of all shapes.
void describeShape(TableReader& reader);

}  // namespace thaw
