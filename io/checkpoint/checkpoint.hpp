// SPDX-License-Identifier: Apache-2.0
// Checkpoints: the whole state in full precision, written alternately to two files (OUT/checkpoint/a.hdf,
// b.hdf). One complete file thus always exists. Any number of ranks can write and read them. A run that stops
// between two snapshots (core/simulation/monitor/) leaves the last snapshot beside them, good_<step>.hdf, for
// a later rollback.
//   /checkpoint          @format @sequence @step @frame @time @end @every @dt ...; counters, ledger, initial,
//                        values
//   /particles/<field>[N, c]   State columns of Continuum, in the order of (rank, row)
//   /solids/<field>[M, c]      State columns of Solids, in the order of their particles
//   /bonds/neighbour[B]        in the order of solids; with a reference at both ends also reference[B, 3]
//                              reverse[B, 3] weight[B]
//   /order                     solid_particle[M]: row of the particle; first_bond[M]: row of the first bond
//   /surfels/<field>[S, c]     State columns of Surfels, with a surface
//   /surface                   @last_step, counters; components/<member>[K], events/<member>[E]
//   /oriented/<field>, /sheet/<field>   State columns of oriented bodies and sheets
//   (core/simulation/body_types/) Every dataset with rows of all ranks has a checksum. The trailer of the
//   file (io/hdf5/file_trailer.hpp) has a checksum of all other bytes. It is checked before HDF5 opens the
//   file.
#pragma once
#include <mpi.h>

#include <array>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/simulation/monitor/snapshot.hpp"
#include "core/simulation/world/body_types.hpp"
#include "core/simulation/world/world.hpp"
#include "core/solid/bonds/bond_records.hpp"
#include "io/frames/frame.hpp"

namespace thaw {

/// Version of the layout of the files and of the meaning of their values. Other versions are refused.
inline constexpr std::int64_t checkpointFormat = 8;

/// Further values of a run as texts, by name.
using CheckpointValues = std::map<std::string, std::string>;

/// State of a surface besides its surfels; the same on all ranks.
struct SurfaceRecord {
  bool there = false;
  std::int64_t lastStep = -1;
  SurfaceCounters counters;
  std::vector<SurfaceComponent> components;
  std::vector<SurfaceEvent> events;
};

/// A checkpoint without particles, solids and bonds. Counters and ledger are sums over all ranks.
struct CheckpointHeader {
  std::string path;
  std::int64_t sequence = 0;  ///< grows by one with each checkpoint in a folder, so that the largest is the
                              ///< newest
  Clock clock;                ///< without limitedBy
  std::string limitedBy;
  std::uint64_t particles = 0, solids = 0, bonds = 0, surfels = 0;
  std::uint64_t pieces = 0;                                              ///< rigid pieces
  std::array<std::optional<std::uint64_t>, bodyTypeCount> bodyTypeRows;  ///< rows of oriented bodies and
                                                                         ///< sheets, if the file has them
  bool twoFrames = false;  ///< bonds have a reference at both ends; else all refer to one configuration
  Counters counters;
  Ledger ledger;
  SurfaceRecord surface;
  MonitorState monitor;  ///< snapshotStep is -1 in files of versions without it
  CheckpointValues values;
  std::string code, commit, sceneName, sceneText;
  std::string extensions;  ///< names of extensions of programs: "lamp, capsule"
  std::int64_t ranks = 0;
};

/// Share of one rank: particles [r N/P, (r+1) N/P) with their solids and bonds.
struct CheckpointSlice {
  CheckpointHeader header;               ///< the same on all ranks
  Continuum particles;                   ///< State columns that the file has are active
  Solids solids;                         ///< active columns as above; rows in the order of their particles
  std::vector<std::uint32_t> bondCount;  ///< bonds per solid
  std::vector<BondRecord> bonds;         ///< in the order of solids
  Pieces pieces;                         ///< active columns as above; unsorted
  Surfels surfels;                       ///< surfels [r S/P, (r+1) S/P)
  Oriented oriented;                     ///< active columns as above; unsorted
  Sheets sheets;
  BodyTypeRows& kind(std::size_t k) {
    return k == orientedType ? static_cast<BodyTypeRows&>(oriented) : sheets;
  }
  const BodyTypeRows& kind(std::size_t k) const {
    return k == orientedType ? static_cast<const BodyTypeRows&>(oriented) : sheets;
  }
  std::vector<std::string> warnings;  ///< about newer files that could not be used
};

/// Writes a checkpoint into the older of the two files. It contains owned particles, solids and bonds, the
/// clock, and the sums over ranks of ledger and counters. The file is synced to disk, read back and compared
/// before it gets its name. Returns its path. On failure throws the same IoError on all ranks, and the
/// existing checkpoints remain. Requires: Continuum::solidIndex is up to date. Collective.
std::string writeCheckpoint(const std::string& out, MPI_Comm comm, const World& world, const RunStamp& stamp,
                            const CheckpointValues& values = {});

std::string writeCheckpoint(const std::string& out, MPI_Comm comm, const WorldSnapshot& kept,
                            const RunStamp& stamp, const CheckpointValues& values = {});

/// Writes the snapshot that a checkpoint between two snapshots needs to OUT/checkpoint/good_<step>.hdf, in
/// the same format. Call it before writeCheckpoint, so that the checkpoint never names a missing file.
std::string writeSnapshot(const std::string& out, MPI_Comm comm, const WorldSnapshot& kept,
                          const RunStamp& stamp, const CheckpointValues& values = {});
std::string snapshotFilePath(const std::string& out, std::int64_t step);

/// Removes snapshots that neither checkpoint of a run folder needs. One process only.
void dropUnusedSnapshots(const std::string& out);

/// Reads the share of each rank of a checkpoint and compares checksums. Throws the same IoError on all ranks
/// if the file is damaged. Collective.
std::unique_ptr<CheckpointSlice> readCheckpoint(const std::string& path, MPI_Comm comm);

/// Reads the newest readable checkpoint of OUT/checkpoint. A damaged newer one becomes a warning. Returns
/// nullptr if there is none; throws IoError if none is readable. Collective.
std::unique_ptr<CheckpointSlice> readNewestCheckpoint(const std::string& out, MPI_Comm comm);

/// Restores a world from a checkpoint: particles, clock, counters and ledger. Particles have the order of the
/// file and no solid indices. End and frame interval of the clock remain those of the scene. Counters and
/// ledger are on the first rank, and zero on others, so that sums are right. Returns records of the solids
/// for MpiBondHalo::adopt. Surfels are unsorted, for resumeSurface (core/surface/resume_surface.hpp). Sort,
/// adopt and rebuildBonds before particles migrate, so that bonds move with them. Throws IoError if the file
/// lacks a field that the scene needs. Requires: the fields of the scene are active. Not collective; fails
/// alike on all ranks.
std::vector<std::byte> restoreWorld(World& world, const CheckpointSlice& slice, bool firstRank);

/// Reads the header of a file. One process only.
CheckpointHeader readCheckpointHeader(const std::string& path);

/// Returns the readable headers of the checkpoints of a run folder, newest first. `problems` gets a line for
/// each damaged one.
std::vector<CheckpointHeader> findCheckpoints(const std::string& out,
                                              std::vector<std::string>* problems = nullptr);

bool isCheckpoint(const H5File& file);

}  // namespace thaw
