// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cstring>
#include <filesystem>
#include <stdexcept>

#include "core/rigid/link_pieces.hpp"
#include "core/simulation/ledger/totals.hpp"
#include "io/checkpoint/checkpoint.hpp"
#include "io/checkpoint/surface_record.hpp"
#include "io/hdf5/parallel_file.hpp"
#include "parallel/communicator.hpp"

namespace thaw {
namespace {

/// Order in which the solids and bonds of this rank are written.
struct SolidOrder {
  std::vector<std::uint32_t> solidIndices;  // solids of owned particles, ascending by particle
  std::vector<std::uint64_t> particle;      // row of the particle in the file
  std::vector<std::uint64_t> firstBond;     // first bond of each solid on this rank; one more at the end
};

SolidOrder orderSolids(const Continuum& particles, const Bonds& bonds, std::uint64_t firstRow) {
  SolidOrder o;
  std::uint64_t count = 0;
  for (std::size_t i = 0; particles.solidIndex.active && i < particles.owned; i++) {
    const std::uint32_t solidIndex = particles.solidIndex[i];
    if (solidIndex == noSolid) continue;
    o.solidIndices.push_back(solidIndex);
    o.particle.push_back(firstRow + i);
    o.firstBond.push_back(count);
    for (int k = 0; k < bonds.capacity; k++) count += bonds.hasBond(solidIndex, k);
  }
  o.firstBond.push_back(count);
  return o;
}

/// Calls use(index in the range, index in Bonds) for bonds [range.first, + count) of this rank.
template<class Use>
void eachBond(const Bonds& bonds, const SolidOrder& order, const RowRange& range, Use&& use) {
  std::size_t solid = static_cast<std::size_t>(
                          std::upper_bound(order.firstBond.begin(), order.firstBond.end(), range.first) -
                          order.firstBond.begin()) -
                      1;
  for (std::uint64_t at = order.firstBond[solid]; at < range.first + range.count; solid++)
    for (int k = 0; k < bonds.capacity && at < range.first + range.count; k++) {
      if (!bonds.hasBond(order.solidIndices[solid], k)) continue;
      if (at >= range.first) use(at - range.first, bonds.at(order.solidIndices[solid], k));
      at++;
    }
}

/// Adds the State columns of a table, or those of its pack.
void addColumns(ParallelFileContent& content, const std::string& group, const Table& table,
                const PackedTable* packed, const Spread& spread, const SolidOrder* order) {
  content.groups.push_back(group);
  for (std::size_t k = 0; k < table.columns.size(); k++) {
    const AnyColumn* c = table.columns[k];
    if (packed ? !packed->columns[k].there : !c->active || c->keep != Keep::State) continue;
    SpreadDataset d;
    d.name = group + "/" + c->name;
    d.shape = {elementOf(c->scalar), spread.all, c->components > 1 ? c->components : 0};
    d.mine = spread.mine;
    d.unit = c->unit;
    const std::size_t bytes = c->elementBytes;
    if (packed)
      d.fill = [c, k, packed](const RowRange& local, std::byte* to) {
        unpackRows(*packed, *c, k, local.first, local.count, to);
      };
    else if (order == nullptr) d.data = c->bytes.data();
    else
      d.fill = [c, order, bytes](const RowRange& local, std::byte* to) {
        for (std::uint64_t k = 0; k < local.count; k++)
          std::memcpy(to + k * bytes, c->bytes.data() + order->solidIndices[local.first + k] * bytes, bytes);
      };
    content.datasets.push_back(std::move(d));
  }
}

void addBonds(ParallelFileContent& content, const Bonds& b, const Solids& solids, const SolidOrder& order,
              const Spread& spread) {
  content.groups.push_back("/bonds");
  const auto add = [&](const std::string& name, const std::string& unit, Element element, int components,
                       auto put) {
    SpreadDataset d;
    d.name = "/bonds/" + name;
    d.shape = {element, spread.all, components};
    d.mine = spread.mine;
    d.unit = unit;
    const std::size_t bytes = d.shape.rowBytes();
    d.fill = [&b, &order, bytes, put](const RowRange& local, std::byte* to) {
      eachBond(b, order, local, [&](std::uint64_t k, std::size_t place) { put(place, to + k * bytes); });
    };
    content.datasets.push_back(std::move(d));
  };
  const auto vector = [](const BondReals& x, const BondReals& y, const BondReals& z) {
    return [&x, &y, &z](std::size_t place, std::byte* to) {
      const double v[3] = {x[place], y[place], z[place]};
      std::memcpy(to, v, sizeof v);
    };
  };
  add("neighbour", "1", Element::U64, 0,
      [&](std::size_t place, std::byte* to) { std::memcpy(to, &solids.id[b.neighbour[place]], 8); });
  if (!b.vectors) return;  // the rest follows from /solids/reference
  add("reference", "m", Element::F64, 3, vector(b.x, b.y, b.z));
  add("reverse", "m", Element::F64, 3, vector(b.rx, b.ry, b.rz));
  add("weight", "1", Element::F64, 0, [&](std::size_t place, std::byte* to) {
    const double weight = b.weight[place];
    std::memcpy(to, &weight, sizeof weight);
  });
}

void writeHeader(H5File& file, const CheckpointHeader& h) {
  MonitorState monitor = h.monitor;
  const std::string at = "/checkpoint";
  file.setInteger(at, "format", checkpointFormat);
  file.setInteger(at, "sequence", h.sequence);
  file.setInteger(at, "step", h.clock.step);
  file.setInteger(at, "frame", h.clock.frame);
  file.setNumber(at, "time", h.clock.time);
  file.setNumber(at, "end", h.clock.end);
  file.setNumber(at, "every", h.clock.every);
  file.setNumber(at, "dt", h.clock.dt);
  file.setNumber(at, "step_dt", h.clock.stepDt);
  if (h.clock.substeps > 1) file.setInteger(at, "substeps", h.clock.substeps);
  file.setText(at, "limited_by", h.limitedBy);
  file.setInteger(at, "two_frames", h.twoFrames);
  file.createGroup(at + "/monitor");
  for (const NamedReal& v : realsOf(monitor)) file.setNumber(at + "/monitor", v.name, *v.value);
  for (const NamedCount& c : countsOf(monitor)) file.setInteger(at + "/monitor", c.name, *c.count);
  Ledger ledger = h.ledger;
  Counters counters = h.counters;
  file.createGroup(at + "/counters");
  for (const NamedCount& c : countsOf(counters)) file.setInteger(at + "/counters", c.name, *c.count);
  file.createGroup(at + "/ledger");
  for (const NamedSum& s : sumsOf(ledger)) {
    const std::string name = at + "/ledger/" + s.name;
    // exact sum: 32-bit digits from 2^-1088 up
    file.writeAll(name, {Element::I64, ExactSum::digits, 0}, s.sum->digit.data());
    file.setText(name, "units", s.unit);
    file.setNumber(name, "value", s.sum->value());
  }
  std::vector<double> use;
  for (const SourceUse& s : ledger.sourceUse)
    use.insert(use.end(), {s.given, static_cast<double>(s.absorbed)});
  if (!use.empty()) file.writeAll(at + "/source_use", {Element::F64, ledger.sourceUse.size(), 2}, use.data());
  file.createGroup(at + "/initial");
  for (const NamedValue& v : valuesOf(ledger.initial)) file.setNumber(at + "/initial", v.name, *v.value);
  file.createGroup(at + "/values");
  for (const auto& [name, value] : h.values) file.setText(at + "/values", name, value);
  if (h.surface.there) writeSurfaceRecord(file, h.surface);
}

/// Writes the state as a file, with particles from the pack if there is one. The sums in the header are over
/// all ranks.
void writeState(const std::string& path, std::int64_t sequence, MPI_Comm comm, const World& w,
                const PackedTable* packed, const RunStamp& stamp, const CheckpointValues& values) {
  if (!w.solids.energyKnown || !w.interactionHasCompression)
    throw std::logic_error("stored energies must be computed before a checkpoint is written");
  const Communicator ours(comm);
  MpiReducer all(ours);
  CheckpointHeader h;
  h.clock = w.clock;
  if (w.clock.limitedBy != nullptr) h.limitedBy = std::string(w.clock.limitedBy);
  h.twoFrames = w.bonds.twoFrames;
  h.counters = globalCounters(w.counters, all);
  h.ledger = globalLedger(w.ledger, all);
  h.monitor = w.monitor;
  h.values = values;
  h.sequence = sequence;
  h.surface = surfaceRecordOf(w.surface);
  const Spread particles = spreadRows(comm, w.particles.owned);
  const SolidOrder order = orderSolids(w.particles, w.bonds, particles.mine.first);
  const Spread solids = spreadRows(comm, order.solidIndices.size()),
               bonds = spreadRows(comm, order.firstBond.back());
  ParallelFileContent content;
  content.checked = true;
  content.groups = {"/checkpoint", "/run", "/order"};
  addColumns(content, "/particles", w.particles, packed, particles, nullptr);
  addColumns(content, "/solids", w.solids, nullptr, solids, &order);
  addBonds(content, w.bonds, w.solids, order, bonds);
  Pieces pieces;
  copyLedRows(w.pieces, pieces);
  if (pieces.id.active)
    addColumns(content, "/pieces", pieces, nullptr, spreadRows(comm, pieces.owned), nullptr);
  if (h.surface.there) {
    content.groups.push_back("/surface");
    addColumns(content, "/surfels", w.surface.surfels, nullptr, spreadRows(comm, w.surface.surfels.owned),
               nullptr);
  }
  forEachBodyType(w, [&](std::size_t kind, const BodyTypeRows& r, const CellTable&) {
    addColumns(content, std::string("/") + bodyTypeNames[kind], r, nullptr, spreadRows(comm, r.owned),
               nullptr);
  });
  std::vector<std::uint64_t> firstBond(order.firstBond.begin(), order.firstBond.end() - 1);
  for (std::uint64_t& f : firstBond) f += bonds.mine.first;
  content.datasets.push_back(
      {"/order/solid_particle", {Element::U64, solids.all, 0}, solids.mine, order.particle.data(), "1", {}});
  content.datasets.push_back(
      {"/order/first_bond", {Element::U64, solids.all, 0}, solids.mine, firstBond.data(), "1", {}});
  content.smallBytes = stamp.sceneText.size() + h.ledger.sourceUse.size() * sizeof(SourceUse) +
                       h.surface.components.size() * sizeof(SurfaceComponent) +
                       h.surface.events.size() * sizeof(SurfaceEvent);
  content.small = [&](H5File& file) {
    writeHeader(file, h);
    writeStamp(file, stamp, ours.size());
  };
  writeParallelFile(path, comm, content);
}

/// Returns the path that the next checkpoint replaces: the older one, or an unreadable one.
std::string nextPath(const std::string& out, MPI_Comm comm, std::int64_t& sequence) {
  int second = 0;
  onFirstRank(comm, [&] {
    const std::vector<CheckpointHeader> there = findCheckpoints(out);
    sequence = there.empty() ? 1 : there[0].sequence + 1;
    second = !there.empty() && there[0].path.ends_with("/a.hdf");
  });
  MPI_Bcast(&second, 1, MPI_INT, 0, comm);
  return out + "/checkpoint/" + (second ? "b.hdf" : "a.hdf");
}

std::string writeNext(const std::string& out, MPI_Comm comm, const World& w, const PackedTable* packed,
                      const RunStamp& stamp, const CheckpointValues& values) {
  std::int64_t sequence = 1;
  std::string path = nextPath(out, comm, sequence);
  writeState(path, sequence, comm, w, packed, stamp, values);
  return path;
}

}  // namespace

std::string writeCheckpoint(const std::string& out, MPI_Comm comm, const World& w, const RunStamp& stamp,
                            const CheckpointValues& values) {
  return writeNext(out, comm, w, nullptr, stamp, values);
}

std::string writeCheckpoint(const std::string& out, MPI_Comm comm, const WorldSnapshot& kept,
                            const RunStamp& stamp, const CheckpointValues& values) {
  return writeNext(out, comm, kept.world, &kept.particles, stamp, values);
}

std::string snapshotFilePath(const std::string& out, std::int64_t step) {
  return out + "/checkpoint/good_" + std::to_string(step) + ".hdf";
}

std::string writeSnapshot(const std::string& out, MPI_Comm comm, const WorldSnapshot& kept,
                          const RunStamp& stamp, const CheckpointValues& values) {
  std::string path = snapshotFilePath(out, kept.world.clock.step);
  writeState(path, 0, comm, kept.world, &kept.particles, stamp, values);
  return path;
}

void dropUnusedSnapshots(const std::string& out) {
  std::vector<std::string> used, problems;
  for (const CheckpointHeader& h : findCheckpoints(out, &problems))
    used.push_back(snapshotFilePath(out, h.monitor.snapshotStep));
  if (!problems.empty()) return;  // an unreadable checkpoint may need one
  std::error_code error;
  std::vector<std::filesystem::path> unused;
  for (const auto& entry : std::filesystem::directory_iterator(out + "/checkpoint", error)) {
    const std::string name = entry.path().filename().string();
    if (name.starts_with("good_") && name.ends_with(".hdf") &&
        std::find(used.begin(), used.end(), out + "/checkpoint/" + name) == used.end())
      unused.push_back(entry.path());
  }
  for (const auto& path : unused) std::filesystem::remove(path, error);
}

}  // namespace thaw
