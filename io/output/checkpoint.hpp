// Checkpoints: the whole state in full precision, in two files that alternate (OUT/checkpoint/a.hdf, b.hdf),
// so that one that is whole is always there. Written by any number of ranks and read by any other. A run that
// stops between two good states (core/watch/) leaves the one to which a retry would go back beside them,
// good_<step>.hdf.
//   /checkpoint  @format @sequence @step @frame @time @end @every @dt ...; counters, ledger_digits,
//   ledger_initial, values /particles/<field>[N, c]   State columns of Continuum, in the order of (rank, row)
//   /solids/<field>[M, c]      State columns of Solids, in the order of their particles
//   /bonds/neighbour[B], and where both ends of a bond have their own reference reference[B,3] reverse[B,3]
//   weight[B]; in the order of solids /order/solid_particle[M] first_bond[M]   row of a solid's particle; row
//   of its first bond /surfels/<field>[S, c]     State columns of Surfels; only with a surface, as are
//   /oriented/<field>, /sheet/<field>  State columns of the further kinds (core/kinds/), where the scene has
//   them /surface                   @last_step, counters; components/<member>[K], events/<member>[E]
// Every dataset that is spread over the ranks has a checksum. All other bytes have one in the file's trailer
// (io/hdf5/file_trailer.hpp), which is compared before HDF5 opens the file.
#pragma once
#include <mpi.h>

#include <array>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/kinds/kinds.hpp"
#include "core/solid/bond_records.hpp"
#include "core/watch/good_state.hpp"
#include "core/world.hpp"
#include "io/output/frame.hpp"

namespace thaw {

/// Of the layout of the files, and of what their values say; other ones are refused.
inline constexpr std::int64_t checkpointFormat = 7;

/// Further numbers of a run that are not in a World, by name.
using CheckpointValues = std::map<std::string, double>;

/// What a surface holds beside its surfels; the same on all ranks.
struct SurfaceRecord {
  bool there = false;
  std::int64_t lastStep = -1;
  SurfaceCounters counters;
  std::vector<SurfaceComponent> components;
  std::vector<SurfaceEvent> events;
};

/// All of a checkpoint but particles, solids and bonds. Counters and ledger are sums over all ranks.
struct CheckpointHeader {
  std::string path;
  std::int64_t sequence = 0;  ///< grows by one with each checkpoint in a folder: the largest is the newest
  Clock clock;                ///< without limitedBy
  std::string limitedBy;
  std::uint64_t particles = 0, solids = 0, bonds = 0, surfels = 0;
  std::array<std::optional<std::uint64_t>, kindCount> kinds;  ///< rows of the further kinds that the file has
  bool twoFrames = false;  ///< bonds have their own reference at both ends; else all are of one configuration
  Counters counters;
  Ledger ledger;
  SurfaceRecord surface;
  WatchState watch;  ///< goodStep -1 in files of before there was a watch
  CheckpointValues values;
  std::string code, commit, sceneName, sceneText;
  std::int64_t ranks = 0;
};

/// One rank's share: particles [r N/P, (r+1) N/P) with their solids and bonds.
struct CheckpointSlice {
  CheckpointHeader header;               ///< the same on all ranks
  Continuum particles;                   ///< State columns that the file has are active
  Solids solids;                         ///< the same; rows in the order of their particles
  std::vector<std::uint32_t> bondCount;  ///< of each solid
  std::vector<BondRecord> bonds;         ///< one solid's behind another's, in their order
  Surfels surfels;                       ///< as particles: surfels [r S/P, (r+1) S/P)
  Oriented oriented;                     ///< the same; unsorted
  Sheets sheets;
  KindRows& kind(std::size_t k) { return k == orientedKind ? static_cast<KindRows&>(oriented) : sheets; }
  const KindRows& kind(std::size_t k) const {
    return k == orientedKind ? static_cast<const KindRows&>(oriented) : sheets;
  }
  std::vector<std::string> warnings;  ///< about newer files that could not be used
};

/// Writes the owned particles, solids and bonds, the clock, and the sums over ranks of ledger and counters
/// into the older of the two files; synced to the disk, read back and compared before it takes its name.
/// Returns its path. On failure the same IoError on all ranks, and the checkpoints that were there are still
/// there. Needs Continuum::slot to be right. Collective.
std::string writeCheckpoint(const std::string& out, MPI_Comm comm, const World& world, const RunStamp& stamp,
                            const CheckpointValues& values = {});

std::string writeCheckpoint(const std::string& out, MPI_Comm comm, const GoodState& kept,
                            const RunStamp& stamp, const CheckpointValues& values = {});

/// Writes the good state that a checkpoint between two good states goes back to,
/// OUT/checkpoint/good_<step>.hdf, in the same format. Before that checkpoint, so that this never names a
/// file that is not there.
std::string writeGoodState(const std::string& out, MPI_Comm comm, const GoodState& kept,
                           const RunStamp& stamp, const CheckpointValues& values = {});
std::string goodStatePath(const std::string& out, std::int64_t step);

/// Removes good states that neither checkpoint of a run's folder goes back to. One process only.
void dropUnusedGoodStates(const std::string& out);

/// Reads a checkpoint, each rank its share, and compares checksums. IoError (the same on all ranks) if it is
/// damaged. Collective.
std::unique_ptr<CheckpointSlice> readCheckpoint(const std::string& path, MPI_Comm comm);

/// The newest of OUT/checkpoint that can be read; a newer one that is damaged becomes a warning. nullptr if
/// there is none at all; IoError if there are some, but none that can be read. Collective.
std::unique_ptr<CheckpointSlice> readNewestCheckpoint(const std::string& out, MPI_Comm comm);

/// Takes over a checkpoint into a world whose fields are active (modules of the scene): particles (rows in
/// the file's order, unsorted, no slots), clock (end and every stay those of the scene), counters and ledger
/// (on the first rank; zero on others, so that sums stay right). Returns records of the solids for
/// MpiBondHalo::adopt; surfels are unsorted, for resumeSurface (core/surface/resume_surface.hpp). Sort, adopt
/// and relink before particles migrate, so that bonds go with them. IoError if the file lacks a field that
/// the scene needs. Not collective; fails on all ranks alike.
std::vector<std::byte> restoreWorld(World& world, const CheckpointSlice& slice, bool firstRank);

/// Of one file, by this process alone.
CheckpointHeader readCheckpointHeader(const std::string& path);

/// Checkpoints of a run's folder whose header can be read, newest first; damaged ones are described in
/// `problems`.
std::vector<CheckpointHeader> findCheckpoints(const std::string& out,
                                              std::vector<std::string>* problems = nullptr);

bool isCheckpoint(const H5File& file);

}  // namespace thaw
