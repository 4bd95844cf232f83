// What is written into a picture: the colour bar and a caption.
#pragma once
#include <span>
#include <string>
#include <vector>

#include "io/render/colour_map.hpp"
#include "io/render/image.hpp"

namespace thaw {

/// Round numbers (1, 2 or 5 times a power of ten apart) within [min, max], at most about `most` of them, and
/// how to write them.
struct Ticks {
  std::vector<double> values;
  std::vector<std::string> labels;
};
Ticks ticksBetween(double min, double max, int most);

/// A vertical bar of the scale's colours at the right edge, with title, unit and tick numbers.
void drawColourBar(Image& image, const ColourScale& scale);

/// One line in the upper left corner: a title, of which there is as much as has room, and the time behind it.
void drawCaption(Image& image, const std::string& title, const std::string& time);

/// Pictures of one size in rows of `columns`, each with its label below, on a light ground. Throws
/// std::invalid_argument if sizes differ or labels are not as many as the pictures.
Image contactSheet(std::span<const Image> pictures, int columns, std::span<const std::string> labels);

}  // namespace thaw
