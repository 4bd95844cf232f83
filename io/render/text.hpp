// Text in pictures, with a font of its own: 5x7 dots whose neighbours are joined by round strokes, so that it
// is smooth at any size.
#pragma once
#include <string>
#include <string_view>

#include "io/render/image.hpp"

namespace thaw {

enum class Align { Left, Centre, Right };

struct TextStyle {
  double height = 14;  ///< pixels, of a capital letter
  Rgb colour{40, 44, 52};
  Align align = Align::Left;
};

/// Width of the text in pixels. Printable ASCII; any other character (a UTF-8 sequence counts as one) shows
/// as '?'.
double textWidth(std::string_view text, double height);

/// The text where it is no wider than this (pixels), else as much of its beginning as has room with "..."
/// behind it; "" where there is none.
std::string fittedText(std::string_view text, double height, double width);

/// Draws one line of text with its baseline's left end, centre or right end at (x, y), in pixels from the
/// upper left corner.
void drawText(Image& image, double x, double y, std::string_view text, const TextStyle& style);

}  // namespace thaw
