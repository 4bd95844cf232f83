// SPDX-License-Identifier: Apache-2.0
// Local rows of mesh vertices by their numbers in the plans, for mesh contact.
#pragma once
#include <cstdlib>
#include <span>

#include "core/neighbours/grid.hpp"
#include "core/sheet/data/plan_sheets.hpp"

namespace thaw {

struct Sheets;

inline constexpr std::uint32_t noLocalRow = 0xffffffffu;

/// Tables of vertices. Vertices are numbered over all sheets: sheet n starts at first[n].
struct MeshRows {
  std::vector<std::uint32_t> first;     ///< sheets + 1
  std::vector<std::uint32_t> rowOf;     ///< per vertex, including ghosts; noLocalRow if absent
  std::vector<std::uint32_t> numberOf;  ///< per row
  std::vector<Vec3i> cell;              ///< per row
  std::vector<std::uint32_t> before;    ///< vertex numbers with rows in the previous evaluation
  std::vector<std::uint8_t> wasHere;    ///< per vertex: 1 if it had a row in the previous evaluation
};

inline std::uint32_t vertexOf(std::uint64_t id) {
  return static_cast<std::uint32_t>(id & ((1ull << 40) - 1));
}

/// Updates the tables. The cost is proportional to the local rows, not to the mesh. Requires: ghosts with
/// ids.
void findMeshRows(const Sheets& rows, const CellTable& cells, const std::vector<SheetPlan>& plans,
                  MeshRows& found);

/// Returns whether the cells are equal or adjacent.
inline bool beside(const Vec3i& a, const Vec3i& b) {
  return std::abs(a.x - b.x) <= 1 && std::abs(a.y - b.y) <= 1 && std::abs(a.z - b.z) <= 1;
}

/// Returns whether all rows lie in equal or adjacent cells. The owner of each row then has all of the rows.
/// Other combinations are ignored, on any number of ranks.
bool allAdjacent(const MeshRows& m, std::span<const std::uint32_t> rows);

/// Returns the rows of a triangle's corners, noLocalRow where absent.
inline std::array<std::uint32_t, 3> rowsOfTriangle(const MeshRows& m, const SheetPlan& plan,
                                                   std::size_t sheet, std::uint32_t triangle) {
  const auto& v = plan.mesh.triangles[triangle];
  const std::uint32_t* row = m.rowOf.data() + m.first[sheet];
  return {row[v[0]], row[v[1]], row[v[2]]};
}

}  // namespace thaw
