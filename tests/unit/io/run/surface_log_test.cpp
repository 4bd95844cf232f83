// The log of components stays whole when a run goes back or on.
#include "io/run/surface_log.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <unistd.h>

#include <sstream>

namespace thaw::test {
namespace {

struct Log : ::testing::Test {
  std::string out = std::filesystem::temp_directory_path() / ("thaw_surface_log_" + std::to_string(::getpid()));
  Log() { std::filesystem::create_directories(out); }
  ~Log() override { std::filesystem::remove_all(out); }
  std::string text(const std::string& path) const {
    std::ifstream in(path);
    std::stringstream s;
    s << in.rdbuf();
    return s.str();
  }
  void frame(std::int64_t number, std::int64_t step) const {
    World w;
    w.clock.frame = number;
    w.clock.step = step;
    w.clock.time = 0.1 * static_cast<double>(number);
    w.surface.components = {{5, 10, 20, 1.5, 2.5, 0.1 + 0.2, 4.5, {1, 2, 3}}, {9, 1, 2, 3, 4, 5, 6, {7, 8, 9}}};
    addToComponentLog(out, w);
  }
};

}  // namespace

TEST_F(Log, IsCutAtAStep) {
  beginComponentLog(out);
  frame(0, 0);
  frame(1, 12);
  const std::string whole = text(componentLogPath(out));
  EXPECT_NE(whole.find("1,12,0.1,5,10,20,1.5,2.5,0.30000000000000004,4.5,1,2,3\n"), std::string::npos) << whole;
  frame(2, 25);
  std::ofstream(componentLogPath(out), std::ios::app) << "3,4";  // killed while it wrote
  cutComponentLog(out, 24);
  EXPECT_EQ(text(componentLogPath(out)), whole);
  frame(2, 25);
  cutComponentLog(out, 25);
  EXPECT_NE(text(componentLogPath(out)).find("2,25,"), std::string::npos);
  std::filesystem::remove(componentLogPath(out));
  cutComponentLog(out, 25);
  EXPECT_EQ(text(componentLogPath(out)).find("frame,step,time_s,component"), 0u);
}

TEST_F(Log, OfEventsIsTheState) {
  writeEventLog(out, {{3, 0.5, SurfaceEventKind::Split, 1, 7}, {4, 0.75, SurfaceEventKind::Merge, 1, 7}, {5, 1, SurfaceEventKind::Renamed, 2, 1}});
  EXPECT_EQ(text(eventLogPath(out)), "step,time_s,kind,component,other\n3,0.5,split,1,7\n4,0.75,merge,1,7\n5,1,renamed,2,1\n");
  writeEventLog(out, {});
  EXPECT_EQ(text(eventLogPath(out)), "step,time_s,kind,component,other\n");
}

}  // namespace thaw::test
