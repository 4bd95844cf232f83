// SPDX-License-Identifier: Apache-2.0
#include "io/view/page/byte_planes.hpp"

#include <zlib.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <new>

namespace thaw {

std::vector<std::uint8_t> bytePlanes(const WholeRows& rows) {
  const auto components = static_cast<std::size_t>(rows.components),
             width = static_cast<std::size_t>(rows.width);
  const std::size_t count = rows.values.size() / components;
  std::vector<std::uint8_t> planes(count * components * width);
  for (std::size_t c = 0; c < components; c++) {
    std::uint8_t* to = planes.data() + c * width * count;
    std::uint64_t before = 0;
    for (std::size_t i = 0; i < count; i++) {
      const std::uint64_t value = rows.values[i * components + c], difference = value - before;
      for (std::size_t b = 0; b < width; b++)
        to[b * count + i] = static_cast<std::uint8_t>(difference >> (8 * b));
      before = value;
    }
  }
  return planes;
}

QuantisedRows quantised(std::span<const float> values, int components, int width, Accuracy accuracy) {
  const auto wide = static_cast<std::size_t>(components);
  const std::uint64_t none = width == 8 ? ~std::uint64_t{0} : (std::uint64_t{1} << (8 * width)) - 1;
  QuantisedRows rows{{std::vector<std::uint64_t>(values.size(), none), components, width},
                     std::vector<double>(wide, 0),
                     std::vector<double>(wide, 0)};
  for (std::size_t c = 0; c < wide; c++) {
    double low = std::numeric_limits<double>::max(), high = std::numeric_limits<double>::lowest();
    for (std::size_t k = c; k < values.size(); k += wide)
      if (const double v = values[k]; std::isfinite(v)) low = std::min(low, v), high = std::max(high, v);
    if (low > high) continue;  // no finite value
    const double step = std::max((high - low) / static_cast<double>(accuracy.steps),
                                 high > low ? accuracy.smallest : 0);
    rows.low[c] = low;
    rows.step[c] = step;
    for (std::size_t k = c; k < values.size(); k += wide)
      if (const double v = values[k]; std::isfinite(v))
        rows.codes.values[k] = step > 0 ? static_cast<std::uint64_t>(std::llround((v - low) / step)) : 0;
  }
  return rows;
}

WholeRows octahedral(std::span<const std::int16_t> normals) {
  WholeRows rows{{}, 2, 2};
  rows.values.reserve(normals.size() / 2);
  const auto code = [](double v) {
    return static_cast<std::uint64_t>(std::llround((std::clamp(v, -1.0, 1.0) + 1) * 511));
  };
  for (std::size_t k = 0; k + 3 < normals.size(); k += 4) {
    const double x = normals[k], y = normals[k + 1], z = normals[k + 2];
    const double size = std::abs(x) + std::abs(y) + std::abs(z);
    double u = size > 0 ? x / size : 0, v = size > 0 ? y / size : 0;
    if (z < 0) {
      const double folded = (1 - std::abs(v)) * (u < 0 ? -1 : 1);
      v = (1 - std::abs(u)) * (v < 0 ? -1 : 1);
      u = folded;
    }
    rows.values.push_back(code(u));
    rows.values.push_back(code(v));
  }
  return rows;
}

std::string deflated(std::string_view data) {
  uLongf size = compressBound(static_cast<uLong>(data.size()));
  std::string stream(size, '\0');
  if (compress2(reinterpret_cast<Bytef*>(stream.data()), &size, reinterpret_cast<const Bytef*>(data.data()),
                static_cast<uLong>(data.size()), Z_DEFAULT_COMPRESSION) != Z_OK)
    throw std::bad_alloc();  // its only failure with a buffer of this size
  stream.resize(size);
  return stream;
}

std::string base64(std::string_view data) {
  constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((data.size() + 2) / 3 * 4);
  for (std::size_t k = 0; k < data.size(); k += 3) {
    std::uint32_t bits = 0;
    for (std::size_t b = 0; b < 3; b++)
      bits = bits << 8 | (k + b < data.size() ? static_cast<unsigned char>(data[k + b]) : 0u);
    for (std::size_t d = 0; d < 4; d++) text += k + d > data.size() ? '=' : digits[bits >> (18 - 6 * d) & 63];
  }
  return text;
}

}  // namespace thaw
