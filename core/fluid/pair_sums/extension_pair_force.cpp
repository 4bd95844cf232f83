// SPDX-License-Identifier: Apache-2.0
#include "core/fluid/pair_sums/extension_pair_force.hpp"

#include <algorithm>

#include "core/particles/continuum.hpp"

namespace thaw {
namespace {

double liquidFractionOf(const Continuum& p, std::size_t row) {
  if (p.liquid.active) return static_cast<double>(p.liquid[row]);
  return p.phase[row] == Liquid ? 1 : 0;
}

template<class Real> void write(const Vec3d& values, double f, Real* to) {
  to[0] = static_cast<Real>(values.x);
  to[1] = static_cast<Real>(values.y);
  to[2] = static_cast<Real>(values.z);
  to[3] = static_cast<Real>(f);
}

std::size_t recordBytes(Precision precision) { return precision == Precision::Single ? 16 : 32; }

}  // namespace

void resizePairForce(Precision precision, std::size_t rows, PairForceWork& w) {
  const std::size_t each = recordBytes(precision);
  makeRoom(w.records, rows + 1, each);
  w.records.resize((rows + 1) * each);
  std::fill_n(w.records.data() + rows * each, each, std::byte{});
}

void packPairForce(const Scene& scene, const Continuum& p, std::size_t begin, std::size_t end,
                   PairForceWork& w) {
  constexpr std::size_t block = 256;
  w.packed.assign(block, {});
  for (std::size_t first = begin; first < end; first += block) {
    const std::size_t last = std::min(end, first + block);
    if (w.force->pack) w.force->pack({scene, *w.settings, p, first, last, w.packed.data()});
    for (std::size_t i = first; i < last; i++) {
      const double f = liquidFractionOf(p, i);
      if (scene.numerics.precision == Precision::Single)
        write(w.packed[i - first], f, reinterpret_cast<float*>(w.records.data()) + 4 * i);
      else write(w.packed[i - first], f, reinterpret_cast<double*>(w.records.data()) + 4 * i);
    }
  }
}

void clearPairRecords(Precision precision, const AddedColumn& mark, std::size_t rows, PairForceWork& w) {
  const std::size_t each = recordBytes(precision);
  for (std::size_t i = 0; i < rows; i++)
    if (mark.row(i)[0] > 0) std::fill_n(w.records.data() + i * each, each, std::byte{});
}

std::array<double, 4> pairRecordOf(const Scene& scene, const Continuum& p, std::size_t row,
                                   const PairForceWork& w) {
  Vec3d values{};
  if (w.force->pack) w.force->pack({scene, *w.settings, p, row, row + 1, &values});
  std::array<double, 4> record;
  write(values, liquidFractionOf(p, row), record.data());
  return record;
}

}  // namespace thaw
