// SPDX-License-Identifier: Apache-2.0
// The lock of a run's folder: live and dead holders, other hosts, and simultaneous starts.
#include "io/run/run_lock.hpp"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "io/hdf5/io_error.hpp"

namespace thaw {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

struct RunLockOf : testing::Test {
  std::string out = (fs::temp_directory_path() / ("thaw_lock_" + std::to_string(::getpid()))).string();
  std::string file = out + "/lock";
  ~RunLockOf() override { fs::remove_all(out); }

  void leave(const Json& j) const {
    fs::create_directories(out);
    std::ofstream(file) << j.dump() << "\n";
  }
  /// The process, and one with its number but another start time.
  static Json lockOf(long pid, long long began, const std::string& host = ownProcess().host) {
    return {{"host", host},
            {"pid", pid},
            {"began_ticks", began},
            {"ranks", 4},
            {"since", "2030-01-02T03:04:05Z"}};
  }
  std::string error(const LockRequest& q) const {
    RunLock lock;
    try {
      lock.take(q);
    } catch (const IoError& e) { return e.what(); }
    return "";
  }
  bool onlyTheLock() const {
    return std::distance(fs::directory_iterator(out), fs::directory_iterator()) == 1;
  }
};

TEST_F(RunLockOf, LiveHolderIsNamedAndTheEndRemovesTheLock) {
  {
    RunLock lock;
    EXPECT_EQ(lock.take({.out = out, .ranks = 3}), "");
    EXPECT_TRUE(onlyTheLock());
    for (const bool force : {false, true})
      EXPECT_NE(error({.out = out, .force = force, .waitTime = 0})
                    .find("another run uses this folder: process " + std::to_string(::getpid())),
                std::string::npos);
    EXPECT_EQ(lockHolder(out)->ranks, 3);
    EXPECT_NE(lockText(lockJson(*lockHolder(out))).find("(3 ranks, since"), std::string::npos);
  }
  EXPECT_FALSE(fs::exists(file));
  EXPECT_FALSE(lockHolder(out));
}

TEST_F(RunLockOf, ADeadHolderIsReplaced) {
  const pid_t child = ::fork();
  if (child == 0) ::_exit(0);
  ::waitpid(child, nullptr, 0);
  // dead; another process has its number
  for (const Json& j : {lockOf(child, 1), lockOf(::getpid(), ownProcess().began - 1)}) {
    leave(j);
    RunLock lock;
    const std::string note = lock.take({.out = out, .waitTime = 0});
    EXPECT_NE(note.find("(4 ranks, since 2030-01-02T03:04:05Z) has ended"), std::string::npos) << note;
    EXPECT_EQ(lockHolder(out)->process.began, ownProcess().began);
    EXPECT_TRUE(onlyTheLock());
  }
}

TEST_F(RunLockOf, AnotherHostsLockNeedsForce) {
  for (const std::string& text :
       {lockOf(1, 1, "elsewhere").dump(), std::string("{ \"host\":"), std::string()}) {
    fs::create_directories(out);
    std::ofstream(file) << text;
    EXPECT_NE(error({.out = out, .waitTime = 0}).find("--force"), std::string::npos) << text;
    EXPECT_TRUE(fs::exists(file)) << "a refused start leaves the lock";
    RunLock lock;
    EXPECT_NE(lock.take({.out = out, .force = true, .waitTime = 0}).find("(--force)"), std::string::npos);
  }
}

TEST_F(RunLockOf, LockTakenByForceIsKept) {
  RunLock lock;
  lock.take({.out = out});
  leave(lockOf(7, 7, "elsewhere"));
  lock.release();
  EXPECT_EQ(lockHolder(out)->process.host, "elsewhere");
}

// Exactly one of simultaneous starts gets the folder, whether it is free or a dead process has locked it.
TEST_F(RunLockOf, OneOfSimultaneousStartsGetsTheFolder) {
  const pid_t dead = ::fork();
  if (dead == 0) ::_exit(0);
  ::waitpid(dead, nullptr, 0);
  for (int round = 0; round < 20; round++) {
    fs::create_directories(out);
    if (round % 2) leave(lockOf(dead, 1));
    else fs::remove(file);
    int go[2], stay[2];
    ASSERT_EQ(::pipe(go), 0);
    ASSERT_EQ(::pipe(stay), 0);
    std::vector<pid_t> children;
    for (int k = 0; k < 8; k++) {
      children.push_back(::fork());
      if (children.back() != 0) continue;
      char c;
      ::close(go[1]), ::close(stay[1]);
      [[maybe_unused]] const auto began = ::read(go[0], &c, 1);  // blocks until the parent closes the pipe
      RunLock lock;
      try {
        lock.take({.out = out, .waitTime = 0.2});
      } catch (const IoError&) { ::_exit(1); }
      [[maybe_unused]] const auto bytesRead = ::read(stay[0], &c, 1);
      lock.release();
      ::_exit(0);
    }
    ::close(go[0]), ::close(stay[0]);
    ::close(go[1]);
    int taken = 0;
    for (int k = 0; k < 7; k++) {  // the losers end; the winner waits
      int status = 0;
      ::waitpid(-1, &status, 0);
      taken += status == 0;
    }
    EXPECT_EQ(taken, 0);
    ::close(stay[1]);
    int status = 1;
    ::waitpid(-1, &status, 0);
    EXPECT_EQ(status, 0) << "one start gets the folder";
  }
  EXPECT_TRUE(fs::is_empty(out));
}

}  // namespace
}  // namespace thaw
