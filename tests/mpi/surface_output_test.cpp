// SPDX-License-Identifier: Apache-2.0
// The surface in checkpoints, snapshots and frames, written on some ranks and read on others.
#include <gtest/gtest.h>

#include <cstring>
#include <map>

#include "core/simulation/monitor/snapshot.hpp"
#include "core/simulation/setup/setup.hpp"
#include "io/checkpoint/checkpoint.hpp"
#include "io/compare/compare.hpp"
#include "io/frames/series.hpp"
#include "io/frames/surface_frame.hpp"
#include "tests/support/output_sample.hpp"

using namespace thaw;
using namespace thaw::test;

namespace {

const bool romio = (useRomio(), true);  // before MPI_Init in main
const RunStamp stamp{"wax", "title = \"Wax\"\n", false};

std::uint64_t surfelId(std::uint64_t k) {
  return k % 3 ? 1ull << 63 | k : 0x9e3779b97f4a7c15ull * (k + 1) | 1ull << 63;
}

/// Makes surfels with values that depend on k only, spread over the ranks like the particles.
void addSurface(World& w, MPI_Comm comm, std::uint64_t count) {
  Surface& s = w.surface;
  for (AnyColumn* c : s.surfels.columns)
    if (c->keep == Keep::State) s.surfels.activate(*c);
  std::vector<std::uint64_t> mine;
  for (std::uint64_t k = 0; k < count; k++)
    if (ownerOf(k, sizeOf(comm)) == rankOf(comm)) mine.push_back(k);
  s.surfels.resize(mine.size(), 0);
  for (std::size_t i = 0; i < mine.size(); i++) {
    const std::uint64_t k = mine[i];
    for (AnyColumn* c : s.surfels.columns)
      if (c->keep == Keep::State)
        for (std::size_t b = 0; b < c->elementBytes; b++)
          c->bytes[i * c->elementBytes + b] = std::byte(std::uint8_t(13 * k + 5 * b) & 63);
    s.surfels.id[i] = surfelId(k);
    s.surfels.position[i] = {hashed(k), hashed(k + 500), hashed(k + 900)};
    s.surfels.normal[i] = {0, 0, 1};
    s.surfels.radius[i] = 0.01 + hashed(k) * 0.001;
    s.surfels.colour[i] = 10 | 20 << 8 | static_cast<std::uint32_t>(k % 256) << 16;
    s.surfels.detail[i] = 0.5f;
  }
  s.components = {{1, 10, 20, 1.5, 2.5, 3.5, 4.5, {1, 2, 3}}, {77, 5, 6, 0.1, 0.2, 0.3, 0.4, {-1, -2, -3}}};
  s.events = {{3, 0.1, SurfaceEventKind::Split, 1, 77},
              {9, 0.25, SurfaceEventKind::Merge, 1, 5},
              {9, 0.25, SurfaceEventKind::Renamed, 2, 1}};
  s.counters = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11};
  s.lastStep = 120;
}

/// All surfels of all ranks by id, each as a string of bytes.
std::map<std::uint64_t, std::string> rowsOf(const Surfels& s) {
  std::map<std::uint64_t, std::string> rows;
  for (std::size_t i = 0; i < s.owned; i++) {
    std::string row(s.stateBytes(), 0);
    s.packState(i, reinterpret_cast<std::byte*>(row.data()));
    rows[s.id[i]] = row;
  }
  return rows;
}

void expectSame(const Surface& a, const Surface& b) {
  ASSERT_EQ(a.components.size(), b.components.size());
  for (std::size_t k = 0; k < a.components.size(); k++)
    EXPECT_EQ(std::memcmp(&a.components[k], &b.components[k], sizeof a.components[k]), 0) << k;
  ASSERT_EQ(a.events.size(), b.events.size());
  for (std::size_t k = 0; k < a.events.size(); k++) {
    EXPECT_EQ(a.events[k].step, b.events[k].step);
    EXPECT_EQ(a.events[k].time, b.events[k].time);
    EXPECT_EQ(a.events[k].kind, b.events[k].kind);
    EXPECT_EQ(a.events[k].label, b.events[k].label);
    EXPECT_EQ(a.events[k].other, b.events[k].other);
  }
  EXPECT_EQ(std::memcmp(&a.counters, &b.counters, sizeof a.counters), 0);
  EXPECT_EQ(a.lastStep, b.lastStep);
}

}  // namespace

TEST(SurfaceOutput, CheckpointHoldsTheSurface) {
  const Folder folder;
  if (rankOf() == 0) makeOutputFolders(folder.path);
  MPI_Barrier(MPI_COMM_WORLD);
  const std::uint64_t N = 300, S = 431;
  for (int writers = 1; writers <= sizeOf(); writers += 2) {
    const Some some(writers);
    if (some.in()) {
      Sample sample(some.comm, N);
      addSurface(sample.w, some.comm, S);
      writeCheckpoint(folder.path, some.comm, sample.w, stamp);
    }
    MPI_Barrier(MPI_COMM_WORLD);
    const auto slice = readNewestCheckpoint(folder.path, MPI_COMM_WORLD);
    ASSERT_TRUE(slice);
    EXPECT_EQ(slice->header.surfels, S);
    World whole, w;
    addSurface(whole, MPI_COMM_SELF, S);
    for (AnyColumn* c : w.particles.columns) w.particles.activate(*c);
    for (AnyColumn* c : w.solids.columns) w.solids.activate(*c);
    for (AnyColumn* c : w.surface.surfels.columns) w.surface.surfels.activate(*c);
    restoreWorld(w, *slice, rankOf() == 0);
    expectSame(whole.surface, w.surface);
    std::int64_t owned = static_cast<std::int64_t>(w.surface.surfels.owned);
    MPI_Allreduce(MPI_IN_PLACE, &owned, 1, MPI_INT64_T, MPI_SUM, MPI_COMM_WORLD);
    EXPECT_EQ(owned, static_cast<std::int64_t>(S));
    const auto all = rowsOf(whole.surface.surfels);
    for (const auto& [id, row] : rowsOf(w.surface.surfels)) EXPECT_EQ(all.at(id), row) << id;
  }
}

TEST(SurfaceOutput, CheckpointWithoutASurfaceIsReadForScenesWithoutOne) {
  const Folder folder;
  if (rankOf() == 0) makeOutputFolders(folder.path);
  MPI_Barrier(MPI_COMM_WORLD);
  {
    Sample sample(MPI_COMM_WORLD, 100);
    writeCheckpoint(folder.path, MPI_COMM_WORLD, sample.w, stamp);
  }
  const auto slice = readNewestCheckpoint(folder.path, MPI_COMM_WORLD);
  ASSERT_TRUE(slice);
  EXPECT_FALSE(slice->header.surface.there);
  World w;
  for (AnyColumn* c : w.particles.columns) w.particles.activate(*c);
  for (AnyColumn* c : w.solids.columns) w.solids.activate(*c);
  restoreWorld(w, *slice, rankOf() == 0);
  EXPECT_EQ(w.surface.surfels.owned, 0u);
  World with;
  for (Table* t : {static_cast<Table*>(&with.particles), static_cast<Table*>(&with.solids),
                   static_cast<Table*>(&with.surface.surfels)})
    for (AnyColumn* c : t->columns) t->activate(*c);
  EXPECT_THROW(restoreWorld(with, *slice, rankOf() == 0), IoError) << "a scene that needs surfels";
}

TEST(SurfaceOutput, SnapshotHoldsTheSurface) {
  Sample sample(MPI_COMM_WORLD, 100);
  World& w = sample.w;
  WorldSnapshot kept;
  addSurface(w, MPI_COMM_WORLD, 200);
  World before;
  addSurface(before, MPI_COMM_WORLD, 200);
  takeSnapshot(w, kept);
  expectSame(kept.world.surface, before.surface);
  EXPECT_EQ(rowsOf(kept.world.surface.surfels), rowsOf(before.surface.surfels));
  w.surface.surfels.resize(w.surface.surfels.owned / 2, 0);
  w.surface.events.push_back({});
  w.surface.components.clear();
  w.surface.counters.deaths = 99;
  w.surface.lastStep++;
  StepTools tools;
  emptyWorld(w, tools);
  EXPECT_EQ(w.surface.surfels.owned, 0u);
  restoreSnapshot(kept, w);
  expectSame(w.surface, before.surface);
  EXPECT_EQ(rowsOf(w.surface.surfels), rowsOf(before.surface.surfels));
}

TEST(SurfaceOutput, FramesAreComparedAsSurfels) {
  const Folder folder;
  World w;
  w.clock.time = 0.5;
  w.clock.step = 7;
  addSurface(w, MPI_COMM_WORLD, 150);
  const std::string a = folder.path + "/" + frameName(surfaceName("wax"), 3), b = folder.path + "/b.hdf";
  EXPECT_TRUE(a.ends_with("/wax_surface_000003.hdf"));
  writeFrame(a, MPI_COMM_WORLD, surfaceFrameOf(w.surface, w.clock), stamp);
  const FrameData d = readFrame(a);
  ASSERT_EQ(d.positions.size(), 150u);
  for (const char* name : {"id", "normal", "radius", "color", "component", "detail", "liquid", "temperature"})
    ASSERT_NE(d.find(name), nullptr) << name;
  EXPECT_EQ(d.find("color")->components, 3);
  EXPECT_EQ(d.find("color")->element, Element::U8);
  EXPECT_EQ(d.find("color")->value(5, 0), 10);
  EXPECT_EQ(d.find("color")->value(5, 1), 20);
  // the first surfel of each rank is missing in the other file
  if (w.surface.surfels.owned > 0) w.surface.surfels.resize(w.surface.surfels.owned - 1, 0);
  writeFrame(b, MPI_COMM_WORLD, surfaceFrameOf(w.surface, w.clock), stamp);
  if (rankOf() != 0) return;
  EXPECT_EQ(describe(compareSnapshots(openSnapshot(a), openSnapshot(a), {}))[0],
            "equal: 150 surfels, 8 fields");
  const std::vector<std::string> lines = describe(compareSnapshots(openSnapshot(a), openSnapshot(b), {}));
  ASSERT_GE(lines.size(), 2u);
  EXPECT_NE(lines[1].find("surfels: "), std::string::npos) << lines[1];
  EXPECT_NE(lines[1].find("ids are in A only, the first "), std::string::npos) << lines[1];
  EXPECT_NE(lines[1].find(" at ("), std::string::npos) << lines[1];
}
