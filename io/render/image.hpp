// Pictures in memory and as PNG files.
#pragma once
#include <cstdint>
#include <filesystem>
#include <vector>

namespace thaw {

struct Rgb {
  std::uint8_t r = 0, g = 0, b = 0;
};
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

/// Mixes colour into one pixel, alpha in [0, 1]; outside of the picture nothing happens.
void mix(Image& image, int x, int y, Rgb colour, double alpha);

/// The picture scaled down by averaging areas, to width x height (both at most those of the picture, else
/// they are clamped).
Image scaledDown(const Image& image, int width, int height);

/// Copies `part` into `image` with its upper left corner at (x, y); what sticks out is cut off.
void paste(Image& image, const Image& part, int x, int y);

/// Writes a PNG file under a temporary name beside `path`, then renames. Throws std::runtime_error naming the
/// file and the cause.
void writePng(const Image& image, const std::filesystem::path& path);

}  // namespace thaw
