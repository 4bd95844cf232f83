// SPDX-License-Identifier: Apache-2.0
#include "core/heat/contact_heat.hpp"

#include <algorithm>

#include "core/simd/choose.hpp"

namespace thaw {

THAW_CHOOSE(ContactHeatKernels, contactHeatKernelSet, contactHeatKernels)

namespace {

constexpr double largestResistance = 1e15;  // m^2 K/W, finite in single precision

std::size_t recordBytes(Precision precision) { return precision == Precision::Single ? 16 : 32; }

/// Makes room for `rows` rows and the dummy row behind them, which gets zeros.
void resizeRecords(Precision precision, std::size_t rows, AlignedVector<std::byte>& records) {
  const std::size_t each = recordBytes(precision);
  makeRoom(records, rows + 1, each);
  records.resize((rows + 1) * each);
  std::fill_n(records.data() + rows * each, each, std::byte{});
}

/// Calls action with the first value of the records as float or double.
template<class Action>
void withValues(Precision precision, AlignedVector<std::byte>& records, Action action) {
  if (precision == Precision::Single) action(reinterpret_cast<float*>(records.data()));
  else action(reinterpret_cast<double*>(records.data()));
}

void packEnds(Precision precision, const Continuum& p, ContactHeatWork& work) {
  withValues(precision, work.ends, [&]<class Real>(Real* to) {
    for (std::size_t i = 0; i < p.size(); i++, to += 4) {
      to[0] = static_cast<Real>(p.body[i]);
      to[1] = static_cast<Real>(p.phase[i] == Liquid);
      to[2] = to[3] = 0;
    }
  });
}

}  // namespace

void findContactNormals(const PairSums& sums, std::size_t rows, Continuum& p, ContactHeatWork& work) {
  resizeRecords(sums.precision, rows, work.ends);
  resizeRecords(sums.precision, rows, work.faces);
  packEnds(sums.precision, p, work);
  contactHeatKernels()->normals(sums, {work.ends.data(), nullptr, p.contactNormal.data(), work.spacing},
                                {0, sums.lists->groups});
}

void packContactFaces(const Scene& s, const Continuum& p, std::size_t begin, std::size_t end,
                      ContactHeatWork& work) {
  work.spacing = s.spacing;
  withValues(s.numerics.precision, work.faces, [&]<class Real>(Real* to) {
    to += 4 * begin;
    for (std::size_t i = begin; i < end; i++, to += 4) {
      const Vec3f& n = p.contactNormal[i];
      to[0] = static_cast<Real>(n.x), to[1] = static_cast<Real>(n.y), to[2] = static_cast<Real>(n.z);
      to[3] = static_cast<Real>(
          std::min(1 / s.materials[p.material[i]].contactConductance, largestResistance));
    }
  });
}

void addContactHeat(const PairSums& sums, const ContactHeatWork& work, GroupRange range) {
  contactHeatKernels()->heat(sums, {work.ends.data(), work.faces.data(), nullptr, work.spacing}, range);
}

}  // namespace thaw
