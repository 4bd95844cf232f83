// SPDX-License-Identifier: Apache-2.0
#include "io/run/reports/surface_log.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <fstream>
#include <sstream>

#include "io/hdf5/parallel_file.hpp"

namespace thaw {
namespace {

constexpr const char* headLine =
    "frame,step,time_s,component,particles,surfels,mass_kg,particle_volume_m3,volume_m3,area_m2,x_m,y_m,z_m,"
    "target_volume_m3,open\n";

namespace column {
enum {
  step = 1,
  time,
  component,
  particles,
  surfels,
  particleVolume = 7,
  volume,
  targetVolume = 13,
  open,
  count
};
}

std::vector<std::string> fieldsOf(const std::string& line) {
  std::vector<std::string> fields;
  std::istringstream in(line);
  for (std::string field; std::getline(in, field, ',');) fields.push_back(field);
  return fields;
}

/// Returns a field as a number, or `none` if it has none.
template<class T> T numberIn(const std::vector<std::string>& fields, std::size_t k, T none) {
  if (k < fields.size()) std::from_chars(fields[k].data(), fields[k].data() + fields[k].size(), none);
  return none;
}

/// Returns the commas that lines of earlier versions lack: their missing fields stay empty.
std::string missingCommas(const std::string& line) {
  const auto has = static_cast<std::size_t>(std::count(line.begin(), line.end(), ',')) + 1;
  return std::string(has < column::count ? column::count - has : 0, ',');
}

}  // namespace

std::string componentLogPath(const std::string& out) { return out + "/surface.csv"; }
std::string eventLogPath(const std::string& out) { return out + "/events.csv"; }

void beginComponentLog(const std::string& out) { replaceTextFile(componentLogPath(out), headLine); }

void addToComponentLog(const std::string& out, const Surface& surface, const Clock& clock) {
  std::string lines;  // numbers have as many digits as make them unique
  for (const SurfaceComponent& c : surface.components)
    lines += fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{},{},{}\n", clock.frame, clock.step,
                         clock.time, c.label, c.particles, c.surfels, c.mass, c.particleVolume, c.volume,
                         c.area, c.centroid.x, c.centroid.y, c.centroid.z, c.targetVolume, c.open);
  std::ofstream file(componentLogPath(out), std::ios::app);
  file << lines;
  file.close();
  if (!file) throw IoError(componentLogPath(out), "cannot be written");
}

VolumeErrors truncateComponentLog(const std::string& out, std::int64_t step) {
  VolumeErrors errors;
  std::ifstream file(componentLogPath(out));
  if (!file) {
    beginComponentLog(out);
    return errors;
  }
  std::stringstream all;
  all << file.rdbuf();
  std::string kept = headLine, line;
  std::vector<SurfaceComponent> frame;
  std::int64_t frameStep = -1;
  double time = 0;
  for (std::getline(all, line); std::getline(all, line);) {
    const std::vector<std::string> fields = fieldsOf(line);
    const std::int64_t at = numberIn<std::int64_t>(fields, column::step, -1);
    if (all.eof() || at < 0 || at > step) continue;
    kept += line + missingCommas(line) + "\n";
    if (at != frameStep) {
      recordVolumes(errors, frame, time);
      frame.clear();
      frameStep = at;
    }
    SurfaceComponent c;
    c.label = numberIn<std::uint64_t>(fields, column::component, noComponent);
    c.particles = numberIn<std::int64_t>(fields, column::particles, 0);
    c.surfels = numberIn<std::int64_t>(fields, column::surfels, 0);
    c.particleVolume = numberIn(fields, column::particleVolume, 0.0);
    c.volume = numberIn(fields, column::volume, 0.0);
    c.targetVolume = numberIn(fields, column::targetVolume, 0.0);
    c.open = numberIn(fields, column::open, 0.0);
    frame.push_back(c);
    time = numberIn(fields, column::time, 0.0);
  }
  recordVolumes(errors, frame, time);
  if (kept != all.str()) replaceTextFile(componentLogPath(out), kept);
  return errors;
}

void writeEventLog(const std::string& out, const std::vector<SurfaceEvent>& events) {
  std::string text = "step,time_s,kind,component,other\n";
  for (const SurfaceEvent& e : events)
    text += fmt::format("{},{},{},{},{}\n", e.step, e.time, eventName(e.kind), e.label, e.other);
  replaceTextFile(eventLogPath(out), text);
}

}  // namespace thaw
