// SPDX-License-Identifier: Apache-2.0
#include "io/image/colour_map.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <stdexcept>

namespace thaw {

namespace {

struct Lch {
  double at, lightness, chroma, hue;
};  // hue in degrees

/// Converts Oklab lightness, chroma and hue to sRGB (OT20). Returns false outside the gamut.
bool toSrgb(double lightness, double chroma, double hue, Rgb& out) {
  const double h = hue * std::numbers::pi / 180, a = chroma * std::cos(h), b = chroma * std::sin(h);
  const double l = std::pow(lightness + 0.3963377774 * a + 0.2158037573 * b, 3);
  const double m = std::pow(lightness - 0.1055613458 * a - 0.0638541728 * b, 3);
  const double s = std::pow(lightness - 0.0894841775 * a - 1.2914855480 * b, 3);
  const double linear[3] = {4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s,
                            -1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s,
                            -0.0041960863 * l - 0.7034186147 * m + 1.7076147010 * s};
  bool inside = true;
  std::uint8_t byte[3];
  for (int i = 0; i < 3; i++) {
    inside = inside && linear[i] > -1e-4 && linear[i] < 1 + 1e-4;
    const double c = std::clamp(linear[i], 0.0, 1.0);
    const double encoded = c <= 0.0031308 ? 12.92 * c : 1.055 * std::pow(c, 1 / 2.4) - 0.055;
    byte[i] = static_cast<std::uint8_t>(std::lround(255 * encoded));
  }
  out = {byte[0], byte[1], byte[2]};
  return inside;
}

/// Interpolates the points linearly in lightness, chroma and hue; chroma is reduced to stay in the gamut.
Palette through(std::span<const Lch> points) {
  Palette palette;
  for (std::size_t i = 0; i < palette.size(); i++) {
    const double t = static_cast<double>(i) / (palette.size() - 1);
    std::size_t k = 1;
    while (k + 1 < points.size() && points[k].at < t) k++;
    const Lch &p = points[k - 1], &q = points[k];
    const double u = (t - p.at) / (q.at - p.at);
    const double lightness = p.lightness + u * (q.lightness - p.lightness), hue = p.hue + u * (q.hue - p.hue);
    double chroma = p.chroma + u * (q.chroma - p.chroma);
    while (!toSrgb(lightness, chroma, hue, palette[i]) && chroma > 0) chroma -= 0.002;
  }
  return palette;
}

// The dark end is not black, so shading stays visible on it.
constexpr Lch ember[] = {{0, 0.44, 0.15, 285},
                         {0.25, 0.55, 0.20, 325},
                         {0.5, 0.66, 0.21, 383},
                         {0.75, 0.77, 0.17, 415},
                         {1, 0.88, 0.16, 458}};
constexpr Lch sea[] = {{0, 0.43, 0.14, 300},
                       {0.25, 0.55, 0.12, 255},
                       {0.5, 0.67, 0.11, 200},
                       {0.75, 0.79, 0.15, 150},
                       {1, 0.91, 0.18, 108}};
constexpr Lch grey[] = {{0, 0.40, 0, 0}, {1, 0.95, 0, 0}};

}  // namespace

ColourMap colourMapNamed(std::string_view name) {
  if (name == "ember") return ColourMap::Ember;
  if (name == "sea") return ColourMap::Sea;
  if (name == "grey") return ColourMap::Grey;
  throw std::invalid_argument("unknown colour map '" + std::string(name) + "'; expected ember, sea or grey");
}

Palette paletteOf(ColourMap map) {
  switch (map) {
    case ColourMap::Sea: return through(sea);
    case ColourMap::Grey: return through(grey);
    default: return through(ember);
  }
}

int paletteIndex(const ColourScale& scale, double value) {
  if (!(scale.max > scale.min)) return 0;
  const double t = (value - scale.min) / (scale.max - scale.min);
  return t > 0 ? static_cast<int>(std::lround(255 * std::min(t, 1.0))) : 0;
}

}  // namespace thaw
