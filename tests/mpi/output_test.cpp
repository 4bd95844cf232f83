// Frames and checkpoints: written on some ranks, read on others; full disks, damaged files; comparison.
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <algorithm>
#include <array>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>

#include "core/ledger/totals.hpp"
#include "io/hdf5/agree.hpp"
#include "io/hdf5/parallel_file.hpp"
#include "io/output/checkpoint.hpp"
#include "io/output/frame_fields.hpp"
#include "io/output/earlier_run.hpp"
#include "io/output/series.hpp"
#include "parallel/communicator.hpp"
#include "tests/support/output_sample.hpp"

using namespace thaw;
using namespace thaw::test;
namespace fs = std::filesystem;

namespace {

const bool romio = (useRomio(), std::signal(SIGXFSZ, SIG_IGN), true);  // before MPI_Init, which is in main

std::string bytesOfFile(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// The message of the IoError that work throws; empty if none. The same on all ranks, or the test fails.
std::string sameError(const std::function<void()>& work) {
  std::string message;
  try {
    work();
  } catch (const IoError& e) {
    message = e.what();
  }
  std::uint64_t hash = std::hash<std::string>{}(message), low = hash, high = hash;
  MPI_Allreduce(MPI_IN_PLACE, &low, 1, MPI_UINT64_T, MPI_MIN, MPI_COMM_WORLD);
  MPI_Allreduce(MPI_IN_PLACE, &high, 1, MPI_UINT64_T, MPI_MAX, MPI_COMM_WORLD);
  EXPECT_EQ(low, high) << message;
  return message;
}

const RunStamp stamp{"wax", "title = \"W\u00e4rme\"\n", false};

}  // namespace

TEST(Frame, HasEveryFieldOfEveryParticle) {
  const Folder folder;
  const std::uint64_t N = 500;
  Sample sample(MPI_COMM_WORLD, N);
  for (const bool pieces : {false, true}) {
    RunStamp s = stamp;
    s.piecesByRank = pieces;
    const Frame frame = frameOf(sample.w, rankOf());
    const std::string path = folder.path + "/" + frameName("wax", pieces);
    writeFrame(path, MPI_COMM_WORLD, frame, s);
    EXPECT_TRUE(fs::exists(path));
    EXPECT_FALSE(fs::exists(path + ".part"));
    const FrameData d = readFrame(path);  // on every rank
    EXPECT_EQ(d.time, 0.1 + 0.2);
    EXPECT_EQ(d.step, 123);
    EXPECT_EQ(d.sceneText, stamp.sceneText);
    EXPECT_EQ(d.ranks, sizeOf());
    EXPECT_EQ(d.pieces, pieces ? static_cast<std::uint64_t>(sizeOf()) : 1u);
    ASSERT_EQ(d.positions.size(), N);
    for (const std::string& name : knownFrameFields()) ASSERT_NE(d.find(name), nullptr) << name;
    std::set<std::uint64_t> ids;
    for (std::size_t i = 0; i < N; i++) {
      const auto id = static_cast<std::uint64_t>(d.find("id")->value(i));
      ids.insert(id);
      EXPECT_EQ(d.positions[i].y, static_cast<float>(hashed(id + 1000)));
      EXPECT_EQ(d.find("velocity")->value(i, 2), static_cast<float>(2 * hashed(id + 2000)));
      EXPECT_EQ(d.find("temperature")->value(i), static_cast<float>(300 + hashed(id)));
      EXPECT_EQ(d.find("rank")->value(i), ownerOf(id, sizeOf()));
      EXPECT_EQ(d.find("stress")->value(i, 5), solidAt(id) ? double(id) : 0);
      EXPECT_EQ(d.find("plastic_strain")->value(i, 1), solidAt(id) ? 2 : 0);
      EXPECT_EQ(d.find("strain")->value(i, 0), 0);
    }
    EXPECT_EQ(ids.size(), N);
    EXPECT_EQ(d.find("stress")->unit, "Pa");
    EXPECT_EQ(d.find("neighbours")->element, Element::U16);
    if (rankOf() == 0) {
      const H5File file = H5File::openToRead(path);
      const auto offsets = readRows<std::int64_t>(file, "/VTKHDF/Offsets", Element::I64), connectivity = readRows<std::int64_t>(file, "/VTKHDF/Connectivity", Element::I64),
                 points = readRows<std::int64_t>(file, "/VTKHDF/NumberOfPoints", Element::I64);
      EXPECT_EQ(offsets.size(), N + points.size());
      std::size_t o = 0, c = 0;
      for (std::int64_t n : points) {
        for (std::int64_t k = 0; k < n; k++) EXPECT_EQ(connectivity[c++], k);
        for (std::int64_t k = 0; k <= n; k++) EXPECT_EQ(offsets[o++], k);
      }
    }
  }
}

TEST(Frame, WithoutAnyParticle) {
  const Folder folder;
  Sample sample(MPI_COMM_WORLD, 0);
  writeFrame(folder.path + "/f.hdf", MPI_COMM_WORLD, frameOf(sample.w, rankOf()), stamp);
  EXPECT_EQ(readFrame(folder.path + "/f.hdf").positions.size(), 0u);
}

TEST(Frame, FieldsOfModulesThatAreOffStandForWhatTheyMean) {
  World w;
  w.scene.materials.resize(1);
  w.scene.materials[0].density = 900;
  w.scene.materials[0].liquidAtStart = true;
  w.scene.bodies.resize(1);
  w.scene.bodies[0].temperature = 333;
  w.scene.output.fields = knownFrameFields();
  Continuum& p = w.particles;
  for (AnyColumn* c : {static_cast<AnyColumn*>(&p.id), static_cast<AnyColumn*>(&p.position), static_cast<AnyColumn*>(&p.velocity),
                       static_cast<AnyColumn*>(&p.material), static_cast<AnyColumn*>(&p.body)})
    p.activate(*c);
  p.resize(1, 0);
  const Frame f = frameOf(w, 0);
  const auto first = [&](const std::string& name) {
    for (const FrameField& x : f.fields)
      if (x.name == name) {
        std::array<float, 6> value{};  // a tensor
        x.fill({0, 1}, reinterpret_cast<std::byte*>(value.data()));
        return value[0];
      }
    return -1.0f;
  };
  EXPECT_EQ(first("temperature"), 333);
  EXPECT_EQ(first("liquid"), 1);
  EXPECT_EQ(first("density"), 900);
  EXPECT_EQ(first("stress"), 0);
  w.scene.output.fields = {"colour"};
  EXPECT_THROW(frameOf(w, 0), std::invalid_argument);
}

TEST(Frame, AFullDiskIsAnErrorOfAllRanksAndLeavesTheOldFile) {
  const Folder folder;
  const std::string path = folder.path + "/f.hdf";
  Sample small(MPI_COMM_WORLD, 20), large(MPI_COMM_WORLD, 4000);
  writeFrame(path, MPI_COMM_WORLD, frameOf(small.w, rankOf()), stamp);
  const std::string before = bytesOfFile(path);
  for (int full : {0, sizeOf() - 1, -1}) {  // the first rank's disk, the last one's, everybody's
    MPI_Barrier(MPI_COMM_WORLD);
    struct rlimit old {}, tight {};
    getrlimit(RLIMIT_FSIZE, &old);
    tight = old;
    tight.rlim_cur = 40000;
    if (full < 0 || full == rankOf()) setrlimit(RLIMIT_FSIZE, &tight);
    const Frame frame = frameOf(large.w, rankOf());
    const std::string error = sameError([&] { writeFrame(path, MPI_COMM_WORLD, frame, stamp); });
    setrlimit(RLIMIT_FSIZE, &old);
    const bool wrote = full > 0 && large.w.particles.owned == 0;  // a rank that has nothing to write
    int any = wrote;
    MPI_Allreduce(MPI_IN_PLACE, &any, 1, MPI_INT, MPI_MAX, MPI_COMM_WORLD);
    if (error.empty()) {
      EXPECT_TRUE(full > 0) << full;
      if (rankOf() == 0) writeFrame(path, MPI_COMM_SELF, frameOf(Sample(MPI_COMM_SELF, 20).w, 0), stamp);
      continue;
    }
    EXPECT_NE(error.find("f.hdf"), std::string::npos) << error;
    EXPECT_EQ(bytesOfFile(path).size(), before.size());
    EXPECT_FALSE(fs::exists(path + ".part"));
  }
  // as a writer does: what is free may change between two ranks' looks
  EXPECT_EQ(sameError([&] { onFirstRank(MPI_COMM_WORLD, [&] { requireFreeSpace(path, std::uint64_t(1) << 60); }); }).find(path + ": not enough space on the disk: "), 0u);
}

TEST(Frame, AFolderThatIsNotThereIsAnErrorOfAllRanks) {
  Sample small(MPI_COMM_WORLD, 20);
  const std::string error = sameError([&] { writeFrame("/tmp/thaw_there_is_no_such_folder/f.hdf", MPI_COMM_WORLD, frameOf(small.w, rankOf()), stamp); });
  EXPECT_NE(error.find("No such file or directory"), std::string::npos) << error;
}

namespace {

/// All that a checkpoint says, by id: state bytes, and a solid's state with its bonds.
struct Content {
  std::map<std::uint64_t, std::string> particles, solids;
};

void addRows(std::map<std::uint64_t, std::string>& to, const Table& table, std::size_t row, std::uint64_t id) {
  std::string bytes(table.stateBytes(), '\0');
  table.packState(row, reinterpret_cast<std::byte*>(bytes.data()));
  to[id] = bytes;
}

}  // namespace

TEST(Checkpoint, IsReadOnAnyNumberOfRanks) {
  const std::uint64_t N = 300;
  for (const bool twoFrames : {true, false})
    for (int writers : {1, sizeOf()}) {
      const Folder folder;
      if (rankOf() == 0) makeOutputFolders(folder.path);
      MPI_Barrier(MPI_COMM_WORLD);
      const Some some(writers);
      if (some.in()) {
        const Sample sample(some.comm, N, twoFrames);
        EXPECT_EQ(writeCheckpoint(folder.path, some.comm, sample.w, stamp, {{"fall height", 1.25}}), folder.path + "/checkpoint/a.hdf");
      }
      MPI_Barrier(MPI_COMM_WORLD);
      const auto slice = readNewestCheckpoint(folder.path, MPI_COMM_WORLD);
      ASSERT_NE(slice, nullptr);
      const CheckpointHeader& h = slice->header;
      EXPECT_EQ(h.particles, N);
      EXPECT_EQ(h.clock.time, 0.1 + 0.2);
      EXPECT_EQ(h.clock.dt, 1e-5 / 3);
      EXPECT_EQ(h.limitedBy, "sound");
      EXPECT_EQ(h.values.at("fall height"), 1.25);
      EXPECT_EQ(h.sceneText, stamp.sceneText);
      EXPECT_EQ(h.ranks, writers);
      // even shares
      EXPECT_LE(slice->particles.owned, (N + static_cast<std::uint64_t>(sizeOf()) - 1) / static_cast<std::uint64_t>(sizeOf()));
      std::int64_t found[2] = {static_cast<std::int64_t>(slice->particles.owned), static_cast<std::int64_t>(slice->bonds.size())};
      MPI_Allreduce(MPI_IN_PLACE, found, 2, MPI_INT64_T, MPI_SUM, MPI_COMM_WORLD);
      EXPECT_EQ(found[0], static_cast<std::int64_t>(N));
      EXPECT_EQ(found[1], static_cast<std::int64_t>(h.bonds));

      // the whole of it, made anew on one rank
      Sample whole(MPI_COMM_SELF, N, twoFrames);
      Content expected, got;
      for (std::size_t i = 0; i < N; i++) {
        addRows(expected.particles, whole.w.particles, i, whole.w.particles.id[i]);
        if (const std::uint32_t slot = whole.w.particles.slot[i]; slot != noSlot) {
          SolidRecords r;
          appendRecord(whole.w.solids, whole.w.bonds, slot, r);
          expected.solids[whole.w.solids.id[slot]] = {reinterpret_cast<const char*>(r.bytes.data()), r.bytes.size()};
        }
      }
      World restored;
      for (AnyColumn* c : restored.particles.columns) restored.particles.activate(*c);
      for (AnyColumn* c : restored.solids.columns) restored.solids.activate(*c);
      restored.bonds.choose(twoFrames, twoFrames, false);
      restored.clock.every = 0.04;
      restored.clock.end = 9;
      const std::vector<std::byte> records = restoreWorld(restored, *slice, rankOf() == 0);
      for (std::size_t i = 0; i < restored.particles.owned; i++) {
        addRows(got.particles, restored.particles, i, restored.particles.id[i]);
        EXPECT_EQ(restored.particles.slot[i], noSlot);
      }
      for (const auto& [id, bytes] : got.particles) EXPECT_EQ(bytes, expected.particles.at(id)) << id;
      for (std::size_t at = 0; at < records.size();) {
        SolidRecordView view;
        const std::size_t next = readRecord(restored.solids, records, at, view);
        EXPECT_TRUE(got.particles.count(view.id)) << "a solid is read by the rank that reads its particle";
        EXPECT_EQ(std::string(reinterpret_cast<const char*>(records.data() + at), next - at), expected.solids.at(view.id)) << view.id;
        at = next;
      }
      EXPECT_EQ(restored.clock.frame, 7);
      EXPECT_EQ(restored.clock.end, 9);
      const Communicator comm;
      MpiReducer all(comm);
      Ledger ledger = globalLedger(restored.ledger, all), ledgerExpected = whole.w.ledger;
      EXPECT_EQ(ledger.heatIn.value(), ledgerExpected.heatIn.value());
      EXPECT_EQ(ledger.left.momentum[1].value(), ledgerExpected.left.momentum[1].value());
      EXPECT_EQ(ledger.initial.mass, 42.5);
      EXPECT_EQ(globalCounters(restored.counters, all).melted, static_cast<std::int64_t>(N * (N - 1) / 2));
    }
}

TEST(Checkpoint, AlternatesBetweenTwoFilesAndFallsBackToTheWholeOne) {
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
  // what a killed run leaves does not count
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
  for (const std::string& bytes : {flipped, whole.substr(0, whole.size() / 2), whole.substr(0, 100), std::string(), std::string(5000, 'x')}) {
    damage(bytes);
    const auto slice = readNewestCheckpoint(folder.path, MPI_COMM_WORLD);
    ASSERT_NE(slice, nullptr);
    EXPECT_EQ(slice->header.clock.step, 126);
    if (rankOf() == 0) {
      ASSERT_EQ(slice->warnings.size(), 1u);
      EXPECT_NE(slice->warnings[0].find("b.hdf"), std::string::npos);
    }
  }
  // the damaged one is the next to be replaced
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

TEST(Checkpoint, AFullDiskKeepsTheOldOnes) {
  const Folder folder;
  if (rankOf() == 0) makeOutputFolders(folder.path);
  MPI_Barrier(MPI_COMM_WORLD);
  Sample sample(MPI_COMM_WORLD, 300);
  writeCheckpoint(folder.path, MPI_COMM_WORLD, sample.w, stamp);
  sample.w.clock.step++;
  writeCheckpoint(folder.path, MPI_COMM_WORLD, sample.w, stamp);
  struct rlimit old {}, tight {};
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

TEST(Checkpoint, OfAnotherSceneIsRefused) {
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

TEST(Series, IsMadeAnewFromTheFramesThatAreThere) {
  const Folder folder;
  if (rankOf() == 0) makeOutputFolders(folder.path);
  MPI_Barrier(MPI_COMM_WORLD);
  Sample sample(MPI_COMM_WORLD, 30);
  for (int k = 0; k < 4; k++) {
    sample.w.clock.time = 0.04 * k;
    writeFrame(frameFolder(folder.path) + "/" + frameName("wax", k), MPI_COMM_WORLD, frameOf(sample.w, rankOf()), stamp);
  }
  if (rankOf() == 0) {
    std::ofstream(frameFolder(folder.path) + "/wax_000004.hdf") << "damaged";
    std::ofstream(frameFolder(folder.path) + "/wax_000005.hdf.part") << "half";
    std::ofstream(frameFolder(folder.path) + "/waxwork_000001.hdf") << "of somebody else";
    const auto entries = framesPresent(folder.path, "wax", 0.08);
    ASSERT_EQ(entries.size(), 3u);
    EXPECT_FALSE(fs::exists(frameFolder(folder.path) + "/wax_000005.hdf.part"));
    const std::string index = seriesPath(folder.path, "wax");
    writeSeries(index, entries);
    const auto back = readSeries(index);
    ASSERT_EQ(back.size(), 3u);
    EXPECT_EQ(back[2].name, "wax_000002.hdf");
    EXPECT_EQ(back[2].time, 0.08);
    EXPECT_EQ(findSeries(folder.path), std::vector<std::string>{index});
    for (const bool run : {true, false}) {  // the second time there is none
      EXPECT_EQ(setAsideEarlierRun(folder.path), run);
      EXPECT_FALSE(fs::exists(index));
      EXPECT_TRUE(fs::exists(folder.path + "/previous/frames/wax_000000.hdf"));
    }
  }
}
