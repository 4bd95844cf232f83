// SPDX-License-Identifier: Apache-2.0
#include "io/image/image.hpp"

#include <algorithm>
#include <cmath>

namespace thaw {

void mix(Image& image, int x, int y, Rgb colour, double alpha) {
  if (x < 0 || y < 0 || x >= image.width || y >= image.height || alpha <= 0) return;
  const double a = std::min(alpha, 1.0);
  Rgb& p = image.at(x, y);
  const auto between = [a](std::uint8_t from, std::uint8_t to) {
    return static_cast<std::uint8_t>(std::lround(from + a * (to - from)));
  };
  p = {between(p.r, colour.r), between(p.g, colour.g), between(p.b, colour.b)};
}

namespace {

/// Source cells [first, last] of target cell i for a reduction from n to m cells, with the weights of both
/// ends.
struct Span {
  int first, last;
  double firstWeight, lastWeight;
};
Span coverage(int i, int n, int m) {
  const double step = static_cast<double>(n) / m, from = i * step, to = std::min<double>(n, (i + 1) * step);
  const int first = static_cast<int>(from), last = std::min(n - 1, static_cast<int>(std::ceil(to)) - 1);
  return {first, last, first == last ? to - from : first + 1 - from, first == last ? to - from : to - last};
}
double weight(const Span& s, int i) { return i == s.first ? s.firstWeight : i == s.last ? s.lastWeight : 1; }

}  // namespace

Image scaledDown(const Image& image, int width, int height) {
  width = std::clamp(width, 1, image.width);
  height = std::clamp(height, 1, image.height);
  Image out(width, height);
  for (int y = 0; y < height; y++) {
    const Span sy = coverage(y, image.height, height);
    for (int x = 0; x < width; x++) {
      const Span sx = coverage(x, image.width, width);
      double r = 0, g = 0, b = 0, total = 0;
      for (int j = sy.first; j <= sy.last; j++)
        for (int i = sx.first; i <= sx.last; i++) {
          const double w = weight(sy, j) * weight(sx, i);
          const Rgb& p = image.at(i, j);
          r += w * p.r, g += w * p.g, b += w * p.b, total += w;
        }
      const auto byte = [total](double v) { return static_cast<std::uint8_t>(std::lround(v / total)); };
      out.at(x, y) = {byte(r), byte(g), byte(b)};
    }
  }
  return out;
}

void paste(Image& image, const Image& part, int x, int y) {
  const int x0 = std::max(0, -x), x1 = std::min(part.width, image.width - x);
  for (int j = std::max(0, -y); j < std::min(part.height, image.height - y) && x0 < x1; j++)
    std::copy_n(&part.at(x0, j), x1 - x0, &image.at(x + x0, y + j));
}

}  // namespace thaw
