#include "core/sheet/prepare_sheets.hpp"

#include "core/geometry/sampling.hpp"

namespace thaw {

double sheetReach(const Scene&) { return 0; }

void activateSheets(World& w) {
  Sheets& s = w.sheets.rows;
  activateKind(s);
  s.activate(s.rest);
}

void sampleSheets(World& w, Halos halos, const MeshLoader& load) {
  Sheets& s = w.sheets.rows;
  for (std::size_t b = 0; b < w.scene.sheets.size(); b++) {
    const auto shape = makeSignedDistance(w.scene.sheets[b].shape, load);
    const SampleLattice l = sampleLattice(*shape, w.scene.spacing);
    const SampleRange range = sampleRange(l, halos.all.rank(), halos.all.size());
    for (std::int64_t row = range.begin; row < range.end; row++)
      for (const std::int64_t k : insideOfRow(*shape, l, row)) {
        const std::size_t i = s.owned;
        s.resize(i + 1, 0);
        s.id[i] = static_cast<std::uint64_t>(b) << 40 | static_cast<std::uint64_t>(row * l.count[0] + k);
        s.position[i] = s.rest[i] = l.at(k, row % l.count[1], row / l.count[1]);
        s.mass[i] = 1;
        s.body[i] = static_cast<std::uint16_t>(b);
      }
  }
}

}  // namespace thaw
