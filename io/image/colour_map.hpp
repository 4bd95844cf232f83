// SPDX-License-Identifier: Apache-2.0
// Colour maps of uniformly increasing lightness, so equal steps look equal, also in greyscale.
#pragma once
#include <array>
#include <string>
#include <string_view>

#include "io/image/image.hpp"

namespace thaw {

enum class ColourMap {
  Ember,
  Sea,
  Grey
};  ///< violet-red-orange-yellow; violet-blue-green-yellow; dark to light

/// Returns the map of this name ("ember", "sea", "grey"). Throws std::invalid_argument with the available
/// names.
ColourMap colourMapNamed(std::string_view name);

/// 256 colours from the lowest to the highest number.
using Palette = std::array<Rgb, 256>;
Palette paletteOf(ColourMap map);

/// Mapping of numbers to colours, the same for all pictures of a run.
struct ColourScale {
  double min = 0, max = 1;  ///< in `unit`; numbers outside get the colour of the nearer end
  ColourMap map = ColourMap::Ember;
  std::string title, unit;  ///< "temperature", "K"
  bool whole = false;       ///< all values are integers, such as numbers of materials: so are the ticks
};

/// Returns an index into a palette; 0 for not-a-number.
int paletteIndex(const ColourScale& scale, double value);

}  // namespace thaw
