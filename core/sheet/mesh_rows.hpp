// Where the vertices of the sheets' meshes are on this rank: contact by triangles and edges wants rows by the
// numbers that the plans have.
#pragma once
#include <cstdlib>
#include <span>

#include "core/neighbours/grid.hpp"
#include "core/sheet/plan_sheets.hpp"

namespace thaw {

struct Sheets;

inline constexpr std::uint32_t notHere = 0xffffffffu;

/// Vertices are numbered through all sheets: sheet n begins with number first[n].
struct MeshRows {
  std::vector<std::uint32_t> first;     ///< sheets + 1
  std::vector<std::uint32_t> rowOf;     ///< of each vertex, ghosts too; notHere where it is not here
  std::vector<std::uint32_t> numberOf;  ///< of each row
  std::vector<Vec3i> cell;              ///< of each row
  std::vector<std::uint32_t> before;    ///< numbers that had rows at the evaluation before
  std::vector<std::uint8_t> wasHere;    ///< of each vertex, at the evaluation before
};

inline std::uint32_t vertexOf(std::uint64_t id) {
  return static_cast<std::uint32_t>(id & ((1ull << 40) - 1));
}

/// Needs ghosts with their ids. Takes as long as there are rows here, not as long as the mesh is.
void findMeshRows(const Sheets& rows, const CellTable& cells, const std::vector<SheetPlan>& plans,
                  MeshRows& found);

/// Is the one cell the other, or beside it?
inline bool beside(const Vec3i& a, const Vec3i& b) {
  return std::abs(a.x - b.x) <= 1 && std::abs(a.y - b.y) <= 1 && std::abs(a.z - b.z) <= 1;
}

/// Are these rows each in the cell of each other, or beside it? Then the owner of each sees all of them; what
/// is not so acts on nobody, on any number of ranks.
bool allBeside(const MeshRows& m, std::span<const std::uint32_t> rows);

/// Rows of a triangle of a mesh, with notHere where a corner is not here.
inline std::array<std::uint32_t, 3> rowsOfTriangle(const MeshRows& m, const SheetPlan& plan,
                                                   std::size_t sheet, std::uint32_t triangle) {
  const auto& v = plan.mesh.triangles[triangle];
  const std::uint32_t* row = m.rowOf.data() + m.first[sheet];
  return {row[v[0]], row[v[1]], row[v[2]]};
}

}  // namespace thaw
