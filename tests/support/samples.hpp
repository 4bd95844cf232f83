// SPDX-License-Identifier: Apache-2.0
// All samples of some rows of a shape.
#pragma once
#include "core/geometry/sampling/sampling.hpp"

namespace thaw {

struct Samples {
  std::vector<Vec3d> position;        ///< m
  std::vector<std::uint64_t> number;  ///< index within the body, ascending
};

inline Samples sampleShape(const SignedDistance& shape, const SampleLattice& l, SampleRange range) {
  Samples s;
  KnownSides known;
  for (std::int64_t row = range.begin; row < range.end; row++)
    for (const std::int64_t i : insideOfRow(shape, l, row, known)) {
      s.position.push_back(l.at(i, row % l.count[1], row / l.count[1]));
      s.number.push_back(static_cast<std::uint64_t>(i + l.count[0] * row));
    }
  return s;
}
inline std::int64_t countSamples(const SignedDistance& shape, const SampleLattice& l, SampleRange range) {
  return static_cast<std::int64_t>(sampleShape(shape, l, range).number.size());
}

}  // namespace thaw
