#include "io/run/surface_log.hpp"

#include <fmt/format.h>

#include <charconv>
#include <fstream>
#include <sstream>

#include "io/hdf5/parallel_file.hpp"

namespace thaw {
namespace {

constexpr const char* head = "frame,step,time_s,component,particles,surfels,mass_kg,particle_volume_m3,volume_m3,area_m2,x_m,y_m,z_m\n";

/// The second field of a line; -1 if there is none.
std::int64_t stepOf(const std::string& line) {
  const std::size_t comma = line.find(',');
  std::int64_t step = -1;
  if (comma != std::string::npos) std::from_chars(line.data() + comma + 1, line.data() + line.size(), step);
  return step;
}

}  // namespace

std::string componentLogPath(const std::string& out) { return out + "/surface.csv"; }
std::string eventLogPath(const std::string& out) { return out + "/events.csv"; }

void beginComponentLog(const std::string& out) { replaceTextFile(componentLogPath(out), head); }

void addToComponentLog(const std::string& out, const World& w) {
  std::string lines;  // numbers in as many digits as make them unique
  for (const SurfaceComponent& c : w.surface.components)
    lines += fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{}\n", w.clock.frame, w.clock.step, w.clock.time, c.label, c.particles, c.surfels, c.mass, c.particleVolume, c.volume, c.area, c.centroid.x,
                         c.centroid.y, c.centroid.z);
  std::ofstream file(componentLogPath(out), std::ios::app);
  file << lines;
  file.close();
  if (!file) throw IoError(componentLogPath(out), "cannot be written");
}

void cutComponentLog(const std::string& out, std::int64_t step) {
  std::ifstream file(componentLogPath(out));
  if (!file) return beginComponentLog(out);
  std::stringstream all;
  all << file.rdbuf();
  std::string kept = head, line;
  for (std::getline(all, line); std::getline(all, line);)
    if (!all.eof() && stepOf(line) >= 0 && stepOf(line) <= step) kept += line + "\n";
  if (kept != all.str()) replaceTextFile(componentLogPath(out), kept);
}

void writeEventLog(const std::string& out, const std::vector<SurfaceEvent>& events) {
  std::string text = "step,time_s,kind,component,other\n";
  for (const SurfaceEvent& e : events) text += fmt::format("{},{},{},{},{}\n", e.step, e.time, eventName(e.kind), e.label, e.other);
  replaceTextFile(eventLogPath(out), text);
}

}  // namespace thaw
