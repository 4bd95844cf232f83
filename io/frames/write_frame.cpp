// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cstring>
#include <limits>

#include "io/frames/frame.hpp"
#include "io/hdf5/parallel_file.hpp"
#include "io/text/version.hpp"

namespace thaw {
namespace {

/// Returns the number of particles of each piece. An empty rank has a piece as well.
std::vector<std::int64_t> piecesOf(MPI_Comm comm, std::uint64_t count, std::uint64_t all, bool byRank) {
  if (!byRank) return {static_cast<std::int64_t>(all)};
  int ranks = 1;
  MPI_Comm_size(comm, &ranks);
  std::vector<std::int64_t> pieces(static_cast<std::size_t>(ranks));
  const std::int64_t mine = static_cast<std::int64_t>(count);
  MPI_Allgather(&mine, 1, MPI_INT64_T, pieces.data(), 1, MPI_INT64_T, comm);
  return pieces;
}

using Fill = std::function<void(const RowRange&, std::byte*)>;

/// Returns a fill function whose row i is value(i).
template<class Int, class Value> Fill numbered(Value value) {
  return [value](const RowRange& local, std::byte* to) {
    for (std::uint64_t k = 0; k < local.count; k++) {
      const Int v = static_cast<Int>(value(local.first + k));
      std::memcpy(to + k * sizeof(Int), &v, sizeof(Int));
    }
  };
}

}  // namespace

void writeStamp(H5File& file, const RunStamp& stamp, int ranks) {
  file.setText("/run", "code", std::string("thaw ") + versionNumber());
  file.setText("/run", "commit", versionCommit());
  file.setInteger("/run", "ranks", ranks);
  if (!stamp.extensions.empty()) file.setText("/run", "extensions", stamp.extensions);
  file.writeText("/run/scene_name", stamp.sceneName);
  file.writeText("/run/scene_toml", stamp.sceneText);
}

namespace {

template<class Int>
void writeWith(const std::string& path, MPI_Comm comm, const Frame& frame, const RunStamp& stamp) {
  constexpr Element integer = sizeof(Int) == 4 ? Element::I32 : Element::I64;
  int rank = 0, ranks = 1;
  MPI_Comm_rank(comm, &rank);
  MPI_Comm_size(comm, &ranks);
  const Spread points = spreadRows(comm, frame.count);
  const bool piecesByRank = stamp.piecesByRank && !frame.meshed;  // a triangle may have corners on several
                                                                  // ranks
  const std::vector<std::int64_t> pieces = piecesOf(comm, frame.count, points.all, piecesByRank);
  const bool endsPiece = piecesByRank || rank == ranks - 1;
  const Spread cells = frame.meshed ? spreadRows(comm, frame.triangles.size() / 3) : points,
               ends = frame.meshed ? spreadRows(comm, frame.triangles.size()) : points;
  // Vertex cells have connectivity 0, 1, ... and offsets 0, 1, ... in each piece. Triangles have their own
  // connectivity and offsets 0, 3, ...
  const std::uint64_t corners = frame.meshed ? 3 : 1, firstPoint = piecesByRank ? 0 : points.mine.first,
                      firstOffset = frame.meshed ? 3 * cells.mine.first : firstPoint;
  const Spread offsets = spreadRows(comm, cells.mine.count + endsPiece);

  ParallelFileContent content;
  content.groups = {"/VTKHDF", "/VTKHDF/PointData", "/VTKHDF/CellData", "/VTKHDF/FieldData", "/run"};
  const auto addMade = [&](const std::string& name, Element element, const Spread& spread, Fill fill) {
    content.datasets.push_back({name, {element, spread.all, 0}, spread.mine, nullptr, "", std::move(fill)});
  };
  const auto addField = [&](const std::string& name, const FrameField& f) {
    content.datasets.push_back({name,
                                {elementOf(f.scalar), points.all, f.components > 1 ? f.components : 0},
                                points.mine,
                                f.data,
                                f.unit,
                                f.fill,
                                f.meaning});
  };
  addField("/VTKHDF/Points", frame.positions);
  addMade("/VTKHDF/Connectivity", integer, ends,
          numbered<Int>([&](std::uint64_t i) { return frame.meshed ? frame.triangles[i] : firstPoint + i; }));
  addMade("/VTKHDF/Offsets", integer, offsets,
          numbered<Int>([&](std::uint64_t i) { return firstOffset + corners * i; }));
  addMade("/VTKHDF/Types", Element::U8, cells,
          [&](const RowRange& local, std::byte* to) { std::memset(to, frame.meshed ? 5 : 1, local.count); });
  for (const FrameField& f : frame.fields) addField("/VTKHDF/PointData/" + f.name, f);
  content.smallBytes = stamp.sceneText.size();
  content.small = [&](H5File& file) {
    file.setIntegers("/VTKHDF", "Version", {1, 0});
    file.setText("/VTKHDF", "Type", "UnstructuredGrid");
    const DatasetShape perPiece{Element::I64, pieces.size(), 0};
    const std::vector<std::int64_t> cellsOfPieces = frame.meshed
                                                        ? std::vector{static_cast<std::int64_t>(cells.all)}
                                                        : pieces;
    const std::vector<std::int64_t> endsOfPieces = frame.meshed
                                                       ? std::vector{static_cast<std::int64_t>(ends.all)}
                                                       : pieces;
    file.writeAll("/VTKHDF/NumberOfPoints", perPiece, pieces.data());
    file.writeAll("/VTKHDF/NumberOfCells", perPiece, cellsOfPieces.data());
    file.writeAll("/VTKHDF/NumberOfConnectivityIds", perPiece, endsOfPieces.data());
    file.writeAll("/VTKHDF/FieldData/Time", {Element::F64, 1, 0}, &frame.time);
    file.setText("/VTKHDF/FieldData/Time", "units", "s");
    file.writeAll("/VTKHDF/FieldData/Step", {Element::I64, 1, 0}, &frame.step);
    writeStamp(file, stamp, ranks);
  };
  writeParallelFile(path, comm, content);
}

}  // namespace

void writeFrame(const std::string& path, MPI_Comm comm, const Frame& frame, const RunStamp& stamp,
                std::uint64_t wideFrom) {
  const std::uint64_t largest = std::max<std::uint64_t>(spreadRows(comm, frame.count).all,
                                                        spreadRows(comm, frame.triangles.size()).all);
  if (largest < wideFrom) writeWith<std::int32_t>(path, comm, frame, stamp);
  else writeWith<std::int64_t>(path, comm, frame, stamp);
}

}  // namespace thaw
