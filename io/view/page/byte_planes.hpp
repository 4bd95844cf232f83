// SPDX-License-Identifier: Apache-2.0
// Numbers in a form that compresses well, for pages without a server. viewer/src/data/byte_planes.js
// decodes it.
#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace thaw {

/// Rows of whole numbers. width: bytes of each, 1, 2, 4 or 8.
struct WholeRows {
  std::vector<std::uint64_t> values;  ///< `components` of each row in turn
  int components = 1, width = 4;
};

/// Returns the differences of successive rows modulo 2^(8 width), component by component: all lowest bytes,
/// then all next ones.
std::vector<std::uint8_t> bytePlanes(const WholeRows& rows);

/// Numbers as multiples of a step: value = low + step * code. The largest code of the width stands for values
/// that are not finite.
struct QuantisedRows {
  WholeRows codes;
  std::vector<double> low, step;  ///< by component
};

/// Accuracy of a quantisation: the number of steps between the lowest and the highest value, and the smallest
/// step, which leaves fewer of them.
struct Accuracy {
  std::uint64_t steps = 254;
  double smallest = 0;
};

/// Requires: accuracy.steps fits into the width, without its largest code.
QuantisedRows quantised(std::span<const float> values, int components, int width, Accuracy accuracy);

/// Returns unit vectors (four components each, 32767 is 1, the fourth is unused) as codes of the octahedron's
/// two coordinates, 0 to 1022 each.
WholeRows octahedral(std::span<const std::int16_t> normals);

/// Returns data as a stream of zlib. Throws std::bad_alloc.
std::string deflated(std::string_view data);

/// Returns data in base 64.
std::string base64(std::string_view data);

}  // namespace thaw
