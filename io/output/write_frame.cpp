#include <algorithm>
#include <limits>
#include <numeric>

#include "io/hdf5/parallel_file.hpp"
#include "io/output/frame.hpp"
#include "io/version.hpp"

namespace thaw {
namespace {

/// Particles of each piece. Empty ranks are pieces as well.
std::vector<std::int64_t> piecesOf(MPI_Comm comm, std::uint64_t count, std::uint64_t all, bool byRank) {
  if (!byRank) return {static_cast<std::int64_t>(all)};
  int ranks = 1;
  MPI_Comm_size(comm, &ranks);
  std::vector<std::int64_t> pieces(static_cast<std::size_t>(ranks));
  const std::int64_t mine = static_cast<std::int64_t>(count);
  MPI_Allgather(&mine, 1, MPI_INT64_T, pieces.data(), 1, MPI_INT64_T, comm);
  return pieces;
}

/// One vertex cell a particle: connectivity 0..n-1 in each piece, offsets 0..n; or triangles. As int32 where that is enough.
template<class Int> struct Topology {
  std::vector<Int> connectivity, offsets;
  std::vector<std::uint8_t> types;
  Topology(const std::vector<std::uint64_t>& triangles, std::uint64_t first, bool last) : connectivity(triangles.begin(), triangles.end()), types(triangles.size() / 3, 5) {
    for (std::uint64_t k = 0; k < triangles.size() / 3 + last; k++) offsets.push_back(static_cast<Int>(3 * (first + k)));
  }
  Topology(std::uint64_t count, std::uint64_t firstInPiece, bool endsPiece) : connectivity(count), offsets(count), types(count, 1) {
    std::iota(connectivity.begin(), connectivity.end(), static_cast<Int>(firstInPiece));
    std::iota(offsets.begin(), offsets.end(), static_cast<Int>(firstInPiece));
    if (endsPiece) offsets.push_back(static_cast<Int>(firstInPiece + count));
  }
};

}  // namespace

void writeStamp(H5File& file, const RunStamp& stamp, int ranks) {
  file.setText("/run", "code", std::string("thaw ") + versionNumber());
  file.setText("/run", "commit", versionCommit());
  file.setInteger("/run", "ranks", ranks);
  file.writeText("/run/scene_name", stamp.sceneName);
  file.writeText("/run/scene_toml", stamp.sceneText);
}

namespace {

template<class Int> void writeWith(const std::string& path, MPI_Comm comm, const Frame& frame, const RunStamp& stamp) {
  constexpr Element integer = sizeof(Int) == 4 ? Element::I32 : Element::I64;
  int rank = 0, ranks = 1;
  MPI_Comm_rank(comm, &rank);
  MPI_Comm_size(comm, &ranks);
  const Spread points = spreadRows(comm, frame.count);
  const bool piecesByRank = stamp.piecesByRank && !frame.meshed;  // a triangle may have corners on several ranks
  const std::vector<std::int64_t> pieces = piecesOf(comm, frame.count, points.all, piecesByRank);
  const bool endsPiece = piecesByRank || rank == ranks - 1;
  const Spread cells = frame.meshed ? spreadRows(comm, frame.triangles.size() / 3) : points, ends = frame.meshed ? spreadRows(comm, frame.triangles.size()) : points;
  const Topology<Int> topology = frame.meshed ? Topology<Int>(frame.triangles, cells.mine.first, endsPiece)
                                              : Topology<Int>(frame.count, piecesByRank ? 0 : points.mine.first, endsPiece);
  const Spread offsets = spreadRows(comm, topology.offsets.size());

  ParallelFileContent content;
  content.groups = {"/VTKHDF", "/VTKHDF/PointData", "/VTKHDF/CellData", "/VTKHDF/FieldData", "/run"};
  const auto add = [&](const std::string& name, const DatasetShape& shape, const Spread& spread, const void* data, const std::string& unit) {
    content.datasets.push_back({name, {shape.element, spread.all, shape.components}, spread.mine, data, unit, {}});
  };
  add("/VTKHDF/Points", {elementOf(frame.positions.scalar), 0, 3}, points, frame.positions.data, frame.positions.unit);
  add("/VTKHDF/Connectivity", {integer, 0, 0}, ends, topology.connectivity.data(), "");
  add("/VTKHDF/Offsets", {integer, 0, 0}, offsets, topology.offsets.data(), "");
  add("/VTKHDF/Types", {Element::U8, 0, 0}, cells, topology.types.data(), "");
  for (const FrameField& f : frame.fields)
    add("/VTKHDF/PointData/" + f.name, {elementOf(f.scalar), 0, f.components > 1 ? f.components : 0}, points, f.data, f.unit);
  content.smallBytes = stamp.sceneText.size();
  content.small = [&](H5File& file) {
    file.setIntegers("/VTKHDF", "Version", {1, 0});
    file.setText("/VTKHDF", "Type", "UnstructuredGrid");
    const DatasetShape perPiece{Element::I64, pieces.size(), 0};
    const std::vector<std::int64_t> cellsOfPieces = frame.meshed ? std::vector{static_cast<std::int64_t>(cells.all)} : pieces;
    const std::vector<std::int64_t> endsOfPieces = frame.meshed ? std::vector{static_cast<std::int64_t>(ends.all)} : pieces;
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

void writeFrame(const std::string& path, MPI_Comm comm, const Frame& frame, const RunStamp& stamp) {
  const std::uint64_t largest = std::max<std::uint64_t>(spreadRows(comm, frame.count).all, spreadRows(comm, frame.triangles.size()).all);
  if (largest < static_cast<std::uint64_t>(std::numeric_limits<std::int32_t>::max())) writeWith<std::int32_t>(path, comm, frame, stamp);
  else writeWith<std::int64_t>(path, comm, frame, stamp);
}

}  // namespace thaw
