// SPDX-License-Identifier: Apache-2.0
// Images in memory and as PNG files.
#pragma once
#include <cstdint>
#include <filesystem>
#include <vector>

namespace thaw {

struct Rgb {
  std::uint8_t r = 0, g = 0, b = 0;
};
/// Colour of a scene: red | green << 8 | blue << 16.
inline Rgb rgbOf(std::uint32_t colour) {
  return {static_cast<std::uint8_t>(colour), static_cast<std::uint8_t>(colour >> 8),
          static_cast<std::uint8_t>(colour >> 16)};
}
inline bool operator==(const Rgb& a, const Rgb& b) { return a.r == b.r && a.g == b.g && a.b == b.b; }

/// Picture with 8 bits per channel (sRGB), rows from the top.
struct Image {
  int width = 0, height = 0;
  std::vector<Rgb> pixels;  ///< height x width

  Image() = default;
  Image(int w, int h, Rgb fill = {}) : width(w), height(h), pixels(static_cast<std::size_t>(w) * h, fill) {}
  Rgb& at(int x, int y) { return pixels[static_cast<std::size_t>(y) * width + x]; }
  const Rgb& at(int x, int y) const { return pixels[static_cast<std::size_t>(y) * width + x]; }
};

/// Blends a colour into one pixel, alpha in [0, 1]; pixels outside of the picture are ignored.
void mix(Image& image, int x, int y, Rgb colour, double alpha);

/// Returns the picture scaled down by area averaging to width x height, both clamped to the picture's size.
Image scaledDown(const Image& image, int width, int height);

/// Copies `part` into `image` with its upper left corner at (x, y), clipped to the image.
void paste(Image& image, const Image& part, int x, int y);

/// Writes a PNG file under a temporary name, then renames it. Throws std::runtime_error with file and cause.
void writePng(const Image& image, const std::filesystem::path& path);

}  // namespace thaw
