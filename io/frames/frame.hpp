// SPDX-License-Identifier: Apache-2.0
// Frames: VTKHDF 1.0 files of type UnstructuredGrid, which ParaView, VTK and h5py read. The cells are one
// vertex per particle, or triangles.
#pragma once
#include <mpi.h>

#include <array>
#include <cstdint>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "io/hdf5/h5_file.hpp"

namespace thaw {

/// A field of a frame on this rank: `count` rows of `components` scalars. Symmetric tensors are XX YY ZZ XY
/// YZ XZ.
struct FrameField {
  std::string name, unit;
  Scalar scalar = Scalar::F32;
  int components = 1;
  const void* data = nullptr;  ///< `count` rows; nullptr: `fill` makes them
  /// Writes rows [first, first + count) of this rank to `to`. Called chunk by chunk, so that a frame needs no
  /// memory of its own.
  std::function<void(const RowRange& local, std::byte* to)> fill = {};
  std::string meaning = {};  ///< one line, for fields of extensions
};

/// This rank's part of a frame. time, step and the fields' names and types are the same on all ranks.
struct Frame {
  double time = 0;  ///< s
  std::int64_t step = 0;
  std::uint64_t count = 0;  ///< particles of this rank
  FrameField positions;     ///< m, 3 components, F32 or F64
  std::vector<FrameField> fields;
  bool meshed = false;  ///< cells are triangles (the same on all ranks), else one vertex per particle
  std::vector<std::uint64_t> triangles;  ///< three rows each, numbered over all ranks
};

/// Origin of a file, in its group /run.
struct RunStamp {
  std::string sceneName;        ///< stem of the scene's file
  std::string sceneText;        ///< TOML
  bool piecesByRank = false;    ///< one piece of a frame per rank, for parallel ParaView
  std::string extensions = {};  ///< names of extensions of programs: "lamp, capsule"
};

/// Writes a frame; a frame of triangles has one piece. On failure nothing changes, and the same IoError is
/// thrown on all ranks. Connectivity and offsets are 64-bit numbers from `wideFrom` points or corners on,
/// else 32-bit ones. Collective.
void writeFrame(const std::string& path, MPI_Comm comm, const Frame& frame, const RunStamp& stamp,
                std::uint64_t wideFrom = std::numeric_limits<std::int32_t>::max());

/// Writes the group /run: code, commit, ranks, extensions, scene_name, scene_toml. Rank 0 only.
void writeStamp(H5File& file, const RunStamp& stamp, int ranks);

/// A field as read. bytes: rows * components elements.
struct FrameColumn {
  std::string name, unit;
  Element element = Element::F32;
  int components = 1;
  std::vector<std::byte> bytes;
  /// Returns element c of a row as a double.
  double value(std::size_t row, int c = 0) const;
};

/// A whole frame in the memory of one process, for pictures, export and information.
struct FrameData {
  double time = 0;  ///< s
  std::int64_t step = 0;
  std::uint64_t pieces = 1;
  std::vector<Vec3d> positions;                         ///< m
  std::vector<FrameColumn> columns;                     ///< without the positions
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< rows; empty where the cells are points
  std::string code, commit, sceneName, sceneText;
  std::int64_t ranks = 0;
  const FrameColumn* find(const std::string& name) const;
};

/// Reads a frame. wanted: selects fields by name; an empty function selects all. Throws IoError for a file
/// that is not a frame, or is truncated or damaged.
FrameData readFrame(const std::string& path, const std::function<bool(const std::string&)>& wanted = {});

/// A frame without its rows: time, step, sizes.
struct FrameInfo {
  double time = 0;
  std::int64_t step = 0, ranks = 0;
  std::uint64_t count = 0, pieces = 1;
  struct Field {
    std::string name, unit;
    DatasetShape shape;
  };
  std::vector<Field> fields;  ///< points first, as "position"
  std::string code, commit, sceneName;
};
FrameInfo readFrameInfo(const std::string& path);

/// True for a file that has the groups of a frame.
bool isFrame(const H5File& file);

}  // namespace thaw
