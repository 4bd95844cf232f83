// SPDX-License-Identifier: Apache-2.0
#include "io/view/server/routes.hpp"

#include <unistd.h>

#include "io/render/scene_job.hpp"
#include "io/run/reports/warning_file.hpp"
#include "io/run/run_lock.hpp"
#include "io/view/run/scene_view.hpp"
#include "tests/support/view_run.hpp"

using namespace thaw;
using namespace thaw::test;

namespace {

TEST_F(ViewRun, RequestsWithoutTheTokenAreRefused) {
  for (const std::string path : {"/", "", "/api/run", "/index.html", "/x/api/run", "/open/", "/open/x",
                                 "/0123456789abcdef0123456789abcdee/", "//", "/../wax/api/run"})
    EXPECT_EQ(answer(state, {"GET", path, {}, "127.0.0.1:8573", {}, {}}).status, 403) << path;
  EXPECT_EQ(get("api/run").status, 200);
}

TEST_F(ViewRun, RequestsOfOtherSitesAreRefusedWithTheToken) {
  const std::string path = "/" + state.token + "/api/run";
  EXPECT_EQ(answer(state, {"GET", path, {}, "example.org", {}, {}}).status, 403);
  EXPECT_EQ(answer(state, {"GET", path, {}, "127.0.0.1:8573", "http://example.org", {}}).status, 403);
  EXPECT_EQ(answer(state, {"GET", path, {}, "127.0.0.1:8573", {}, "cross-site"}).status, 403);
}

TEST_F(ViewRun, TheAddressForABrowserIsValidOnce) {
  state.once = "once";
  const ViewRequest open{"GET", "/open/once", {}, "127.0.0.1:8573", {}, "none"};
  const ViewReply first = answer(state, open);
  EXPECT_EQ(first.status, 303);
  EXPECT_EQ(first.location, "/" + state.token + "/");
  EXPECT_EQ(answer(state, open).status, 403);
}

TEST_F(ViewRun, NoPathLeadsOutOfTheRun) {
  sample(4);
  write(0);
  for (const std::string path : {"../secret.txt", "..%2fsecret.txt", "frames/../../secret.txt", "/etc/passwd",
                                 "summary.json", "frames/wax_000000.hdf", "api/../ledger.csv", "api//run"})
    EXPECT_EQ(get(path).status, 404) << path;
  for (const std::string file : {"../secret.txt", "/etc/passwd", "frames/../../secret.txt", "summary.json",
                                 "", "ledger.csv/../../secret.txt"})
    EXPECT_EQ(json("api/log", {{"file", file}, {"columns", "secret"}}).at("rows"), 0) << file;
  for (const std::string number : {"../0", "-1", "0x0", "1e0", "", "99999999999999999999", "0/../../secret"})
    EXPECT_EQ(get("api/frame", {{"number", number}, {"type", "particles"}}).status, 400) << number;
  EXPECT_EQ(get("api/frame", {{"number", "0"}, {"type", "../particles"}}).status, 400);
  EXPECT_EQ(get("api/frame", {{"number", "7"}, {"type", "particles"}}).status, 422);
}

TEST_F(ViewRun, LinksOutOfTheRunAreNotFollowed) {
  sample(4);
  write(0);
  fs::rename(frame(0), folder / "elsewhere.hdf");
  fs::create_symlink(folder / "elsewhere.hdf", frame(0));
  EXPECT_EQ(get("api/frame", {{"number", "0"}, {"type", "particles"}}).status, 422);
  fs::remove(run / "ledger.csv");
  fs::create_symlink(folder / "secret.txt", run / "ledger.csv");
  EXPECT_EQ(json("api/log", {{"file", "ledger.csv"}}).at("bytes"), -1);
}

TEST_F(ViewRun, IndexEntriesWithOtherPathsAreSkipped) {
  sample(4);
  write(0);
  entries.push_back({"../../secret.txt", 1});
  entries.push_back({"wax_1.hdf", 1});
  entries.push_back({"other_000001.hdf", 1});
  writeSeries(seriesPath(run.string(), "wax"), entries);
  EXPECT_EQ(json("api/run").at("frames").at("numbers"), (std::vector<int>{0}));
}

TEST_F(ViewRun, FramesAreListedOnlyAfterAChange) {
  sample(4);
  write(0);
  write(1);
  const auto first = json("api/run");
  EXPECT_EQ(first.at("frames").at("times"), (std::vector<double>{0, 0.5}));
  EXPECT_EQ(first.at("frames").at("has"), (std::vector<int>{1, 1}));
  const std::string revision = first.at("frames").at("revision");
  EXPECT_FALSE(json("api/run", {{"frames", revision}}).contains("frames"));
  write(2);
  EXPECT_TRUE(json("api/run", {{"frames", revision}}).contains("frames"));
}

TEST_F(ViewRun, DamagedFramesAreProblemsAndNoCrash) {
  sample(100);
  write(0);
  const std::string whole = [&] {
    std::ifstream in(frame(0), std::ios::binary);
    return std::string{std::istreambuf_iterator<char>(in), {}};
  }();
  const std::map<std::string, std::string> query{
      {"number", "0"}, {"type", "particles"}, {"field", "velocity"}};
  EXPECT_EQ(get("api/frame", query).status, 200);
  for (std::size_t cut = 0; cut < whole.size(); cut += 97) {  // half-written
    std::ofstream(frame(0), std::ios::binary) << whole.substr(0, cut);
    EXPECT_EQ(get("api/frame", query).status, 422) << cut;
  }
  for (std::size_t at = 0; at < whole.size(); at += 61) {  // rows have no checksum, so some are accepted
    std::string damaged = whole;
    damaged[at] = static_cast<char>(damaged[at] ^ 0x5a);
    std::ofstream(frame(0), std::ios::binary) << damaged;
    const int status = get("api/frame", query).status;
    EXPECT_TRUE(status == 200 || status == 422) << at;
  }
  for (const std::string index : {"", "{", "[]", "{\"files\": 3}", "{\"files\": [{\"name\": 1}]}"}) {
    std::ofstream(seriesPath(run.string(), "wax")) << index;
    EXPECT_EQ(get("api/run").status, 200) << index;
  }
  std::ofstream(run / "summary.json") << "{\"status\": \"do";
  std::ofstream(run / "lock") << "not a lock";
  std::ofstream(run / "progress.csv") << "step,time_s\n1";
  EXPECT_EQ(get("api/run").status, 200);
  EXPECT_EQ(get("api/scene").status, 200);
}

TEST_F(ViewRun, LogsLoseIncompleteLinesAndInfiniteNumbers) {
  const auto log = json("api/log", {{"file", "ledger.csv"}, {"columns", "time_s,kinetic_J,nothing"}});
  EXPECT_EQ(log.at("rows"), 3);
  EXPECT_EQ(log.at("columns").dump(), R"({"time_s":[0.0,0.5,1.0],"kinetic_J":[1.5,null,2.5]})");
  const std::string bytes = std::to_string(log.at("bytes").get<int>());
  EXPECT_TRUE(json("api/log", {{"file", "ledger.csv"}, {"known", bytes}}).at("same"));
}

TEST_F(ViewRun, LongLogsAreThinnedAndKeepTheLastRow) {
  {
    std::ofstream log(run / "ledger.csv");
    log << "step,time_s\n";
    for (int k = 0; k < 1000; k++) log << k << "," << 0.5 * k << "\n";
  }
  const auto log = json("api/log", {{"file", "ledger.csv"}, {"columns", "step"}, {"rows", "100"}});
  EXPECT_EQ(log.at("rows"), 1000);
  const auto& steps = log.at("columns").at("step");
  EXPECT_EQ(steps.size(), 64u);
  EXPECT_EQ(steps.at(1), 16);
  EXPECT_EQ(steps.back(), 999);
}

TEST_F(ViewRun, OnlyALiveRunIsStopped) {
  const ViewRequest stop{"POST",           "/" + state.token + "/api/stop", {},
                         "127.0.0.1:8573", "http://127.0.0.1:8573",         "same-origin"};
  EXPECT_EQ(answer(state, stop).status, 409);
  EXPECT_FALSE(fs::exists(run / "stop"));
  RunLock lock;
  lock.take({run.string()});
  EXPECT_EQ(json("api/run").at("state"), "running");
  EXPECT_EQ(get("api/stop").status, 405) << "GET";
  ViewRequest foreign = stop;
  foreign.origin.reset();
  EXPECT_EQ(answer(state, foreign).status, 403);
  EXPECT_FALSE(fs::exists(run / "stop"));
  EXPECT_EQ(answer(state, stop).status, 200);
  EXPECT_TRUE(fs::is_regular_file(run / "stop"));
  EXPECT_TRUE(json("api/run").at("stop_requested"));
  EXPECT_EQ(answer(state, stop).status, 200) << "again";
}

TEST_F(ViewRun, WarningsOfARunInProgressAreNewerThanItsSummary) {
  std::ofstream(run / "summary.json") << R"({"status": "running", "warnings": ["old"]})";
  EXPECT_EQ(json("api/run").at("summary").at("warnings").dump(), R"(["old"])");
  writeWarnings(run.string(), {"old", "new"});
  EXPECT_EQ(json("api/run").at("summary").at("warnings").dump(), R"(["old","new"])");
  fs::last_write_time(run / warningsName,
                      fs::last_write_time(run / "summary.json") - std::chrono::seconds(1));
  EXPECT_EQ(json("api/run").at("summary").at("warnings").dump(), R"(["old"])") << "of an earlier process";
  std::ofstream(run / warningsName) << "[3";
  EXPECT_EQ(get("api/run").status, 200) << "damaged";
}

TEST_F(ViewRun, ObstaclesHaveTheirLookAndColour) {
  const Scene scene = sceneOfText(std::string("# ---- /scenes/wax.toml\n") + exampleScene() + R"(
[[obstacle]]
name = "pot"
sphere = { radius = 0.1 }
look = "solid"
colour = "#102030"
)",
                                  "wax");
  const auto obstacle = obstacleMeshes(scene).header.at("obstacles").back();
  EXPECT_EQ(obstacle.at("look"), "solid");
  EXPECT_EQ(obstacle.at("colour").dump(), "[16,32,48]");
}

TEST_F(ViewRun, NothingElseIsWritten) {
  sample(50);
  write(0);
  std::set<std::string> before;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) before.insert(entry.path().string());
  get("api/run"), get("api/scene"), get("api/obstacles"), get("api/log", {{"file", "ledger.csv"}});
  get("api/frame", {{"number", "0"}, {"type", "particles"}});
  get("api/point", {{"number", "0"}, {"type", "particles"}, {"index", "1"}});
  std::set<std::string> after;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) after.insert(entry.path().string());
  EXPECT_EQ(before, after);
}

}  // namespace
