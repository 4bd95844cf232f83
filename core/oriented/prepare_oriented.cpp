#include "core/oriented/prepare_oriented.hpp"

#include <algorithm>

#include "core/geometry/sampling.hpp"

namespace thaw {

double orientedReach(const Scene& s) {
  double reach = 0;
  for (const OrientedBody& b : s.oriented) reach = std::max(reach, b.support * (b.spacing > 0 ? b.spacing : s.spacing));
  return reach;
}

void activateOriented(World& w) {
  Oriented& o = w.oriented.rows;
  activateKind(o);
  for (AnyColumn* c : std::initializer_list<AnyColumn*>{&o.orientation, &o.spin, &o.inertia}) o.activate(*c);
}

void sampleOriented(World& w, Halos halos, const MeshLoader& load) {
  Oriented& o = w.oriented.rows;
  for (std::size_t b = 0; b < w.scene.oriented.size(); b++) {
    const OrientedBody& body = w.scene.oriented[b];
    const double spacing = body.spacing > 0 ? body.spacing : w.scene.spacing;
    const auto shape = makeSignedDistance(body.shape, load);
    const SampleLattice l = sampleLattice(*shape, spacing);
    const SampleRange range = sampleRange(l, halos.all.rank(), halos.all.size());
    for (std::int64_t row = range.begin; row < range.end; row++)
      for (const std::int64_t k : insideOfRow(*shape, l, row)) {
        const std::size_t i = o.owned;
        o.resize(i + 1, 0);
        o.id[i] = static_cast<std::uint64_t>(b) << 40 | static_cast<std::uint64_t>(row * l.count[0] + k);
        o.position[i] = l.at(k, row % l.count[1], row / l.count[1]);
        o.orientation[i] = Quat{};
        o.mass[i] = o.inertia[i] = 1;
        o.body[i] = static_cast<std::uint16_t>(b);
      }
  }
}

}  // namespace thaw
