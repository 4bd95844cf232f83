// SPDX-License-Identifier: Apache-2.0
// Frames and their series: every field of every particle, written on several ranks; full disks, missing
// folders.
#include <algorithm>
#include <array>
#include <set>

#include "core/solid/laws/plasticity.hpp"
#include "io/frames/frame_fields.hpp"
#include "io/frames/series.hpp"
#include "io/hdf5/collective_error.hpp"
#include "io/hdf5/parallel_file.hpp"
#include "io/run/earlier_run.hpp"
#include "tests/support/output_files.hpp"

using namespace thaw;
using namespace thaw::test;
namespace fs = std::filesystem;

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
      EXPECT_EQ(d.find("plastic_strain")->value(i, 1),
                solidAt(id) ? static_cast<float>(plasticStrain(plasticInverseOf(id), {}).yy) : 0.0f);
      EXPECT_EQ(d.find("strain")->value(i, 0), 0);
    }
    EXPECT_EQ(ids.size(), N);
    EXPECT_EQ(d.find("stress")->unit, "Pa");
    EXPECT_EQ(d.find("neighbours")->element, Element::U16);
    if (rankOf() == 0) {
      const H5File file = H5File::openToRead(path);
      const auto offsets = readRows<std::int64_t>(file, "/VTKHDF/Offsets", Element::I64),
                 connectivity = readRows<std::int64_t>(file, "/VTKHDF/Connectivity", Element::I64),
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

TEST(Frame, HasWideConnectivityBeyond31Bits) {
  const Folder folder;
  const std::size_t N = 200;
  Sample sample(MPI_COMM_WORLD, N);
  const std::string narrow = folder.path + "/narrow.hdf", wide = folder.path + "/wide.hdf",
                    edge = folder.path + "/edge.hdf";
  const Frame frame = frameOf(sample.w, rankOf());
  writeFrame(narrow, MPI_COMM_WORLD, frame, stamp, N + 1);
  writeFrame(edge, MPI_COMM_WORLD, frame, stamp, N);
  writeFrame(wide, MPI_COMM_WORLD, frame, stamp, 1);  // as for two billion
  const FrameData a = readFrame(narrow), b = readFrame(wide);
  ASSERT_EQ(a.positions.size(), b.positions.size());
  for (std::size_t i = 0; i < a.positions.size(); i++) EXPECT_EQ(a.positions[i].y, b.positions[i].y);
  if (rankOf() != 0) return;
  const H5File n = H5File::openToRead(narrow), w = H5File::openToRead(wide);
  for (const char* name : {"/VTKHDF/Connectivity", "/VTKHDF/Offsets"}) {
    EXPECT_EQ(n.shape(name).element, Element::I32);
    EXPECT_EQ(w.shape(name).element, Element::I64);
    EXPECT_EQ(H5File::openToRead(edge).shape(name).element, Element::I64)
        << "2^31 - 1 rows have 2^31 offsets";
    EXPECT_EQ(readRows<std::int64_t>(n, name, Element::I64), readRows<std::int64_t>(w, name, Element::I64));
  }
}

TEST(Frame, IsWrittenWithoutParticles) {
  const Folder folder;
  Sample sample(MPI_COMM_WORLD, 0);
  writeFrame(folder.path + "/f.hdf", MPI_COMM_WORLD, frameOf(sample.w, rankOf()), stamp);
  EXPECT_EQ(readFrame(folder.path + "/f.hdf").positions.size(), 0u);
}

TEST(Frame, FieldsOfAbsentModulesHaveTheirMeaning) {
  World w;
  w.scene.materials.resize(1);
  w.scene.materials[0].density = 900;
  w.scene.materials[0].liquidAtStart = true;
  w.scene.bodies.resize(1);
  w.scene.bodies[0].temperature = 333;
  w.scene.output.fields = knownFrameFields();
  Continuum& p = w.particles;
  for (AnyColumn* c : {static_cast<AnyColumn*>(&p.id), static_cast<AnyColumn*>(&p.position),
                       static_cast<AnyColumn*>(&p.velocity), static_cast<AnyColumn*>(&p.material),
                       static_cast<AnyColumn*>(&p.body)})
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

/// Pictures need the volumes of shrinking particles.
TEST(Frame, HasVolumesIfLiquidsEvaporate) {
  const Folder folder;
  Sample sample(MPI_COMM_WORLD, 20);
  for (std::size_t i = 0; i < sample.w.particles.owned; i++)
    sample.w.particles.mass[i] = 2, sample.w.particles.restDensity[i] = 800;
  sample.w.scene.output.fields = {"velocity"};
  for (const bool evaporates : {false, true}) {
    sample.w.modules.evaporation = evaporates;
    const std::string path = folder.path + "/f.hdf";
    writeFrame(path, MPI_COMM_WORLD, frameOf(sample.w, rankOf()), stamp);
    const FrameData d = readFrame(path);
    const FrameColumn* volume = d.find("volume");
    ASSERT_EQ(volume != nullptr, evaporates);
    for (std::size_t i = 0; volume && i < d.positions.size(); i++) EXPECT_EQ(volume->value(i), 0.0025f);
    MPI_Barrier(MPI_COMM_WORLD);
  }
}

TEST(Frame, FullDiskIsAnErrorOnAllRanksAndKeepsTheOldFile) {
  const Folder folder;
  const std::string path = folder.path + "/f.hdf";
  Sample small(MPI_COMM_WORLD, 20), large(MPI_COMM_WORLD, 4000);
  writeFrame(path, MPI_COMM_WORLD, frameOf(small.w, rankOf()), stamp);
  const std::string before = bytesOfFile(path);
  for (int full : {0, sizeOf() - 1, -1}) {  // the disk of the first rank, of the last one, of all
    MPI_Barrier(MPI_COMM_WORLD);
    struct rlimit old {
    }, tight{};
    getrlimit(RLIMIT_FSIZE, &old);
    tight = old;
    tight.rlim_cur = 40000;
    if (full < 0 || full == rankOf()) setrlimit(RLIMIT_FSIZE, &tight);
    const Frame frame = frameOf(large.w, rankOf());
    const std::string error = sameError([&] { writeFrame(path, MPI_COMM_WORLD, frame, stamp); });
    setrlimit(RLIMIT_FSIZE, &old);
    const bool wrote = full > 0 && large.w.particles.owned == 0;  // a rank without particles writes nothing
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
  // as in the writer: free space can change between two ranks' checks
  EXPECT_EQ(sameError([&] {
              onFirstRank(MPI_COMM_WORLD, [&] { requireFreeSpace(path, std::uint64_t(1) << 60); });
            }).find(path + ": not enough space on the disk: "),
            0u);
}

TEST(Frame, MissingFolderIsAnErrorOnAllRanks) {
  Sample small(MPI_COMM_WORLD, 20);
  const std::string error = sameError([&] {
    writeFrame("/tmp/thaw_there_is_no_such_folder/f.hdf", MPI_COMM_WORLD, frameOf(small.w, rankOf()), stamp);
  });
  EXPECT_NE(error.find("No such file or directory"), std::string::npos) << error;
}

TEST(Series, IsRebuiltFromTheExistingFrames) {
  const Folder folder;
  if (rankOf() == 0) makeOutputFolders(folder.path);
  MPI_Barrier(MPI_COMM_WORLD);
  Sample sample(MPI_COMM_WORLD, 30);
  for (int k = 0; k < 4; k++) {
    sample.w.clock.time = 0.04 * k;
    writeFrame(frameFolder(folder.path) + "/" + frameName("wax", k), MPI_COMM_WORLD,
               frameOf(sample.w, rankOf()), stamp);
  }
  if (rankOf() == 0) {
    std::ofstream(frameFolder(folder.path) + "/wax_000004.hdf") << "damaged";
    std::ofstream(frameFolder(folder.path) + "/wax_000005.hdf.part") << "half";
    std::ofstream(frameFolder(folder.path) + "/waxwork_000001.hdf") << "another file";
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
    for (const bool run : {true, false}) {  // the second time the folder is absent
      EXPECT_EQ(moveEarlierRunAside(folder.path), run);
      EXPECT_FALSE(fs::exists(index));
      EXPECT_TRUE(fs::exists(folder.path + "/previous/frames/wax_000000.hdf"));
    }
  }
}
