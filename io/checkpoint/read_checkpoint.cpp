// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>

#include "core/simulation/ledger/totals.hpp"
#include "core/terms/extensions.hpp"
#include "io/checkpoint/checkpoint.hpp"
#include "io/checkpoint/surface_record.hpp"
#include "io/hdf5/parallel_file.hpp"
#include "io/text/counted.hpp"

namespace thaw {
namespace {

/// Reads the rows of this rank and stores their checksums, which are compared after all ranks have read.
struct CheckedReader {
  const H5File& file;
  std::vector<std::uint64_t> read, stored;
  std::vector<std::string> names;

  void rows(const std::string& name, const RowRange& range, const DatasetShape& expected, void* to) {
    const DatasetShape s = file.shape(name);
    if (s.element != expected.element || std::max(s.components, 1) != std::max(expected.components, 1) ||
        s.rows != expected.rows)
      throw IoError(file.path(),
                    "is damaged, or of another version: " + name + " has an unexpected size or type");
    file.read(name, range, s.element, to);
    names.push_back(name);
    read.push_back(checksumRows(to, range, s.rowBytes()));
    stored.push_back(static_cast<std::uint64_t>(file.integer(name, "checksum")));
  }
};

/// Throws an IoError if the file has a field of an extension with another number of components.
void checkAddedFields(const H5File& file, const Continuum& particles) {
  for (const auto& c : particles.added) {
    const std::string name = std::string("/particles/") + c->name;
    if (!file.has(name)) continue;
    const int found = std::max(file.shape(name).components, 1);
    if (found == c->components) continue;
    const Extension* owner = findFieldOwner(c->name);
    throw IoError(file.path(), "field '" + std::string(c->name) + "' of extension '" +
                                   (owner ? owner->name : "") + "' has " + counted(found, "component") +
                                   ", and this program declares " + std::to_string(c->components) +
                                   ": continue with the program that wrote it");
  }
}

/// Activates the State columns that the file has, and reads them.
void readTable(CheckedReader& in, const std::string& group, Table& table, const RowRange& range,
               std::uint64_t all) {
  for (AnyColumn* c : table.columns)
    if (c->keep == Keep::State && in.file.has(group + "/" + c->name)) table.activate(*c);
  table.resize(range.count, 0);
  for (AnyColumn* c : table.columns)
    if (c->active && c->keep == Keep::State)
      in.rows(group + "/" + c->name, range, {elementOf(c->scalar), all, c->components}, c->bytes.data());
}

/// Returns the number of values below `value` in an ascending dataset, by bisection in the file.
std::uint64_t countBelow(const H5File& file, const std::string& name, std::uint64_t rows,
                         std::uint64_t value) {
  std::uint64_t low = 0, high = rows;
  while (low < high) {
    const std::uint64_t middle = low + (high - low) / 2;
    std::uint64_t there = 0;
    file.read(name, {middle, 1}, Element::U64, &there);
    if (there < value) low = middle + 1;
    else high = middle;
  }
  return low;
}

RowRange share(std::uint64_t all, int rank, int ranks) {
  const auto cut = [&](int r) {
    return static_cast<std::uint64_t>(static_cast<unsigned __int128>(all) * static_cast<unsigned>(r) /
                                      static_cast<unsigned>(ranks));
  };
  return {cut(rank), cut(rank + 1) - cut(rank)};
}

void readBonds(CheckedReader& in, CheckpointSlice& s, const RowRange& solids) {
  const CheckpointHeader& h = s.header;
  std::vector<std::uint64_t> first(solids.count + 1);
  in.rows("/order/first_bond", solids, {Element::U64, h.solids, 0}, first.data());
  first[solids.count] = h.bonds;
  if (solids.first + solids.count < h.solids)
    in.file.read("/order/first_bond", {solids.first + solids.count, 1}, Element::U64, &first[solids.count]);
  if (solids.count == 0) first[0] = first[solids.count];
  s.bondCount.resize(solids.count);
  for (std::size_t k = 0; k < solids.count; k++) {
    if (first[k + 1] < first[k] || first[k + 1] > h.bonds)
      throw IoError(h.path, "is damaged: bonds are not in order");
    s.bondCount[k] = static_cast<std::uint32_t>(first[k + 1] - first[k]);
  }
  const RowRange mine{first[0], first[solids.count] - first[0]};
  if (mine.first > h.bonds || mine.count > h.bonds - mine.first)
    throw IoError(h.path, "is damaged: bonds are not in order");
  std::vector<std::uint64_t> neighbour(mine.count);
  in.rows("/bonds/neighbour", mine, {Element::U64, h.bonds, 0}, neighbour.data());
  s.bonds.assign(mine.count, BondRecord{});
  for (std::size_t k = 0; k < mine.count; k++) s.bonds[k].neighbourId = neighbour[k];
  if (!h.twoFrames) return;
  std::vector<double> reference(3 * mine.count), reverse(3 * mine.count), weight(mine.count);
  in.rows("/bonds/reference", mine, {Element::F64, h.bonds, 3}, reference.data());
  in.rows("/bonds/reverse", mine, {Element::F64, h.bonds, 3}, reverse.data());
  in.rows("/bonds/weight", mine, {Element::F64, h.bonds, 0}, weight.data());
  for (std::size_t k = 0; k < mine.count; k++) {
    BondRecord& b = s.bonds[k];
    b.weight = weight[k];
    for (std::size_t a = 0; a < 3; a++) {
      b.reference[a] = reference[3 * k + a];
      b.reverse[a] = reverse[3 * k + a];
    }
  }
}

CheckpointHeader headerOf(const H5File& file) {
  if (!isCheckpoint(file)) throw IoError(file.path(), "is not a checkpoint: it has no group /checkpoint");
  const std::string at = "/checkpoint";
  CheckpointHeader h;
  h.path = file.path();
  if (const std::int64_t format = file.integer(at, "format"); format != checkpointFormat)
    throw IoError(file.path(), "has checkpoint format " + std::to_string(format) +
                                   "; this version of thaw reads format " + std::to_string(checkpointFormat));
  h.sequence = file.integer(at, "sequence");
  h.clock.step = file.integer(at, "step");
  h.clock.frame = file.integer(at, "frame");
  h.clock.time = file.number(at, "time");
  h.clock.end = file.number(at, "end");
  h.clock.every = file.number(at, "every");
  h.clock.dt = file.number(at, "dt");
  if (file.hasAttribute(at, "step_dt")) h.clock.stepDt = file.number(at, "step_dt");
  if (file.hasAttribute(at, "substeps")) h.clock.substeps = static_cast<int>(file.integer(at, "substeps"));
  h.limitedBy = file.text(at, "limited_by");
  h.twoFrames = file.integer(at, "two_frames") != 0;
  h.particles = file.shape("/particles/id").rows;
  h.solids = file.shape("/order/first_bond").rows;
  h.bonds = file.shape("/bonds/neighbour").rows;
  if (file.has("/pieces/id")) h.pieces = file.shape("/pieces/id").rows;
  if (file.has("/surfels/id")) {
    h.surfels = file.shape("/surfels/id").rows;
    h.surface = readSurfaceRecord(file);
  }
  for (std::size_t k = 0; k < bodyTypeCount; k++)
    if (const std::string ids = std::string("/") + bodyTypeNames[k] + "/id"; file.has(ids))
      h.bodyTypeRows[k] = file.shape(ids).rows;
  for (const NamedCount& c : countsOf(h.counters))
    if (file.hasAttribute(at + "/counters", c.name)) *c.count = file.integer(at + "/counters", c.name);
  if (file.has(at + "/monitor")) {
    for (const NamedReal& v : realsOf(h.monitor))
      if (file.hasAttribute(at + "/monitor", v.name)) *v.value = file.number(at + "/monitor", v.name);
    for (const NamedCount& c : countsOf(h.monitor))
      if (file.hasAttribute(at + "/monitor", c.name)) *c.count = file.integer(at + "/monitor", c.name);
  }
  for (const NamedSum& s : sumsOf(h.ledger)) {
    const std::string name = at + "/ledger/" + s.name;
    if (!file.has(name)) continue;
    if (file.shape(name).rows != ExactSum::digits)
      throw IoError(file.path(), "is damaged: " + name + " has an unexpected size");
    file.read(name, {0, ExactSum::digits}, Element::I64, s.sum->digit.data());
  }
  if (const std::string name = at + "/source_use"; file.has(name)) {
    const DatasetShape shape = file.shape(name);
    if (shape.components != 2) throw IoError(file.path(), "is damaged: " + name + " has an unexpected size");
    std::vector<double> use(2 * shape.rows);
    file.read(name, {0, shape.rows}, Element::F64, use.data());
    for (std::size_t k = 0; k < use.size(); k += 2) h.ledger.sourceUse.push_back({use[k], use[k + 1] > 0});
  }
  for (const NamedValue& v : valuesOf(h.ledger.initial))
    if (file.hasAttribute(at + "/initial", v.name)) *v.value = file.number(at + "/initial", v.name);
  for (const std::string& name : file.attributes(at + "/values"))
    h.values[name] = file.text(at + "/values", name);
  h.code = file.text("/run", "code");
  h.commit = file.text("/run", "commit");
  h.ranks = file.integer("/run", "ranks");
  if (file.hasAttribute("/run", "extensions")) h.extensions = file.text("/run", "extensions");
  h.sceneName = file.readText("/run/scene_name");
  h.sceneText = file.readText("/run/scene_toml");
  return h;
}

}  // namespace

bool isCheckpoint(const H5File& file) {
  return file.has("/checkpoint") && file.hasAttribute("/checkpoint", "format");
}

CheckpointHeader readCheckpointHeader(const std::string& path) {
  return headerOf(H5File::openToRead(path, Trailer::MustBe));
}

std::vector<CheckpointHeader> findCheckpoints(const std::string& out, std::vector<std::string>* problems) {
  std::vector<CheckpointHeader> found;
  for (const char* name : {"/checkpoint/a.hdf", "/checkpoint/b.hdf"}) {
    std::error_code error;
    if (!std::filesystem::exists(out + name, error)) continue;
    try {
      found.push_back(readCheckpointHeader(out + name));
    } catch (const IoError& e) {
      if (problems != nullptr) problems->push_back(e.what());
    }
  }
  std::sort(found.begin(), found.end(),
            [](const CheckpointHeader& a, const CheckpointHeader& b) { return a.sequence > b.sequence; });
  return found;
}

std::unique_ptr<CheckpointSlice> readCheckpoint(const std::string& path, MPI_Comm comm) {
  int rank = 0, ranks = 1;
  MPI_Comm_rank(comm, &rank);
  MPI_Comm_size(comm, &ranks);
  auto slice = std::make_unique<CheckpointSlice>();
  declareAllFields(slice->particles);
  std::vector<std::uint64_t> read, stored;
  std::vector<std::string> names;
  runCollectively(comm, [&] {
    const H5File file = H5File::openToRead(path, Trailer::MustBe);
    CheckpointSlice& s = *slice;
    s.header = headerOf(file);
    const CheckpointHeader& h = s.header;
    CheckedReader in{file, {}, {}, {}};
    const RowRange mine = share(h.particles, rank, ranks);
    checkAddedFields(file, s.particles);
    readTable(in, "/particles", s.particles, mine, h.particles);
    const std::uint64_t firstSolid = countBelow(file, "/order/solid_particle", h.solids, mine.first);
    const RowRange solids{
        firstSolid,
        countBelow(file, "/order/solid_particle", h.solids, mine.first + mine.count) - firstSolid};
    if (rank == 0 && firstSolid != 0) throw IoError(path, "is damaged: solids are not in order");
    std::vector<std::uint64_t> particle(solids.count);
    in.rows("/order/solid_particle", solids, {Element::U64, h.solids, 0}, particle.data());
    readTable(in, "/solids", s.solids, solids, h.solids);
    for (std::size_t k = 0; k < solids.count; k++)
      if (particle[k] < mine.first || particle[k] - mine.first >= mine.count ||
          s.solids.id[k] != s.particles.id[particle[k] - mine.first])
        throw IoError(path, "is damaged: solids do not belong to their particles");
    readBonds(in, s, solids);
    if (h.pieces > 0) readTable(in, "/pieces", s.pieces, share(h.pieces, rank, ranks), h.pieces);
    if (h.surface.there) readTable(in, "/surfels", s.surfels, share(h.surfels, rank, ranks), h.surfels);
    for (std::size_t k = 0; k < bodyTypeCount; k++)
      if (h.bodyTypeRows[k])
        readTable(in, std::string("/") + bodyTypeNames[k], s.kind(k), share(*h.bodyTypeRows[k], rank, ranks),
                  *h.bodyTypeRows[k]);
    read = std::move(in.read);
    stored = std::move(in.stored);
    names = std::move(in.names);
  });
  MPI_Allreduce(MPI_IN_PLACE, read.data(), static_cast<int>(read.size()), MPI_UINT64_T, MPI_SUM, comm);
  for (std::size_t k = 0; k < read.size(); k++)
    // The sums are the same on all ranks.
    if (read[k] != stored[k]) throw IoError(path, "is damaged: the checksum of " + names[k] + " is wrong");
  return slice;
}

std::unique_ptr<CheckpointSlice> readNewestCheckpoint(const std::string& out, MPI_Comm comm) {
  int rank = 0;
  MPI_Comm_rank(comm, &rank);
  // Rank 0 finds the files and broadcasts their order.
  std::vector<std::string> warnings;
  int order[2] = {-1, -1};
  if (rank == 0) {
    const std::vector<CheckpointHeader> found = findCheckpoints(out, &warnings);
    for (std::size_t k = 0; k < found.size(); k++) order[k] = found[k].path.ends_with("/b.hdf");
  }
  MPI_Bcast(order, 2, MPI_INT, 0, comm);
  for (int which : order) {
    if (which < 0) break;
    try {
      std::unique_ptr<CheckpointSlice> slice = readCheckpoint(
          out + (which ? "/checkpoint/b.hdf" : "/checkpoint/a.hdf"), comm);
      slice->warnings = warnings;
      return slice;
    } catch (const IoError& e) {  // on all ranks
      warnings.push_back(e.what());
    }
  }
  // Rank 0 also has warnings about headers. All ranks must throw, or none.
  std::string problem;
  for (const std::string& w : warnings) problem += (problem.empty() ? "" : "; ") + w;
  agree(comm, rank == 0 && !problem.empty() ? "no checkpoint can be read: " + problem : std::string());
  return nullptr;
}

std::vector<std::byte> restoreWorld(World& w, const CheckpointSlice& s, bool firstRank) {
  const CheckpointHeader& h = s.header;
  const auto sameColumn = [&](const Table& from, const AnyColumn& c) -> const AnyColumn& {
    for (const AnyColumn* f : from.columns)
      if (f->active && std::strcmp(f->name, c.name) == 0) return *f;
    const std::string of = std::strcmp(from.kind, "surfels") == 0 ? from.kind
                           : std::strcmp(from.kind, "piece") == 0 ? "rigid pieces"
                                                                  : std::string(from.kind) + " particles";
    throw IoError(h.path, std::string("has no field '") + c.name + "' of " + of +
                              ", which the scene needs: it was written for another scene");
  };
  // Ranks without rows check the columns, too, so that all fail or none.
  const auto takeOver = [&](const Table& from, Table& to) {
    to.resize(to.owned, 0);
    to.resize(from.owned, 0);
    for (AnyColumn* c : to.columns) {
      if (!c->active || c->keep != Keep::State) continue;
      const AnyColumn& column = sameColumn(from, *c);
      if (to.owned > 0) std::memcpy(c->bytes.data(), column.bytes.data(), to.owned * c->elementBytes);
    }
  };
  Continuum& p = w.particles;
  if (s.particles.outsideForce.active) p.activate(p.outsideForce);
  takeOver(s.particles, p);
  if (h.pieces > 0 && !w.pieces.id.active)
    throw IoError(h.path, "has rigid pieces, and the scene has none: it was written for another scene");
  if (h.pieces > 0) takeOver(s.pieces, w.pieces);
  if (w.surface.surfels.id.active) takeOver(s.surfels, w.surface.surfels);
  restoreSurfaceRecord(h.surface, w.surface);
  forEachBodyType(w, [&](std::size_t kind, BodyTypeRows& r, const CellTable&) { takeOver(s.kind(kind), r); });
  if (p.solidIndex.active) std::fill_n(p.solidIndex.data(), p.owned, noSolid);

  const double end = w.clock.end, every = w.clock.every;
  w.clock = h.clock;
  w.clock.limitedBy = "";
  if (every > 0 && every != h.clock.every)
    w.clock.frame = static_cast<std::int64_t>(std::floor(h.clock.time / every * (1 + 1e-12))) + 1;
  w.clock.end = end;
  w.clock.every = every;
  w.counters = firstRank ? h.counters : Counters{};
  w.ledger = firstRank ? h.ledger : Ledger{};
  w.ledger.initial = h.ledger.initial;
  w.ledger.sourceUse = h.ledger.sourceUse;
  w.monitor = h.monitor;

  if (h.solids > 0 && !w.solids.id.active)
    throw IoError(h.path, "has solid particles, but the scene has none: it was written for another scene");
  if (h.solids > 0 && w.bonds.vectors && !h.twoFrames)
    throw IoError(h.path,
                  "does not fit the scene: its bonds have no references of their own, but the scene needs "
                  "them. It was written for another scene");
  std::vector<const AnyColumn*> state;
  for (const AnyColumn* c : w.solids.columns)
    if (h.solids > 0 && c->active && c->keep == Keep::State) state.push_back(&sameColumn(s.solids, *c));
  SolidRecords records;
  std::size_t bond = 0;
  for (std::size_t k = 0; k < s.solids.owned; k++) {
    const std::size_t at = appendHead(records, s.solids.id[k], w.solids.stateBytes(),
                                      {s.bonds.data() + bond, s.bondCount[k]}, h.twoFrames);
    std::byte* to = records.bytes.data() + at;
    for (const AnyColumn* c : state) {
      std::memcpy(to, c->bytes.data() + k * c->elementBytes, c->elementBytes);
      to += c->elementBytes;
    }
    bond += s.bondCount[k];
  }
  return std::move(records.bytes);
}

}  // namespace thaw
