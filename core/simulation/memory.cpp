// SPDX-License-Identifier: Apache-2.0
#include "core/simulation/memory.hpp"

namespace thaw {
namespace {

double bytesOf(const Table& t) {
  std::size_t n = 0;
  for (const AnyColumn* c : t.columns)
    if (c->active) n += c->bytes.capacity();
  return static_cast<double>(n + t.bufferBytes());
}

template<class... Vectors> double bytesOf(const Vectors&... v) {
  return (0.0 + ... + static_cast<double>(v.capacity() * sizeof(v[0])));
}

}  // namespace

std::vector<MemoryUse> memoryOf(const World& w, const StepTools& t) {
  const NeighbourLists& n = w.neighbours;
  const Bonds& b = w.bonds;
  const ElasticWork& e = t.solid.elastic;
  const PairRecords& r = t.sums.records;
  const Surface& f = w.surface;
  const OrientedWork& o = t.oriented;
  const Bonds& edges = w.sheets.edges.bonds;
  return {
      {"particles", bytesOf(static_cast<const Table&>(w.particles))},
      {"oriented", bytesOf(static_cast<const Table&>(w.oriented.rows)) +
                       bytesOf(o.lists.first, o.lists.list, o.place, o.move, o.spinMove, o.turn, o.velocity,
                               o.spin, o.rest, o.restSpin, o.along, o.alongSpin, o.image, o.imageSpin)},
      {"sheets", bytesOf(static_cast<const Table&>(w.sheets.rows)) +
                     bytesOf(static_cast<const Table&>(w.sheets.edges.ends)) +
                     static_cast<double>(edges.bytes()) + bytesOf(w.sheets.slope)},
      {"solids", bytesOf(static_cast<const Table&>(w.solids))},
      {"cells", bytesOf(w.cells.key, w.cells.first, w.cells.count, t.sums.inner, t.sums.liquidCells)},
      {"neighbour lists", bytesOf(n.self, n.first, n.count, n.list, n.fluid, n.neighbours)},
      {"pair records", bytesOf(r.fixed, r.middle, r.coarse[0], r.coarse[1], r.coarse[2], r.positionVolume,
                               r.velocityViscosity, r.pressurePhaseHeat, r.surface, r.pressureDiagonal,
                               r.pressureOffDiagonal, r.surfaceEnergyDerivatives)},
      {"bonds", static_cast<double>(b.bytes())},
      {"elastic work",
       bytesOf(e.remoteGroup, e.ownFrames, e.inner, e.boundary, e.bondCount, e.rank, e.singularLanes,
               e.stretched, e.perTrace, e.perWeight, e.strainBound, e.velocityDrag, e.velocityDragDouble)},
      {"surface", bytesOf(static_cast<const Table&>(f.surfels)) +
                      bytesOf(static_cast<const Table&>(f.particles)) +
                      bytesOf(f.surfelCells.key, f.surfelCells.first, f.surfelCells.count,
                              f.particleCells.key, f.particleCells.first, f.particleCells.count)},
      {"walls and contacts",
       bytesOf(t.walls.contacts.list, t.contact.closePairs.list, t.contact.resistance, t.contact.bodies.pairs,
               t.contact.bodies.rows, t.contact.bodies.resistance, t.phaseChange.energy.ofPairs,
               t.phaseChange.energy.inPairs, t.phaseChange.energy.liquid, t.phaseChange.energy.springs,
               t.phaseChange.energy.touching, t.phaseChange.energy.energy, t.phaseChange.energy.dissipation,
               t.phaseChange.energy.force)},
      {"sort and search", bytesOf(t.redistribution.sort.gone, t.redistribution.sort.movers,
                                  t.redistribution.sort.before, t.redistribution.sort.order,
                                  t.redistribution.sort.moves.runs, t.redistribution.sort.moves.singles,
                                  t.sums.search.x, t.sums.search.y, t.sums.search.z, t.sums.search.entry)}};
}

double totalBytes(const std::vector<MemoryUse>& use) {
  double sum = 0;
  for (const MemoryUse& u : use) sum += u.bytes;
  return sum;
}

std::vector<std::string> fieldsOf(const World& w) {
  std::vector<std::string> names;
  for (const Table* t :
       {static_cast<const Table*>(&w.particles), static_cast<const Table*>(&w.solids),
        static_cast<const Table*>(&w.surface.surfels), static_cast<const Table*>(&w.surface.particles)})
    for (const AnyColumn* c : t->columns)
      if (c->active) names.push_back(std::string(t->kind) + "." + c->name);
  return names;
}

}  // namespace thaw
