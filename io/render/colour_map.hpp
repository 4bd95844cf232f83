// Colours of numbers: maps whose lightness rises evenly with the number, so that equal steps look equal, in
// grey as well.
#pragma once
#include <array>
#include <string>
#include <string_view>

#include "io/render/image.hpp"

namespace thaw {

enum class ColourMap {
  Ember,
  Sea,
  Grey
};  ///< violet-red-orange-yellow; violet-blue-green-yellow; dark to light

/// The map of this name ("ember", "sea", "grey"); throws std::invalid_argument with the names there are.
ColourMap colourMapNamed(std::string_view name);

/// 256 colours from the lowest to the highest number.
using Palette = std::array<Rgb, 256>;
Palette paletteOf(ColourMap map);

/// How numbers become colours, the same for all pictures of a run.
struct ColourScale {
  double min = 0, max = 1;  ///< in `unit`; numbers outside get the colour of the nearer end
  ColourMap map = ColourMap::Ember;
  std::string title, unit;  ///< "temperature", "K"
};

/// Index into a palette; not-a-number gives 0.
int paletteIndex(const ColourScale& scale, double value);

}  // namespace thaw
