// SPDX-License-Identifier: Apache-2.0
#include "io/view/page/export_page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <fstream>
#include <map>
#include <optional>
#include <set>

#include "io/export/out_file.hpp"
#include "io/hdf5/io_error.hpp"
#include "io/hdf5/make_folder.hpp"
#include "io/view/page/byte_planes.hpp"
#include "io/view/page/frame_block.hpp"
#include "io/view/page/page_file.hpp"
#include "io/view/page/thinning.hpp"
#include "io/view/run/log_rows.hpp"
#include "io/view/run/run_files.hpp"
#include "io/view/run/run_status.hpp"
#include "io/view/run/scene_view.hpp"

namespace fs = std::filesystem;

namespace thaw {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t samples = 5;  // frames that are encoded to estimate the size of all
constexpr std::size_t logRowsMost = 600;

/// A run, its frames and its scene, for a page.
struct Source {
  const PageExport& request;
  FrameList list;
  std::optional<Scene> scene;
};

/// Encoded frames. levels: the largest thinning level by point type. tensors: names of tensor fields.
struct Encoded {
  PageData data;
  std::uint64_t bytes = 0;
  PageSizes sizes;
  std::map<std::string, double> levels;
  std::set<std::string> tensors;
};

std::optional<Scene> sceneOf(const fs::path& run, const FrameList& list) {
  const ListedFrame& frame = list.frames.front();
  const auto type = std::find(frame.has.begin(), frame.has.end(), true) - frame.has.begin();
  try {
    return sceneOfFrame(framePath(run, list.scene, static_cast<PointType>(type), frame.number));
  } catch (const std::runtime_error&) { return std::nullopt; }  // a mesh file may be missing on this machine
}

/// Returns whether a type of points may be left out, since the surface shows the same bodies.
bool isSpare(const ListedFrame& frame, std::size_t type) {
  return type == static_cast<std::size_t>(PointType::Particles) &&
         frame.has[static_cast<std::size_t>(PointType::Surface)];
}

void encodeFrame(const Source& from, const ListedFrame& frame, const Thinning& t, Encoded& to) {
  const Json poses = from.scene ? obstaclePoses(*from.scene, frame.time) : Json::array();
  for (std::size_t k = 0; k < frame.has.size(); k++) {
    if (!frame.has[k] || (isSpare(frame, k) && !t.particles)) continue;
    to.sizes.spare = to.sizes.spare || isSpare(frame, k);
    BlockRequest request{
        framePath(from.request.run, from.list.scene, static_cast<PointType>(k), frame.number),
        static_cast<PointType>(k), t.most, from.scene ? from.scene->spacing : 0, t.tensors};
    FrameBlock block = frameBlock(request, poses);
    to.bytes += bytesInPage(block.stream);
    to.sizes.points = std::max(to.sizes.points, block.points);
    to.sizes.tensors = to.sizes.tensors || !block.tensors.empty();
    to.tensors.insert(block.tensors.begin(), block.tensors.end());
    double& level = to.levels[pointTypeNames[k]];
    level = std::max(level, block.level);
    to.data.add(fmt::format("{}-{}", frame.number, pointTypeNames[k]), std::move(block.stream));
    if (static_cast<PointType>(k) == PointType::Surface && t.meshes) {
      const PeriodicSides sides = from.scene ? periodicSidesOf(from.scene->domain) : PeriodicSides{};
      std::string mesh = meshBlock(request, sides);
      to.bytes += bytesInPage(mesh);
      to.sizes.meshes = true;
      to.data.add(fmt::format("{}-mesh", frame.number), std::move(mesh));
    }
  }
}

/// Returns the rows of all columns of a CSV file, or null without one.
Json logOf(const fs::path& run, const std::string& name) {
  const auto path = logInRun(run, name);
  if (!path) return nullptr;
  std::ifstream file(*path);
  std::string header;
  std::getline(file, header);
  LogRequest request{path->string(), {}, logRowsMost};
  for (std::size_t begin = 0; begin < header.size();) {
    const std::size_t end = std::min(header.find(',', begin), header.size());
    request.columns.push_back(header.substr(begin, end - begin));
    begin = end + 1;
  }
  return logRows(request);
}

/// Returns the blocks other than frames. kept: frames in the page.
PageData about(const Source& from, const std::vector<ListedFrame>& kept, const std::string& note) {
  const PageExport& q = from.request;
  Json run = {{"folder", q.preview ? std::string() : q.run.filename().string()}};
  run.update(runStatus(q.run));
  if (run["live"].get<bool>())
    run["state"] = "running", run["text"] = "exported while the run was in progress";
  run["live"] = false;
  run["note"] = note;
  run["preview"] = q.preview;
  Json numbers = Json::array(), times = Json::array(), has = Json::array();
  for (const ListedFrame& f : kept) {
    int mask = 0;
    for (std::size_t k = 0; k < f.has.size(); k++) mask |= f.has[k] ? 1 << k : 0;
    numbers.push_back(f.number), times.push_back(f.time), has.push_back(mask);
  }
  run["frames"] = {{"scene", from.list.scene}, {"revision", "0"}, {"types", pointTypeNames},
                   {"numbers", numbers},       {"times", times},  {"has", has}};
  Json scene = from.scene ? sceneView(*from.scene) : Json(nullptr), logs = Json::object();
  if (from.scene) scene.update(q.look);
  if (!q.preview)
    for (const char* name : {"ledger.csv", "progress.csv"}) logs[name] = logOf(q.run, name);
  PageData data;
  data.addJson("run", {{"run", run}, {"scene", scene}, {"logs", logs}, {"settings", q.settings}});
  data.add("obstacles", deflated((from.scene ? obstacleMeshes(*from.scene) : Packet{}).bytes()));
  data.add("marks", deflated((from.scene ? markLines(*from.scene) : Packet{}).bytes()));
  return data;
}

Encoded encodeSamples(const Source& from, const Thinning& t) {
  Encoded sample;
  const std::size_t count = from.list.frames.size(), n = std::min(samples, count);
  for (std::size_t k = 0; k < n; k++)
    encodeFrame(from, from.list.frames[n == 1 ? count - 1 : k * (count - 1) / (n - 1)], t, sample);
  sample.sizes.frames = count;
  return sample;
}

/// Returns the estimated bytes of all frames that are kept.
std::uint64_t estimate(const Encoded& sample, const Thinning& t) {
  const std::size_t count = sample.sizes.frames;
  std::size_t kept = 0;
  for (std::size_t k = 0; k < count; k++) kept += isKept(k, sample.sizes, t);
  return sample.bytes * kept / std::min(samples, count);
}

/// Returns the estimated bytes of the frames in the smallest page.
std::uint64_t leastOfFrames(const Source& from) {
  Thinning t;
  Encoded sample = encodeSamples(from, t);
  while (thinFurther(sample.sizes, t)) sample = encodeSamples(from, t);
  return estimate(sample, t);
}

std::string sizeText(std::uint64_t bytes) {
  const auto b = static_cast<double>(bytes);
  return b < 1e6 ? fmt::format("{:.0f} kB", b / 1e3) : fmt::format("{:.3g} MB", b / 1e6);
}

/// Returns a text about omitted fields, frames, particles and points, or "".
std::string leftOut(const Source& from, const Encoded& all, std::size_t kept, const Thinning& t) {
  std::string text;
  const auto add = [&](const std::string& part) { text += (text.empty() ? "" : "; ") + part; };
  const std::size_t count = from.list.frames.size();
  if (kept < count) add(fmt::format("{} of {} frames", count - kept, count));
  for (const auto& [type, level] : all.levels)
    if (level > 0) add(fmt::format("{}: all but 1 of {:.2g} points", type, std::exp2(level)));
  std::string names;
  if (!t.tensors)
    for (const std::string& name : all.tensors) names += (names.empty() ? "" : ", ") + name;
  if (!names.empty()) add("the field " + names);
  if (!t.particles) add("particles");
  if (!t.meshes) add("meshes of surfaces");
  return text;
}

/// Returns a warning if a mesh has fewer than a quarter of its points, or "".
std::string coarseText(const Encoded& all) {
  for (const auto& [type, level] : all.levels)
    if (level > 2 && type != pointTypeNames[static_cast<std::size_t>(PointType::Particles)])
      return fmt::format("warning: the {} keeps only 1 of {:.2g} points; choose a larger --size", type,
                         std::exp2(level));
  return "";
}

/// Encodes all kept frames. Returns nothing if they exceed `bytes`.
std::optional<Encoded> encodeAll(const Source& from, const Thinning& t, std::uint64_t bytes,
                                 std::vector<ListedFrame>& kept) {
  Encoded all;
  all.sizes.frames = from.list.frames.size();
  kept.clear();
  for (std::size_t k = 0; k < from.list.frames.size(); k++) {
    if (!isKept(k, all.sizes, t)) continue;
    encodeFrame(from, from.list.frames[k], t, all);
    kept.push_back(from.list.frames[k]);
    for (std::size_t type = 0; type < kept.back().has.size(); type++)
      if (isSpare(from.list.frames[k], type) && !t.particles) kept.back().has[type] = false;
    if (all.bytes > bytes) return std::nullopt;
  }
  return all;
}

void write(const fs::path& file, const std::string& page) {
  makeFolder(file.parent_path());
  OutFile out(file);
  out.text(page);
  out.finish();
}

}  // namespace

void exportPage(const PageExport& q) {
  Source from{q, readFrameList(q.run), {}};
  if (from.list.frames.empty()) throw IoError(q.run.string(), "has no frames");
  from.scene = sceneOf(q.run, from.list);
  std::uint64_t fixed = 4096;  // bytes of the page without frames
  fixed += pageText("", about(from, from.list.frames, "")).size();
  const auto refuse = [&] {
    // The frames are estimated from samples, hence a tenth more.
    const double least = 1.1 * static_cast<double>(leastOfFrames(from)) + static_cast<double>(fixed);
    throw IoError(q.file.string(),
                  fmt::format("a size of {} is too small: the page needs {} without frames; "
                              "choose --size {:.1f}MB or more",
                              sizeText(q.budget), sizeText(fixed), std::ceil(least / 1e5) / 10));
  };
  if (fixed >= q.budget) refuse();
  const std::uint64_t bytes = q.budget - fixed;
  const auto start = std::chrono::steady_clock::now();
  Thinning t;
  Encoded sample = encodeSamples(from, t);
  while (estimate(sample, t) > bytes) {
    const std::size_t every = t.every;
    if (!thinFurther(sample.sizes, t)) refuse();
    if (t.every == every) sample = encodeSamples(from, t);
  }
  const std::uint64_t expected = estimate(sample, t);
  const double each = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count() /
                      static_cast<double>(std::min(samples, from.list.frames.size()));
  const std::size_t count = (from.list.frames.size() + t.every - 1) / t.every;
  if (!q.preview)
    q.say(fmt::format("{} frames, about {}, about {:.0f} s", count, sizeText(expected + fixed),
                      std::ceil(each * static_cast<double>(count))));
  std::vector<ListedFrame> kept;
  std::optional<Encoded> all;
  while (!(all = encodeAll(from, t, bytes, kept))) {
    sample.sizes.frames = from.list.frames.size();
    if (!thinFurther(sample.sizes, t)) refuse();
  }
  const std::string note = leftOut(from, *all, kept.size(), t);
  PageData data = about(from, kept, note.empty() ? "" : "left out of this page: " + note);
  for (auto& block : all->data.blocks) data.blocks.push_back(std::move(block));
  const std::string title = from.scene && !from.scene->title.empty() ? from.scene->title : from.list.scene;
  const std::string page = pageText(title + " – thaw", data);
  write(q.file, page);
  q.say(fmt::format("{}: {} frame{}, {}", q.file.string(), kept.size(), kept.size() == 1 ? "" : "s",
                    sizeText(page.size())));
  if (!note.empty())
    q.say(fmt::format("left out to stay within {} and {} points of each type: {}", sizeText(q.budget),
                      Thinning{}.most, note));
  if (const std::string coarse = coarseText(*all); !coarse.empty()) q.say(coarse);
}

}  // namespace thaw
