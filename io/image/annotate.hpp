// SPDX-License-Identifier: Apache-2.0
// Annotations of pictures: colour bar and caption.
#pragma once
#include <span>
#include <string>
#include <vector>

#include "io/image/colour_map.hpp"
#include "io/image/image.hpp"

namespace thaw {

/// Round numbers (steps of 1, 2 or 5 times a power of ten) within [min, max], at most about `most` of them,
/// with labels. Steps are at least `least`.
struct Ticks {
  std::vector<double> values;
  std::vector<std::string> labels;
};
Ticks ticksBetween(double min, double max, int most, double least = 0);

/// Returns the width (pixels) of a colour bar with its texts in a picture of a given height (pixels).
int colourBarWidth(const ColourScale& scale, int height);

/// Draws a vertical bar of the scale's colours at the right edge, with title, unit and tick labels. A title
/// wider than the picture is shortened.
void drawColourBar(Image& image, const ColourScale& scale);

/// Draws one line in the upper left corner: the title, shortened to fit, then the time.
void drawCaption(Image& image, const std::string& title, const std::string& time);

/// Returns pictures of one size in rows of `columns`, each with its label below, on a light background.
/// Throws std::invalid_argument if sizes differ or the number of labels is wrong.
Image contactSheet(std::span<const Image> pictures, int columns, std::span<const std::string> labels);

}  // namespace thaw
