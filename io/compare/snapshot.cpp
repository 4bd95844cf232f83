// SPDX-License-Identifier: Apache-2.0
#include "io/compare/snapshot.hpp"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <numeric>

#include "core/simulation/ledger/totals.hpp"
#include "io/checkpoint/checkpoint.hpp"
#include "io/frames/body_type_frame.hpp"

namespace thaw {
namespace {

SnapshotNumber real(const std::string& name, const std::string& unit, double value) {
  return {name, unit, false, value, 0, {}};
}
SnapshotNumber whole(const std::string& name, std::int64_t value) {
  return {name, "1", true, static_cast<double>(value), value, {}};
}

SnapshotTable tableOf(const H5File& file, const std::string& title, const std::string& group,
                      const std::vector<std::string>& without) {
  SnapshotTable t;
  t.title = title;
  t.ids = readRows<std::uint64_t>(file, group + "/id", Element::U64);
  t.order.resize(t.ids.size());
  std::iota(t.order.begin(), t.order.end(), std::uint64_t(0));
  std::stable_sort(t.order.begin(), t.order.end(),
                   [&](std::uint64_t a, std::uint64_t b) { return t.ids[a] < t.ids[b]; });
  for (const std::string& name : file.children(group)) {
    if (name == "id" || std::find(without.begin(), without.end(), name) != without.end()) continue;
    const std::string path = group + "/" + name;
    t.columns.push_back({name, path,
                         file.hasAttribute(path, "units") ? file.text(path, "units") : std::string(),
                         file.shape(path)});
    if (t.columns.back().shape.rows != t.ids.size())
      throw IoError(file.path(), "is damaged: " + path + " does not have one row per id");
  }
  return t;
}

void openFrame(Snapshot& s) {
  const FrameInfo info = readFrameInfo(s.file.path());
  s.kind = "frame";
  s.numbers = {real("time", "s", info.time), whole("step", info.step)};
  const std::string group = "/VTKHDF/PointData";
  if (!s.file.has(group + "/id")) throw IoError(s.file.path(), "has no ids");
  SnapshotTable t = tableOf(s.file, pointTypeOf(s.file), group, {"rank"});
  t.columns.insert(t.columns.begin(), {"position", "/VTKHDF/Points", "m", info.fields[0].shape});
  s.tables.push_back(std::move(t));
}

void openCheckpoint(Snapshot& s) {
  CheckpointHeader h = readCheckpointHeader(s.file.path());
  s.kind = "checkpoint";
  s.numbers = {real("time", "s", h.clock.time), whole("step", h.clock.step), real("dt", "s", h.clock.dt)};
  for (const NamedCount& c : countsOf(h.counters))
    s.numbers.push_back(whole(std::string("counter ") + c.name, *c.count));
  for (const NamedReal& v : realsOf(h.monitor))
    s.numbers.push_back(real(std::string("monitor ") + v.name, "", *v.value));
  for (const NamedCount& c : countsOf(h.monitor))
    s.numbers.push_back(whole(std::string("monitor ") + c.name, *c.count));
  for (const NamedSum& x : sumsOf(h.ledger))
    s.numbers.push_back({std::string("ledger ") + x.name,
                         x.unit,
                         false,
                         x.sum->value(),
                         0,
                         {x.sum->digit.begin(), x.sum->digit.end()}});
  for (const NamedValue& v : valuesOf(h.ledger.initial))
    s.numbers.push_back(real(std::string("initial ") + v.name, v.unit, *v.value));
  for (const auto& [name, text] : h.values) {
    char* end = nullptr;
    const double number = std::strtod(text.c_str(), &end);
    if (end == text.c_str() + text.size()) s.numbers.push_back(real(name, "", number));
    else s.values[name] = text;
  }
  s.tables.push_back(tableOf(s.file, "particles", "/particles", {}));
  if (h.pieces > 0) s.tables.push_back(tableOf(s.file, "rigid pieces", "/pieces", {}));
  if (h.surface.there) {
    s.numbers.push_back(whole("surface last_step", h.surface.lastStep));
    for (const NamedCount& c : countsOf(h.surface.counters))
      s.numbers.push_back(whole(std::string("surface ") + c.name, *c.count));
    s.tables.push_back(tableOf(s.file, "surfels", "/surfels", {}));
    s.tables.push_back(tableOf(s.file, "components", "/surface/components", {}));
    s.tables.push_back(tableOf(s.file, "events", "/surface/events", {}));
  }
  for (const char* kind : bodyTypeNames)
    if (const std::string group = std::string("/") + kind; s.file.has(group + "/id"))
      s.tables.push_back(tableOf(s.file, kind, group, {}));
  if (!s.file.has("/solids/id")) return;
  // "changed" marks solids whose A^-1 is recomputed after migration; it affects no bits
  SnapshotTable solids = tableOf(s.file, "solids", "/solids", {"changed"});
  solids.firstBond = readRows<std::uint64_t>(s.file, "/order/first_bond", Element::U64);
  solids.firstBond.push_back(h.bonds);
  if (solids.firstBond.size() != solids.ids.size() + 1 ||
      !std::is_sorted(solids.firstBond.begin(), solids.firstBond.end()))
    throw IoError(s.file.path(), "is damaged: bonds are not in order");
  for (const std::string& name : s.file.children("/bonds")) {
    const std::string path = "/bonds/" + name;
    solids.bonds.push_back({"bond " + name, path, s.file.text(path, "units"), s.file.shape(path)});
    if (solids.bonds.back().shape.rows != h.bonds)
      throw IoError(s.file.path(), "is damaged: " + path + " does not have one row per bond");
  }
  s.tables.push_back(std::move(solids));
}

}  // namespace

std::string snapshotPath(const std::string& path) {
  std::error_code error;
  if (!std::filesystem::is_directory(path, error)) return path;
  std::vector<std::string> problems;
  const std::vector<CheckpointHeader> found = findCheckpoints(path, &problems);
  if (!found.empty()) return found[0].path;
  throw IoError(path, problems.empty() ? "this folder has no checkpoint"
                                       : "no checkpoint in this folder is readable: " + problems[0]);
}

Snapshot openSnapshot(const std::string& path) {
  Snapshot s{H5File::openToRead(snapshotPath(path)), {}, {}, {}, {}};
  if (isCheckpoint(s.file)) openCheckpoint(s);
  else if (isFrame(s.file)) openFrame(s);
  else throw IoError(path, "is neither a frame nor a checkpoint");
  return s;
}

}  // namespace thaw
