// SPDX-License-Identifier: Apache-2.0
// Checkpoints written on some ranks and read on others; full disks, damaged files, other scenes.
#include <cstring>
#include <map>

#include "core/simulation/ledger/totals.hpp"
#include "io/checkpoint/checkpoint.hpp"
#include "io/frames/series.hpp"
#include "parallel/communicator.hpp"
#include "tests/support/output_files.hpp"

using namespace thaw;
using namespace thaw::test;
namespace fs = std::filesystem;

namespace {

/// Content of a checkpoint by id: state bytes, and a solid's state with its bonds.
struct Content {
  std::map<std::uint64_t, std::string> particles, solids;
};

void addRows(std::map<std::uint64_t, std::string>& to, const Table& table, std::size_t row,
             std::uint64_t id) {
  std::string bytes(table.stateBytes(), '\0');
  table.packState(row, reinterpret_cast<std::byte*>(bytes.data()));
  to[id] = bytes;
}

constexpr std::uint64_t sampleParticles = 300;

/// Writes the sample from the first ranks.
void writeSample(const std::string& out, int writers, bool twoFrames) {
  if (rankOf() == 0) makeOutputFolders(out);
  MPI_Barrier(MPI_COMM_WORLD);
  const Some some(writers);
  if (some.in()) {
    const Sample sample(some.comm, sampleParticles, twoFrames);
    EXPECT_EQ(writeCheckpoint(out, some.comm, sample.w, stamp, {{"fall height", "1.25"}}),
              out + "/checkpoint/a.hdf");
  }
  MPI_Barrier(MPI_COMM_WORLD);
}

void expectHeader(const CheckpointHeader& h, int writers) {
  EXPECT_EQ(h.particles, sampleParticles);
  EXPECT_EQ(h.clock.time, 0.1 + 0.2);
  EXPECT_EQ(h.clock.dt, 1e-5 / 3);
  EXPECT_EQ(h.limitedBy, "sound");
  EXPECT_EQ(h.values.at("fall height"), "1.25");
  EXPECT_EQ(h.sceneText, stamp.sceneText);
  EXPECT_EQ(h.ranks, writers);
}

void expectEvenShares(const CheckpointSlice& slice) {
  const auto ranks = static_cast<std::uint64_t>(sizeOf());
  EXPECT_LE(slice.particles.owned, (sampleParticles + ranks - 1) / ranks);
  std::int64_t found[2] = {static_cast<std::int64_t>(slice.particles.owned),
                           static_cast<std::int64_t>(slice.bonds.size())};
  MPI_Allreduce(MPI_IN_PLACE, found, 2, MPI_INT64_T, MPI_SUM, MPI_COMM_WORLD);
  EXPECT_EQ(found[0], static_cast<std::int64_t>(sampleParticles));
  EXPECT_EQ(found[1], static_cast<std::int64_t>(slice.header.bonds));
}

/// Returns the content of the complete sample.
Content contentOf(const World& whole) {
  Content all;
  for (std::size_t i = 0; i < whole.particles.owned; i++) {
    addRows(all.particles, whole.particles, i, whole.particles.id[i]);
    if (const std::uint32_t solidIndex = whole.particles.solidIndex[i]; solidIndex != noSolid) {
      SolidRecords r;
      appendRecord(whole.solids, whole.bonds, solidIndex, r);
      all.solids[whole.solids.id[solidIndex]] = {reinterpret_cast<const char*>(r.bytes.data()),
                                                 r.bytes.size()};
    }
  }
  return all;
}

/// A world with all columns, ready to be restored.
void prepareToRestore(World& w, bool twoFrames) {
  for (AnyColumn* c : w.particles.columns) w.particles.activate(*c);
  for (AnyColumn* c : w.solids.columns) w.solids.activate(*c);
  w.bonds.choose(twoFrames, twoFrames, false);
  w.clock.every = 0.04;
  w.clock.end = 9;
}

void expectContent(const World& restored, const std::vector<std::byte>& records, const Content& expected) {
  Content got;
  for (std::size_t i = 0; i < restored.particles.owned; i++) {
    addRows(got.particles, restored.particles, i, restored.particles.id[i]);
    EXPECT_EQ(restored.particles.solidIndex[i], noSolid);
  }
  for (const auto& [id, bytes] : got.particles) EXPECT_EQ(bytes, expected.particles.at(id)) << id;
  for (std::size_t at = 0; at < records.size();) {
    SolidRecordView view;
    const std::size_t next = readRecord(restored.solids, records, at, view);
    EXPECT_TRUE(got.particles.count(view.id)) << "a solid is read by the rank that reads its particle";
    EXPECT_EQ(std::string(reinterpret_cast<const char*>(records.data() + at), next - at),
              expected.solids.at(view.id))
        << view.id;
    at = next;
  }
}

void expectTotals(const World& restored, const Ledger& expected) {
  const Communicator comm;
  MpiReducer all(comm);
  Ledger ledger = globalLedger(restored.ledger, all), ledgerExpected = expected;
  EXPECT_EQ(ledger.heatIn.value(), ledgerExpected.heatIn.value());
  EXPECT_EQ(ledger.left.momentum[1].value(), ledgerExpected.left.momentum[1].value());
  EXPECT_EQ(ledger.initial.mass, 42.5);
  EXPECT_EQ(globalCounters(restored.counters, all).melted,
            static_cast<std::int64_t>(sampleParticles * (sampleParticles - 1) / 2));
}

}  // namespace

TEST(Checkpoint, IsReadOnAnyNumberOfRanks) {
  for (const bool twoFrames : {true, false})
    for (int writers : {1, sizeOf()}) {
      const Folder folder;
      writeSample(folder.path, writers, twoFrames);
      const auto slice = readNewestCheckpoint(folder.path, MPI_COMM_WORLD);
      ASSERT_NE(slice, nullptr);
      expectHeader(slice->header, writers);
      expectEvenShares(*slice);
      const Sample whole(MPI_COMM_SELF, sampleParticles, twoFrames);
      World restored;
      prepareToRestore(restored, twoFrames);
      const std::vector<std::byte> records = restoreWorld(restored, *slice, rankOf() == 0);
      expectContent(restored, records, contentOf(whole.w));
      EXPECT_EQ(restored.clock.frame, 7);
      EXPECT_EQ(restored.clock.end, 9);
      expectTotals(restored, whole.w.ledger);
    }
}

TEST(Checkpoint, AlternatesBetweenTwoFilesAndFallsBackToTheIntactOne) {
  const Folder folder;
  if (rankOf() == 0) makeOutputFolders(folder.path);
  MPI_Barrier(MPI_COMM_WORLD);
  EXPECT_EQ(readNewestCheckpoint(folder.path, MPI_COMM_WORLD), nullptr);
  Sample sample(MPI_COMM_WORLD, 200);
  const std::string a = folder.path + "/checkpoint/a.hdf", b = folder.path + "/checkpoint/b.hdf";
  for (const std::string& expected : {a, b, a, b}) {
    sample.w.clock.step++;
    EXPECT_EQ(writeCheckpoint(folder.path, MPI_COMM_WORLD, sample.w, stamp), expected);
  }
  EXPECT_EQ(readNewestCheckpoint(folder.path, MPI_COMM_WORLD)->header.clock.step, 127);
  // the partial file of a killed run does not count
  if (rankOf() == 0) std::ofstream(a + ".part") << "half";
  const std::string whole = bytesOfFile(b);
  const auto damage = [&](const std::string& bytes) {
    MPI_Barrier(MPI_COMM_WORLD);
    if (rankOf() == 0) std::ofstream(b, std::ios::binary) << bytes;
    MPI_Barrier(MPI_COMM_WORLD);
  };
  std::string flipped = whole;
  const double y = sample.w.particles.owned > 0 ? sample.w.particles.position[0].y : 0;
  double first = y;
  MPI_Bcast(&first, 1, MPI_DOUBLE, 0, MPI_COMM_WORLD);
  char pattern[8];
  std::memcpy(pattern, &first, 8);
  const std::size_t at = whole.find(std::string(pattern, 8));
  ASSERT_NE(at, std::string::npos);
  flipped[at] = static_cast<char>(flipped[at] ^ 1);  // one bit of one position
  for (const std::string& bytes : {flipped, whole.substr(0, whole.size() / 2), whole.substr(0, 100),
                                   std::string(), std::string(5000, 'x')}) {
    damage(bytes);
    const auto slice = readNewestCheckpoint(folder.path, MPI_COMM_WORLD);
    ASSERT_NE(slice, nullptr);
    EXPECT_EQ(slice->header.clock.step, 126);
    if (rankOf() == 0) {
      ASSERT_EQ(slice->warnings.size(), 1u);
      EXPECT_NE(slice->warnings[0].find("b.hdf"), std::string::npos);
    }
  }
  // the damaged file is replaced next
  sample.w.clock.step = 500;
  EXPECT_EQ(writeCheckpoint(folder.path, MPI_COMM_WORLD, sample.w, stamp), b);
  EXPECT_EQ(readNewestCheckpoint(folder.path, MPI_COMM_WORLD)->header.clock.step, 500);
  damage("x");
  MPI_Barrier(MPI_COMM_WORLD);
  if (rankOf() == 0) fs::resize_file(a, 3000);
  MPI_Barrier(MPI_COMM_WORLD);
  const std::string error = sameError([&] { readNewestCheckpoint(folder.path, MPI_COMM_WORLD); });
  EXPECT_EQ(error.find("no checkpoint can be read: "), 0u) << error;
}

TEST(Checkpoint, FullDiskKeepsTheOldOnes) {
  const Folder folder;
  if (rankOf() == 0) makeOutputFolders(folder.path);
  MPI_Barrier(MPI_COMM_WORLD);
  Sample sample(MPI_COMM_WORLD, 300);
  writeCheckpoint(folder.path, MPI_COMM_WORLD, sample.w, stamp);
  sample.w.clock.step++;
  writeCheckpoint(folder.path, MPI_COMM_WORLD, sample.w, stamp);
  struct rlimit old {
  }, tight{};
  getrlimit(RLIMIT_FSIZE, &old);
  tight = old;
  tight.rlim_cur = 30000;
  setrlimit(RLIMIT_FSIZE, &tight);
  sample.w.clock.step++;
  const std::string error = sameError([&] { writeCheckpoint(folder.path, MPI_COMM_WORLD, sample.w, stamp); });
  setrlimit(RLIMIT_FSIZE, &old);
  EXPECT_NE(error, "");
  EXPECT_EQ(readNewestCheckpoint(folder.path, MPI_COMM_WORLD)->header.clock.step, 124);
}

TEST(Checkpoint, RefusesAnotherScene) {
  const Folder folder;
  if (rankOf() == 0) makeOutputFolders(folder.path);
  MPI_Barrier(MPI_COMM_WORLD);
  World without;
  without.particles.activate(without.particles.id);
  without.particles.activate(without.particles.position);
  writeCheckpoint(folder.path, MPI_COMM_WORLD, without, stamp);
  const auto slice = readNewestCheckpoint(folder.path, MPI_COMM_WORLD);
  EXPECT_EQ(slice->header.particles, 0u);
  World w;
  w.particles.activate(w.particles.temperature);
  const std::string error = sameError([&] { restoreWorld(w, *slice, true); });
  EXPECT_NE(error.find("has no field 'temperature'"), std::string::npos) << error;
}
