// SPDX-License-Identifier: Apache-2.0
// thaw compare and thaw info on files written on several ranks; damaged files.
#include <gtest/gtest.h>

#include <bit>
#include <csignal>
#include <cstring>
#include <fstream>

#include "io/checkpoint/checkpoint.hpp"
#include "io/commands/compare_command.hpp"
#include "io/commands/info_command.hpp"
#include "io/compare/compare.hpp"
#include "io/frames/series.hpp"
#include "io/hdf5/parallel_file.hpp"
#include "tests/support/output_sample.hpp"

using namespace thaw;
using namespace thaw::test;
namespace fs = std::filesystem;

namespace {

const bool romio = (useRomio(), true);  // before MPI_Init in main
const RunStamp stamp{"wax", "title = \"wax\"\n", false};
constexpr std::uint64_t N = 200;

/// Writes two run folders, A on one rank and B on all ranks after `change`, and compares them on rank 0.
template<class Change, class Check>
void compareChanged(Change&& change, Check&& check, double tolerance = -1) {
  const Folder folder;
  const std::string a = folder.path + "/a", b = folder.path + "/b";
  if (rankOf() == 0) {
    makeOutputFolders(a);
    makeOutputFolders(b);
    writeCheckpoint(a, MPI_COMM_SELF, Sample(MPI_COMM_SELF, N).w, stamp);
  }
  MPI_Barrier(MPI_COMM_WORLD);
  Sample sample(MPI_COMM_WORLD, N);
  change(sample.w);
  writeCheckpoint(b, MPI_COMM_WORLD, sample.w, stamp);
  if (rankOf() != 0) return;
  const Comparison c = compareSnapshots(openSnapshot(a), openSnapshot(b), {tolerance});
  check(c);
  EXPECT_EQ(compareCommand({a, b, tolerance}), c.equal() ? 0 : 1);
  EXPECT_EQ(compareSnapshots(openSnapshot(b), openSnapshot(a), {tolerance}).equal(), c.equal());
}

/// Row of the particle with this id on this rank, or -1.
std::ptrdiff_t rowOf(const World& w, std::uint64_t id) {
  for (std::size_t i = 0; i < w.particles.owned; i++)
    if (w.particles.id[i] == id) return static_cast<std::ptrdiff_t>(i);
  return -1;
}

double nextUp(double x) { return std::bit_cast<double>(std::bit_cast<std::uint64_t>(x) + 1); }

bool mentions(const std::vector<std::string>& lines, const std::string& text) {
  return std::any_of(lines.begin(), lines.end(),
                     [&](const std::string& l) { return l.find(text) != std::string::npos; });
}

}  // namespace

TEST(Compare, DoesNotDependOnTheNumberOfWriters) {
  compareChanged([](World&) {},
                 [](const Comparison& c) {
                   EXPECT_TRUE(c.equal()) << describe(c)[1];
                   EXPECT_EQ(c.rows, N);
                   EXPECT_GT(c.columns, 20u);
                 });
}

TEST(Compare, OneBitOfOneParticleIsADifference) {
  const auto change = [](World& w) {
    for (std::uint64_t id : {77u, 150u})
      if (const std::ptrdiff_t i = rowOf(w, id); i >= 0)
        w.particles.position[static_cast<std::size_t>(i)].z = nextUp(
            w.particles.position[static_cast<std::size_t>(i)].z);
  };
  compareChanged(change, [](const Comparison& c) {
    ASSERT_EQ(c.fields.size(), 1u);
    EXPECT_TRUE(c.general.empty());
    EXPECT_EQ(c.fields[0].field, "position");
    EXPECT_EQ(c.fields[0].rows, 2u);
    EXPECT_EQ(c.fields[0].firstId, 77u);
    EXPECT_GT(c.fields[0].largest, 0);
    EXPECT_LT(c.fields[0].largest, 1e-15);
    EXPECT_NE(c.fields[0].first.find("position component 2 of id 77: A "), std::string::npos)
        << c.fields[0].first;
    EXPECT_NE(c.fields[0].first.find("0x"), std::string::npos);
  });
  compareChanged(
      change, [](const Comparison& c) { EXPECT_TRUE(c.equal()); }, 1e-12);
}

TEST(Compare, ASignOfZeroAndANaNAreDifferences) {
  for (double value : {-0.0, std::nan("")}) {
    const auto change = [&](World& w) {
      if (const std::ptrdiff_t i = rowOf(w, 5); i >= 0)
        w.particles.velocity[static_cast<std::size_t>(i)].x = value;
    };
    compareChanged(change, [](const Comparison& c) { EXPECT_EQ(c.fields.size(), 1u); });
  }
  compareChanged(
      [](World& w) {
        if (const auto i = rowOf(w, 5); i >= 0)
          w.particles.velocity[static_cast<std::size_t>(i)].x = std::nan("");
      },
      [](const Comparison& c) { EXPECT_FALSE(c.equal()); }, 1e300);
}

TEST(Compare, IntegersHaveNoTolerance) {
  compareChanged(
      [](World& w) {
        if (const auto i = rowOf(w, 9); i >= 0) w.particles.phase[static_cast<std::size_t>(i)] ^= 1;
      },
      [](const Comparison& c) {
        ASSERT_EQ(c.fields.size(), 1u);
        EXPECT_EQ(c.fields[0].field, "phase");
      },
      1e9);
}

TEST(Compare, AMissingParticleIsReportedWithItsId) {
  compareChanged(
      [](World& w) {
        // particle 42 is liquid and has no solid data
        if (const std::ptrdiff_t i = rowOf(w, 42); i >= 0) w.particles.id[static_cast<std::size_t>(i)] = 4242;
      },
      [](const Comparison& c) {
        EXPECT_TRUE(mentions(c.general, "1 ids are in A only, the first 42")) << describe(c)[1];
        EXPECT_TRUE(mentions(c.general, "1 ids are in B only, the first 4242"));
        EXPECT_TRUE(c.fields.empty());
      });
}

TEST(Compare, ABondIsPartOfTheState) {
  compareChanged(
      [](World& w) {  // id 100 loses a bond; the first bond of id 101 gets another weight
        for (std::size_t s = 0; s < w.solids.owned; s++)
          for (int k = 0; k < w.bonds.capacity; k++) {
            if (!w.bonds.hasBond(s, k)) continue;
            const std::size_t at = w.bonds.at(s, k);
            if (w.solids.id[s] == 100) w.bonds.cut(s, k);
            if (w.solids.id[s] == 101) w.bonds.weight.set(at, nextUp(w.bonds.weight[at]));
            break;
          }
      },
      [](const Comparison& c) {
        ASSERT_EQ(c.fields.size(), 2u);
        EXPECT_EQ(c.fields[0].field, "number of bonds");
        EXPECT_EQ(c.fields[0].firstId, 100u);
        EXPECT_EQ(c.fields[1].field, "bond weight");
        EXPECT_EQ(c.fields[1].firstId, 101u);
        EXPECT_EQ(c.fields[1].rows, 1u);
      });
}

TEST(Compare, TimeCountersAndLedgerCount) {
  compareChanged(
      [](World& w) {
        w.clock.time = nextUp(w.clock.time);
        w.clock.step++;
        if (rankOf() == sizeOf() - 1) {
          w.counters.frozen++;
          w.ledger.heatIn.add(1e-300);  // far below the last digit of its value
        }
      },
      [](const Comparison& c) {
        EXPECT_TRUE(mentions(c.general, "time: A 0.3000000000000000"));
        EXPECT_TRUE(mentions(c.general, "step: A 123, B 124"));
        EXPECT_TRUE(mentions(c.general, "counter frozen: A 0, B 1"));
        EXPECT_TRUE(mentions(c.general, "the exact sums differ"));
        EXPECT_TRUE(c.fields.empty());
      });
}

TEST(Compare, FieldsInOneFileOnly) {
  const Folder folder;
  Sample sample(MPI_COMM_WORLD, N);
  const auto write = [&](const std::string& name, const std::vector<std::string>& fields) {
    sample.w.scene.output.fields = fields;
    writeFrame(folder.path + "/" + name, MPI_COMM_WORLD, frameOf(sample.w, rankOf()), stamp);
  };
  write("a.hdf", {"velocity", "rank"});
  write("b.hdf", {"velocity", "temperature"});
  if (rankOf() != 0) return;
  const Comparison c = compareSnapshots(openSnapshot(folder.path + "/a.hdf"),
                                        openSnapshot(folder.path + "/b.hdf"), {});
  ASSERT_EQ(c.general.size(), 1u);  // the field `rank` is not compared
  EXPECT_EQ(c.general[0], "particles: field temperature is in B only");
  EXPECT_TRUE(c.fields.empty());
}

TEST(Compare, UnreadableFilesGiveExitCode3) {
  const Folder folder;
  Sample sample(MPI_COMM_WORLD, N);
  const std::string frame = folder.path + "/f.hdf", bad = folder.path + "/bad.hdf";
  writeFrame(frame, MPI_COMM_WORLD, frameOf(sample.w, rankOf()), stamp);
  if (rankOf() != 0) return;
  std::ofstream(bad) << "not HDF5";
  std::ofstream(folder.path + "/empty.hdf") << "";
  for (const std::string& b : {bad, folder.path + "/empty.hdf", folder.path + "/none.hdf", folder.path}) {
    EXPECT_EQ(compareCommand({frame, b, -1}), 3) << b;
    if (b != folder.path) { EXPECT_EQ(infoCommand({b, true}), 3) << b; }
  }
  EXPECT_EQ(infoCommand({folder.path, false}), 3);
  EXPECT_EQ(infoCommand({frame, false}), 0);
}

TEST(Compare, TruncatedAndDamagedFilesAreErrorsNotCrashes) {
  const Folder folder;
  if (rankOf() != 0) return;
  makeOutputFolders(folder.path);
  Sample sample(MPI_COMM_SELF, 60);
  const std::string frame = folder.path + "/f.hdf", bad = folder.path + "/bad.hdf";
  writeFrame(frame, MPI_COMM_SELF, frameOf(sample.w, 0), stamp);
  const std::string checkpoint = writeCheckpoint(folder.path, MPI_COMM_SELF, sample.w, stamp);
  int errors = 0, read = 0;
  for (const std::string& good : {frame, checkpoint}) {
    std::ifstream in(good, std::ios::binary);
    const std::string whole{std::istreambuf_iterator<char>(in), {}};
    const auto attempt = [&](const std::string& bytes) {
      std::ofstream(bad, std::ios::binary) << bytes;
      try {
        compareSnapshots(openSnapshot(good), openSnapshot(bad), {});
        describePath(bad);
        read++;
      } catch (const IoError& e) {
        errors++;
        EXPECT_NE(std::string(e.what()).find("bad.hdf"), std::string::npos) << e.what();
      }
    };
    for (std::size_t n = 1; n < 40; n++) attempt(whole.substr(0, whole.size() * n / 40));
    EXPECT_GT(errors, 0);
    EXPECT_EQ(read, 0);                       // every truncated file is refused
    for (std::uint64_t n = 0; n < 60; n++) {  // bytes of the first part, where HDF5 stores its metadata
      std::string bytes = whole;
      bytes[static_cast<std::size_t>((hashed(n) + 0.5) * 4096)] ^= static_cast<char>(1u << (n % 8));
      attempt(bytes);
    }
    read = 0;
  }
}

TEST(Compare, DamagedRowsAreNamed) {
  const Folder folder;
  if (rankOf() != 0) return;
  makeOutputFolders(folder.path);
  Sample sample(MPI_COMM_SELF, 60);
  const std::string good = writeCheckpoint(folder.path, MPI_COMM_SELF, sample.w, stamp),
                    bad = folder.path + "/bad.hdf";
  fs::copy_file(good, bad);
  const std::uint64_t place = H5File::openToRead(bad).offset("/particles/velocity") + 100;
  std::fstream file(bad, std::ios::binary | std::ios::in | std::ios::out);
  file.seekg(static_cast<std::streamoff>(place));
  const int byte = file.get();
  file.seekp(static_cast<std::streamoff>(place));
  file.put(static_cast<char>(byte ^ 1));
  file.close();
  EXPECT_EQ(compareCommand({good, bad, -1}), 3);
  EXPECT_EQ(compareCommand({bad, good, -1}), 3);
  EXPECT_EQ(infoCommand({good, true}), 0);
  EXPECT_EQ(infoCommand({bad, true}), 3);
  EXPECT_EQ(describePath(bad)["damaged"].dump(), "[\"/particles/velocity\"]");
}

TEST(Info, ListsContentsAlsoAsJson) {
  const Folder folder;
  if (rankOf() == 0) makeOutputFolders(folder.path);
  MPI_Barrier(MPI_COMM_WORLD);
  Sample sample(MPI_COMM_WORLD, N);
  writeCheckpoint(folder.path, MPI_COMM_WORLD, sample.w, stamp);
  const std::string frame = frameFolder(folder.path) + "/" + frameName("wax", 3);
  writeFrame(frame, MPI_COMM_WORLD, frameOf(sample.w, rankOf()), stamp);
  if (rankOf() != 0) return;
  writeSeries(seriesPath(folder.path, "wax"), {{frameName("wax", 3), 0.3}});
  const auto run = describePath(folder.path);
  EXPECT_EQ(run["kind"], "run");
  EXPECT_EQ(run["step"], 123);
  EXPECT_EQ(run["series"][0]["frames"], 1);
  EXPECT_EQ(run["checkpoints"][0]["particles"], N);
  const auto f = describePath(frame);
  EXPECT_EQ(f["kind"], "frame");
  EXPECT_EQ(f["ranks"], sizeOf());
  bool found = false;
  for (const auto& field : f["fields"])
    if (field["name"] == "stress") {
      found = true;
      EXPECT_EQ(field["unit"], "Pa");
      EXPECT_EQ(field["components"], 6);
    }
  EXPECT_TRUE(found);
  EXPECT_EQ(infoCommand({folder.path, true}), 0);
}
