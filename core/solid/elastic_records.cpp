#include "core/solid/elastic_records.hpp"

#include <bit>

namespace thaw {

namespace {

// Nearest integer modulo 2^32, |x| < 2^51: the low bits of the mantissa after 1.5 * 2^52 is added.
std::uint32_t fixedPoint(double x) { return static_cast<std::uint32_t>(std::bit_cast<std::uint64_t>(x + 6755399441055744.0)); }

template<class Real> void packMotionOf(AlignedVector<Real>& records, const Solids& solids, std::size_t first, std::size_t last) {
  const std::size_t values = 4 * solids.size();
  if (records.size() < values) records.resize(values + values / 16, 0);
  for (std::size_t s = first; s < last; s++) {
    for (std::size_t a = 0; a < 3; a++) records[4 * s + a] = static_cast<Real>(solids.velocity[s][static_cast<int>(a)]);
    records[4 * s + 3] = static_cast<Real>(solids.drag[s]);
  }
}

}  // namespace

void packReferences(const ElasticWork& work, Solids& solids, std::size_t first, std::size_t last) {
  if (!solids.reference.active) return;
  const double scale = fixedUnitsPerSupport / work.support;
  for (std::size_t s = first; s < last; s++)
    for (int a = 0; a < 3; a++) {
      if (work.precision == Precision::Single) solids.end[s].reference[a] = std::bit_cast<float>(fixedPoint(solids.reference[s][a] * scale));
      else solids.endDouble[s].reference[a] = solids.reference[s][a];
    }
}

void packPlaces(const ElasticWork& work, Solids& solids, std::size_t first, std::size_t last) {
  if (work.precision == Precision::Single) {
    const double scale = fixedUnitsPerSupport / work.support;
    for (std::size_t s = first; s < last; s++)
      for (int a = 0; a < 3; a++) {
        BondEnd<float>& end = solids.end[s];
        end.displacement[a] = std::bit_cast<float>(fixedPoint(solids.position[s][a] * scale) - std::bit_cast<std::uint32_t>(end.reference[a]));
      }
  } else {
    for (std::size_t s = first; s < last; s++)
      for (int a = 0; a < 3; a++) solids.endDouble[s].displacement[a] = solids.position[s][a] - solids.endDouble[s].reference[a];
  }
}

void packMotion(ElasticWork& work, const Solids& solids, std::size_t first, std::size_t last) {
  if (!work.damping) return;
  if (work.precision == Precision::Single) packMotionOf(work.motion4, solids, first, last);
  else packMotionOf(work.motion4d, solids, first, last);
}

}  // namespace thaw
