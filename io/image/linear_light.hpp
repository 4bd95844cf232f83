// SPDX-License-Identifier: Apache-2.0
// Light as linear red, green and blue, and conversion to sRGB bytes.
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "core/math/vec3.hpp"
#include "io/image/image.hpp"

namespace thaw {

using Light = Vec3f;  ///< linear red, green, blue; 1 is white

inline float decoded(std::uint8_t c) {
  const float x = static_cast<float>(c) / 255;
  return x <= 0.04045f ? x / 12.92f : std::pow((x + 0.055f) / 1.055f, 2.4f);
}
inline Light toLinear(Rgb c) { return {decoded(c.r), decoded(c.g), decoded(c.b)}; }
inline Light product(const Light& a, const Light& b) { return {a.x * b.x, a.y * b.y, a.z * b.z}; }
inline Light mixed(const Light& a, const Light& b, float t) { return (1 - t) * a + t * b; }

/// Computes toLinear by a table.
class Decoder {
 public:
  Decoder() {
    for (std::size_t i = 0; i < table_.size(); i++) table_[i] = decoded(static_cast<std::uint8_t>(i));
  }
  Light operator()(Rgb c) const { return {table_[c.r], table_[c.g], table_[c.b]}; }

 private:
  std::array<float, 256> table_;
};

/// sRGB bytes by table.
class Encoder {
 public:
  Encoder() {
    for (std::size_t i = 0; i < table_.size(); i++) {
      const double x = static_cast<double>(i) / (table_.size() - 1);
      table_[i] = static_cast<std::uint8_t>(
          std::lround(255 * (x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1 / 2.4) - 0.055)));
    }
  }
  Rgb operator()(const Light& l) const { return {byte(l.x), byte(l.y), byte(l.z)}; }

 private:
  std::uint8_t byte(float x) const {
    return table_[static_cast<std::size_t>(std::clamp(x, 0.0f, 1.0f) * static_cast<float>(table_.size() - 1) +
                                           0.5f)];
  }
  std::array<std::uint8_t, 8192> table_;
};

/// Smooth step: 0 below `from`, 1 above `to`.
inline float ramp(float from, float to, float x) {
  const float t = std::clamp((x - from) / (to - from), 0.0f, 1.0f);
  return t * t * (3 - 2 * t);
}

}  // namespace thaw
